// SPDX-License-Identifier: MIT
#include <bit>
#include <charconv>
#include <limits>

#include "core/cloud/Lzf.h"
#include "core/cloud/Pcd.h"
#include "core/cloud/ScalarType.h"
#include "core/cloud/TextScanner.h"
#include "core/common/Error.h"

namespace fodscope {
namespace {

std::uint32_t packed(const Rgb& colour) {
    return static_cast<std::uint32_t>(colour.red) << 16 | static_cast<std::uint32_t>(colour.green) << 8 | colour.blue;
}

std::string headerOf(const PointCloud& cloud, PcdEncoding encoding) {
    const std::string count = std::to_string(cloud.size());
    const bool coloured = !cloud.colours.empty();
    const std::string colourType = encoding == PcdEncoding::Ascii ? " U" : " F";
    const std::string data = encoding == PcdEncoding::Ascii    ? "ascii"
                             : encoding == PcdEncoding::Binary ? "binary"
                                                               : "binary_compressed";
    return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z" +
           std::string(coloured ? " rgb" : "") + "\nSIZE 4 4 4" + (coloured ? " 4" : "") + "\nTYPE F F F" +
           (coloured ? colourType : "") + "\nCOUNT 1 1 1" + (coloured ? " 1" : "") + "\nWIDTH " + count +
           "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA " + data + "\n";
}

/// The shortest text that reads back to the same float.
void appendText(std::string& text, float value) {
    char buffer[64];
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof(buffer), value);
    (void)error;
    text.append(buffer, end);
}

std::string asciiData(const PointCloud& cloud) {
    std::string text;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            if (axis > 0) text += ' ';
            appendText(text, static_cast<float>(cloud.points[i][axis]));
        }
        if (!cloud.colours.empty()) text += ' ' + std::to_string(packed(cloud.colours[i]));
        text += '\n';
    }
    return text;
}

std::string binaryData(const PointCloud& cloud) {
    std::string bytes;
    bytes.reserve(cloud.size() * (cloud.colours.empty() ? 12 : 16));
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis)
            appendNumber(bytes, static_cast<float>(cloud.points[i][axis]));
        if (!cloud.colours.empty()) appendNumber(bytes, packed(cloud.colours[i]));
    }
    return bytes;
}

std::string compressedData(const PointCloud& cloud) {
    std::string fields;
    fields.reserve(cloud.size() * (cloud.colours.empty() ? 12 : 16));
    for (int axis = 0; axis < 3; ++axis) {
        for (const Eigen::Vector3d& point : cloud.points)
            appendNumber(fields, static_cast<float>(point[axis]));
    }
    for (const Rgb& colour : cloud.colours)
        appendNumber(fields, packed(colour));
    const std::vector<std::byte> compressed = lzfCompress(std::as_bytes(std::span(fields)));
    if (fields.size() > std::numeric_limits<std::uint32_t>::max() ||
        compressed.size() > std::numeric_limits<std::uint32_t>::max()) {
        throw Error("point cloud", "it is too large for a compressed PCD file", "write it as PLY");
    }
    std::string bytes;
    appendNumber(bytes, static_cast<std::uint32_t>(compressed.size()));
    appendNumber(bytes, static_cast<std::uint32_t>(fields.size()));
    bytes += textOf(compressed);
    return bytes;
}

}  // namespace

std::string pcdBytes(const PointCloud& cloud, PcdEncoding encoding) {
    const std::string header = headerOf(cloud, encoding);
    switch (encoding) {
        case PcdEncoding::Ascii:
            return header + asciiData(cloud);
        case PcdEncoding::Binary:
            return header + binaryData(cloud);
        case PcdEncoding::BinaryCompressed:
            break;
    }
    return header + compressedData(cloud);
}

}  // namespace fodscope
