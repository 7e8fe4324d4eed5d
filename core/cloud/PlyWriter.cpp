// SPDX-License-Identifier: MIT
#include <algorithm>

#include "core/cloud/Ply.h"
#include "core/common/Files.h"

namespace fodscope {
namespace {

const char* nameOf(ScalarType type) {
    switch (type) {
        case ScalarType::Int8:
            return "char";
        case ScalarType::UInt8:
            return "uchar";
        case ScalarType::Int16:
            return "short";
        case ScalarType::UInt16:
            return "ushort";
        case ScalarType::Int32:
            return "int";
        case ScalarType::UInt32:
            return "uint";
        case ScalarType::Float32:
            return "float";
        default:
            return "double";
    }
}

/// A comment is one line; a line end within it would start a header line of its own.
std::string oneLine(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return text;
}

}  // namespace

void writePly(const std::filesystem::path& file, std::span<const std::string> comments,
              std::span<const PlyColumn> columns, std::span<const std::array<std::uint32_t, 3>> triangles) {
    const std::size_t count = columns.empty() ? 0 : columns.front().values.size();
    std::string bytes = "ply\nformat binary_little_endian 1.0\n";
    for (const std::string& comment : comments)
        bytes += "comment " + oneLine(comment) + "\n";
    bytes += "element vertex " + std::to_string(count) + "\n";
    for (const PlyColumn& column : columns)
        bytes += std::string("property ") + nameOf(column.type) + " " + column.name + "\n";
    if (!triangles.empty()) {
        bytes += "element face " + std::to_string(triangles.size()) + "\nproperty list uchar int vertex_indices\n";
    }
    bytes += "end_header\n";
    std::size_t rowBytes = 0;
    for (const PlyColumn& column : columns)
        rowBytes += sizeOf(column.type);
    bytes.reserve(bytes.size() + count * rowBytes + triangles.size() * (1 + 3 * sizeof(std::int32_t)));
    for (std::size_t row = 0; row < count; ++row) {
        for (const PlyColumn& column : columns)
            appendScalar(bytes, column.values[row], column.type);
    }
    for (const auto& triangle : triangles) {
        appendNumber(bytes, std::uint8_t{3});
        for (const std::uint32_t index : triangle)
            appendNumber(bytes, static_cast<std::int32_t>(index));
    }
    writeFile(file, bytes);
}

}  // namespace fodscope
