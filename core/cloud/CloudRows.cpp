// SPDX-License-Identifier: MIT
#include "core/cloud/CloudRows.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace fodscope {
namespace {

bool hasPlainFloats(const CloudRows& rows) {
    return rows.order == std::endian::native &&
           std::ranges::all_of(rows.axes, [](const RowField& axis) { return axis.type == ScalarType::Float32; });
}

double plainFloat(const std::byte* bytes) {
    float value = 0.0f;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
}

std::optional<Rgb> colourIn(const CloudRows& rows, const std::byte* row) {
    if (rows.packedColourOffset) return colourFrom(loadNumber<std::uint32_t>(row + *rows.packedColourOffset));
    if (!rows.channels) return std::nullopt;
    std::array<std::uint8_t, 3> bytes{};
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const auto [offset, type] = (*rows.channels)[i];
        bytes[i] = type == ScalarType::UInt8 ? std::to_integer<std::uint8_t>(row[offset])
                                             : colourByte(loadScalar(row + offset, type, rows.order), type);
    }
    return Rgb{bytes[0], bytes[1], bytes[2]};
}

template <class LoadAxis>
void appendRowsWith(const CloudRows& rows, std::span<const std::byte> bytes, PointCloud& cloud,
                    const LoadAxis& loadAxis) {
    for (const std::byte* row = bytes.data(); row != bytes.data() + bytes.size(); row += rows.stride) {
        const Eigen::Vector3d point(loadAxis(row, rows.axes[0]), loadAxis(row, rows.axes[1]),
                                    loadAxis(row, rows.axes[2]));
        appendPoint(cloud, point, colourIn(rows, row));
    }
}

}  // namespace

Rgb colourFrom(std::uint32_t packed) {
    return {static_cast<std::uint8_t>(packed >> 16), static_cast<std::uint8_t>(packed >> 8),
            static_cast<std::uint8_t>(packed)};
}

std::uint8_t colourByte(double value, ScalarType type) {
    const double scaled = value * (isFloating(type) ? 255.0 : 1.0);
    return scaled >= 0.0 ? static_cast<std::uint8_t>(std::lround(std::min(scaled, 255.0))) : std::uint8_t{0};
}

bool appendRows(ByteWindow& window, const CloudRows& rows, PointCloud& cloud) {
    for (std::uint64_t left = rows.count; left > 0;) {
        const std::span<const std::byte> bytes = window.ahead(rows.stride);
        const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(left, bytes.size() / rows.stride));
        if (count == 0) return false;
        const std::span<const std::byte> whole = bytes.first(count * rows.stride);
        if (hasPlainFloats(rows)) {
            appendRowsWith(rows, whole, cloud,
                           [](const std::byte* row, const RowField& axis) { return plainFloat(row + axis.offset); });
        } else {
            appendRowsWith(rows, whole, cloud, [&](const std::byte* row, const RowField& axis) {
                return loadScalar(row + axis.offset, axis.type, rows.order);
            });
        }
        window.skip(whole.size());
        left -= count;
    }
    return true;
}

}  // namespace fodscope
