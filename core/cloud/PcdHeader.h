// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/cloud/PointCloudIo.h"
#include "core/cloud/ScalarType.h"

namespace fodscope {

struct PcdField {
    std::string name;
    ScalarType type = ScalarType::Float32;
    std::uint64_t count = 1;
    /// Bytes, and numbers, of a point before this field.
    std::size_t offset = 0;
    std::size_t column = 0;
};

struct PcdHeader {
    std::vector<PcdField> fields;
    std::uint64_t points = 0;
    PcdEncoding encoding = PcdEncoding::Ascii;
    /// Of one point, in bytes and in numbers.
    std::size_t stride = 0;
    std::size_t columns = 0;
    /// Where the data begins.
    std::size_t dataOffset = 0;

    /// @return null when there is no such field
    const PcdField* field(std::string_view name) const;
};

/// @throws Error when the header is malformed or has no end
PcdHeader parsePcdHeader(std::span<const std::byte> bytes, const std::string& subject);

}  // namespace fodscope
