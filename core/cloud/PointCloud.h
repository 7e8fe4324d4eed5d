// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fodscope {

struct Rgb {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;

    bool operator==(const Rgb&) const = default;
};

/// Points in metres, in the frame that the variable's name tells. All coordinates are finite: readers drop the others
/// and count them.
struct PointCloud {
    std::vector<Eigen::Vector3d> points;
    /// Empty, or one for each point.
    std::vector<Rgb> colours;
    /// Points that the file held and that were dropped because a coordinate was NaN or infinite.
    std::size_t droppedNonFinite = 0;

    std::size_t size() const { return points.size(); }
    bool empty() const { return points.empty(); }
};

/// Voxel means with the number of points behind each, in lexicographic order of the voxel index (x, then y, then z).
struct VoxelCloud {
    std::vector<Eigen::Vector3d> points;
    std::vector<std::uint32_t> weights;

    std::size_t size() const { return points.size(); }
};

}  // namespace fodscope
