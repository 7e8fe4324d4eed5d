// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "core/cloud/ByteWindow.h"
#include "core/cloud/PointCloud.h"
#include "core/cloud/ScalarType.h"

namespace fodscope {

/// A number in every row, `offset` bytes after the row's begin.
struct RowField {
    std::size_t offset = 0;
    ScalarType type = ScalarType::Float32;
};

/// Rows of equal length in which binary files hold a point each.
struct CloudRows {
    std::uint64_t count = 0;
    std::size_t stride = 0;
    std::endian order = std::endian::little;
    std::array<RowField, 3> axes;
    /// At most one of these.
    std::optional<std::size_t> packedColourOffset;
    std::optional<std::array<RowField, 3>> channels;
};

/// A colour packed as 0x00RRGGBB.
Rgb colourFrom(std::uint32_t packed);

/// One of red, green and blue: integers run to 255, floating numbers to 1.
std::uint8_t colourByte(double value, ScalarType type);

/// Appends the points with finite coordinates and counts the others.
/// @return whether there were as many rows as announced
bool appendRows(ByteWindow& window, const CloudRows& rows, PointCloud& cloud);

/// Appends one point, or counts it when a coordinate is not finite.
inline void appendPoint(PointCloud& cloud, const Eigen::Vector3d& point, const std::optional<Rgb>& colour) {
    if (!point.allFinite()) {
        ++cloud.droppedNonFinite;
        return;
    }
    cloud.points.push_back(point);
    if (colour) cloud.colours.push_back(*colour);
}

}  // namespace fodscope
