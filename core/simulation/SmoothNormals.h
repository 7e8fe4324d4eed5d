// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/cloud/TriangleMesh.h"

namespace fodscope {

/// Normals at the three corners of every triangle. Triangles that meet at less than `crease_rad` are shaded as one
/// round surface, also where they share positions but no vertices (STL and exported PLY).
std::vector<std::array<Eigen::Vector3f, 3>> smoothNormals(const TriangleMesh& mesh, double crease_rad = 0.6);

}  // namespace fodscope
