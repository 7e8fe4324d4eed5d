// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/cloud/ScalarType.h"

namespace fodscope {

/// One scalar property of the vertices of a PLY file, a value for each vertex. A double holds every 32-bit value.
struct PlyColumn {
    std::string name;
    ScalarType type = ScalarType::Float32;
    std::vector<double> values;
};

/// What Fodscope takes from a PLY file: comments, the scalar properties of the vertices, and the faces.
struct PlyContents {
    std::vector<std::string> comments;
    std::size_t vertexCount = 0;
    std::vector<PlyColumn> columns;
    /// What the header announces, also when the faces were not read.
    std::size_t faceCount = 0;
    /// Corners of each face, and the vertex indices of all faces one after the other (not checked against vertexCount).
    std::vector<std::uint32_t> faceSizes;
    std::vector<std::int64_t> faceIndices;

    /// @return null when there is no such property
    const PlyColumn* column(std::string_view name) const;
};

enum class PlyFaces { Ignore, Read };

/// @return whether the bytes begin as a PLY file does
bool isPly(std::span<const std::byte> bytes);

/// Source: G. Turk, "The PLY Polygon File Format". Ascii and binary of either byte order.
/// @param subject the file's name, for errors
/// @throws Error when the header is malformed or the data is shorter than the header says, before allocating for it
PlyContents parsePly(std::span<const std::byte> bytes, const std::string& subject, PlyFaces faces);

/// Writes binary little endian. All columns must have the same length.
/// @throws Error when the file cannot be written
void writePly(const std::filesystem::path& file, std::span<const std::string> comments,
              std::span<const PlyColumn> columns, std::span<const std::array<std::uint32_t, 3>> triangles = {});

}  // namespace fodscope
