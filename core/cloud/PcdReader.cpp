// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <optional>
#include <string>

#include "core/cloud/CloudRows.h"
#include "core/cloud/Pcd.h"
#include "core/cloud/PcdFields.h"
#include "core/cloud/TextScanner.h"

namespace fodscope {
namespace {

PcdUsedFields usedFields(const PcdHeader& header, const std::string& subject) {
    PcdUsedFields used{{header.field("x"), header.field("y"), header.field("z")}, header.field("rgb")};
    for (const PcdField* axis : used.axes) {
        if (axis == nullptr) throw Error(subject, "has no fields x, y and z", "give a point cloud with coordinates");
    }
    if (used.colour == nullptr) used.colour = header.field("rgba");
    // Packed colours have four bytes; other types do not say how they are meant.
    if (used.colour != nullptr && sizeOf(used.colour->type) != 4) used.colour = nullptr;
    return used;
}

double numberIn(std::string_view word, const std::string& subject) {
    const std::optional<double> value = numberFrom(word);
    if (!value) {
        throw Error(subject, "\"" + std::string(word.substr(0, 40)) + "\" in its data is not a number",
                    "export the file anew");
    }
    return *value;
}

/// A field of type F holds the bits of a packed colour as a float.
Rgb colourFromText(double value, ScalarType type) {
    if (isFloating(type)) return colourFrom(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
    const bool isWhole = value >= 0.0 && value < 4294967296.0;
    return colourFrom(isWhole ? static_cast<std::uint32_t>(value) : 0u);
}

PointCloud readAscii(ByteWindow& window, const PcdHeader& header, const PcdUsedFields& used,
                     const std::string& subject) {
    // Each number takes a digit and a blank or line end; the last line may lack its end.
    if (header.points > (window.remaining() + 1) / (2 * header.columns)) throw truncatedPcd(subject, header);
    PointCloud cloud = roomFor(header, used);
    std::vector<std::string_view> row(header.columns);
    for (std::uint64_t i = 0; i < header.points; ++i) {
        nextWords(window, row);
        if (row.back().empty()) throw truncatedPcd(subject, header);
        Eigen::Vector3d point;
        for (int axis = 0; axis < 3; ++axis) {
            const PcdField& field = *used.axes[static_cast<std::size_t>(axis)];
            point[axis] = asStored(numberIn(row[field.column], subject), field.type);
        }
        std::optional<Rgb> colour;
        if (used.colour != nullptr)
            colour = colourFromText(numberIn(row[used.colour->column], subject), used.colour->type);
        appendPoint(cloud, point, colour);
    }
    return cloud;
}

PointCloud readBinary(ByteWindow& window, const PcdHeader& header, const PcdUsedFields& used,
                      const std::string& subject) {
    if (header.points > window.remaining() / header.stride) throw truncatedPcd(subject, header);
    CloudRows rows;
    rows.count = header.points;
    rows.stride = header.stride;
    for (std::size_t axis = 0; axis < 3; ++axis)
        rows.axes[axis] = {used.axes[axis]->offset, used.axes[axis]->type};
    if (used.colour != nullptr) rows.packedColourOffset = used.colour->offset;
    PointCloud cloud = roomFor(header, used);
    if (!appendRows(window, rows, cloud)) throw truncatedPcd(subject, header);
    return cloud;
}

}  // namespace

Error truncatedPcd(const std::string& subject, const PcdHeader& header) {
    return Error(subject,
                 "is truncated: its header announces " + std::to_string(header.points) +
                     " points, the file is too short for them",
                 "copy or export the file anew");
}

PointCloud roomFor(const PcdHeader& header, const PcdUsedFields& used) {
    PointCloud cloud;
    cloud.points.reserve(header.points);
    if (used.colour != nullptr) cloud.colours.reserve(header.points);
    return cloud;
}

bool isPcd(std::span<const std::byte> bytes) {
    // Comments may come first; the format itself begins with one of these lines.
    TextScanner lines(textOf(bytes.first(std::min<std::size_t>(bytes.size(), 1 << 16))));
    while (!lines.atEnd()) {
        TextScanner words(lines.line());
        const std::string_view key = words.word();
        if (key.empty() || key.front() == '#') continue;
        return key == "VERSION" || key == "FIELDS" || key == "COLUMNS";
    }
    return false;
}

PointCloud readPcd(ByteWindow& window, const std::string& subject) {
    const PcdHeader header = parsePcdHeader(aheadWithLine(window, "DATA"), subject);
    const PcdUsedFields used = usedFields(header, subject);
    window.skip(header.dataOffset);
    switch (header.encoding) {
        case PcdEncoding::Ascii:
            return readAscii(window, header, used, subject);
        case PcdEncoding::Binary:
            return readBinary(window, header, used, subject);
        case PcdEncoding::BinaryCompressed:
            break;
    }
    return readCompressedPcd(window, header, used, subject);
}

}  // namespace fodscope
