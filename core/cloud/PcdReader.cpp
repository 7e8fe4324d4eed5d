// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <string>

#include "core/cloud/Lzf.h"
#include "core/cloud/Pcd.h"
#include "core/cloud/PcdHeader.h"
#include "core/cloud/TextScanner.h"
#include "core/common/Error.h"

namespace fodscope {
namespace {

Error truncated(const std::string& subject, const PcdHeader& header) {
    return Error(subject,
                 "is truncated: its header announces " + std::to_string(header.points) +
                     " points, the file is too short for them",
                 "copy or export the file anew");
}

/// The fields that Fodscope uses.
struct UsedFields {
    std::array<const PcdField*, 3> axes{};
    /// Null: no colour.
    const PcdField* colour = nullptr;
};

UsedFields usedFields(const PcdHeader& header, const std::string& subject) {
    UsedFields used{{header.field("x"), header.field("y"), header.field("z")}, header.field("rgb")};
    for (const PcdField* axis : used.axes) {
        if (axis == nullptr) throw Error(subject, "has no fields x, y and z", "give a point cloud with coordinates");
    }
    if (used.colour == nullptr) used.colour = header.field("rgba");
    // Packed colours have four bytes; other types do not say how they are meant.
    if (used.colour != nullptr && sizeOf(used.colour->type) != 4) used.colour = nullptr;
    return used;
}

/// A colour is 0x00RRGGBB; a field of type F holds these bits as a float.
Rgb colourFrom(std::uint32_t packed) {
    return {static_cast<std::uint8_t>(packed >> 16), static_cast<std::uint8_t>(packed >> 8),
            static_cast<std::uint8_t>(packed)};
}

void append(PointCloud& cloud, const Eigen::Vector3d& point, std::optional<std::uint32_t> colour) {
    if (!point.allFinite()) {
        ++cloud.droppedNonFinite;
        return;
    }
    cloud.points.push_back(point);
    if (colour) cloud.colours.push_back(colourFrom(*colour));
}

void reserve(PointCloud& cloud, const PcdHeader& header, const UsedFields& used) {
    cloud.points.reserve(header.points);
    if (used.colour != nullptr) cloud.colours.reserve(header.points);
}

PointCloud readAscii(std::span<const std::byte> bytes, const PcdHeader& header, const UsedFields& used,
                     const std::string& subject) {
    // Each number takes a digit and a blank or line end; the last line may lack its end.
    const std::uint64_t available = bytes.size() - header.dataOffset + 1;
    if (header.points > available / (2 * header.columns)) throw truncated(subject, header);
    PointCloud cloud;
    reserve(cloud, header, used);
    TextScanner words(textOf(bytes), header.dataOffset);
    std::vector<std::string_view> row(header.columns);
    const auto number = [&](std::string_view word) {
        const std::optional<double> value = numberFrom(word);
        if (!value) {
            throw Error(subject, "\"" + std::string(word.substr(0, 40)) + "\" in its data is not a number",
                        "export the file anew");
        }
        return *value;
    };
    for (std::uint64_t i = 0; i < header.points; ++i) {
        for (std::string_view& word : row)
            word = words.word();
        if (row.back().empty()) throw truncated(subject, header);
        Eigen::Vector3d point;
        for (int axis = 0; axis < 3; ++axis) {
            const PcdField& field = *used.axes[static_cast<std::size_t>(axis)];
            point[axis] = asStored(number(row[field.column]), field.type);
        }
        std::optional<std::uint32_t> colour;
        if (used.colour != nullptr) {
            const double value = number(row[used.colour->column]);
            const bool isWhole = value >= 0.0 && value < 4294967296.0;
            if (isFloating(used.colour->type)) {
                colour = std::bit_cast<std::uint32_t>(static_cast<float>(value));
            } else {
                colour = isWhole ? static_cast<std::uint32_t>(value) : 0u;
            }
        }
        append(cloud, point, colour);
    }
    return cloud;
}

/// @param address where the bytes of a field of a point are
template <class Address>
PointCloud gather(const PcdHeader& header, const UsedFields& used, const Address& address) {
    PointCloud cloud;
    reserve(cloud, header, used);
    for (std::uint64_t i = 0; i < header.points; ++i) {
        Eigen::Vector3d point;
        for (int axis = 0; axis < 3; ++axis) {
            const PcdField& field = *used.axes[static_cast<std::size_t>(axis)];
            point[axis] = loadScalar(address(field, i), field.type, std::endian::little);
        }
        std::optional<std::uint32_t> colour;
        if (used.colour != nullptr) colour = loadNumber<std::uint32_t>(address(*used.colour, i));
        append(cloud, point, colour);
    }
    return cloud;
}

PointCloud readBinary(std::span<const std::byte> bytes, const PcdHeader& header, const UsedFields& used,
                      const std::string& subject) {
    const std::span<const std::byte> data = bytes.subspan(header.dataOffset);
    if (header.points > data.size() / header.stride) throw truncated(subject, header);
    return gather(header, used, [&](const PcdField& field, std::uint64_t i) {
        return data.data() + i * header.stride + field.offset;
    });
}

/// The data is compressed as a whole and holds one field after the other, each for all points.
PointCloud readCompressed(std::span<const std::byte> bytes, const PcdHeader& header, const UsedFields& used,
                          const std::string& subject) {
    const std::span<const std::byte> data = bytes.subspan(header.dataOffset);
    if (data.size() < 8) throw truncated(subject, header);
    const std::size_t compressedSize = loadNumber<std::uint32_t>(data.data());
    const std::size_t size = loadNumber<std::uint32_t>(data.data() + 4);
    if (compressedSize > data.size() - 8) throw truncated(subject, header);
    if (size != header.points * header.stride || size > compressedSize * kLzfLargestExpansion) {
        throw Error(subject, "the size of its compressed data does not agree with its header",
                    "copy or export the file anew");
    }
    std::vector<std::byte> fields(size);
    if (!lzfDecompress(data.subspan(8, compressedSize), fields)) {
        throw Error(subject, "its compressed data is damaged", "copy or export the file anew");
    }
    return gather(header, used, [&](const PcdField& field, std::uint64_t i) {
        return fields.data() + header.points * field.offset + i * field.count * sizeOf(field.type);
    });
}

}  // namespace

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

PointCloud parsePcd(std::span<const std::byte> bytes, const std::string& subject) {
    const PcdHeader header = parsePcdHeader(bytes, subject);
    const UsedFields used = usedFields(header, subject);
    switch (header.encoding) {
        case PcdEncoding::Ascii:
            return readAscii(bytes, header, used, subject);
        case PcdEncoding::Binary:
            return readBinary(bytes, header, used, subject);
        case PcdEncoding::BinaryCompressed:
            break;
    }
    return readCompressed(bytes, header, used, subject);
}

}  // namespace fodscope
