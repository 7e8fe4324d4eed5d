// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/cloud/ScalarType.h"

namespace fodscope {

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };

struct PlyProperty {
    std::string name;
    ScalarType type = ScalarType::Float32;
    bool isList = false;
    /// Of a list: type of the number of entries.
    ScalarType countType = ScalarType::UInt8;
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::Ascii;
    std::vector<std::string> comments;
    std::vector<PlyElement> elements;
    /// Where the data begins.
    std::size_t dataOffset = 0;
};

/// @throws Error when the header is malformed or has no end
PlyHeader parsePlyHeader(std::span<const std::byte> bytes, const std::string& subject);

}  // namespace fodscope
