// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "core/cloud/PointCloud.h"

namespace fodscope {

/// Triangles over shared vertices, in metres. Every index is smaller than vertices.size().
struct TriangleMesh {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    /// Empty, or one for each vertex.
    std::vector<Rgb> colours;
};

}  // namespace fodscope
