// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/cloud/PointCloud.h"

namespace fodscope {

/// Voxel means of a map that grows frame by frame, with what the returns in each voxel came from.
class MapVoxels {
  public:
    struct Voxel {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        Eigen::Vector3d colourSum = Eigen::Vector3d::Zero();
        std::uint32_t count = 0;
        /// Majority vote (Boyer and Moore): the object that most returns are of, if one has more than half.
        std::int32_t object = -1;
        std::uint32_t votes = 0;

        Eigen::Vector3d mean() const { return sum / count; }
        Rgb colour() const;
    };

    explicit MapVoxels(double size_m) : size_m_(size_m) {}

    /// Points more than a million voxels out are left out.
    void add(const Eigen::Vector3d& point, Rgb colour, std::int32_t object);

    /// @return the voxels in lexicographic order of their place (x, then y, then z)
    std::vector<Voxel> sorted() const;

  private:
    double size_m_;
    std::unordered_map<std::uint64_t, std::uint32_t> places_;
    std::vector<Voxel> voxels_;
};

}  // namespace fodscope
