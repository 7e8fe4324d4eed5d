// SPDX-License-Identifier: MIT
#include "core/cloud/UnitCheck.h"

#include <cstdio>

#include "core/cloud/VoxelGrid.h"
#include "core/common/Error.h"

namespace fodscope {
namespace {

void requireMetres(std::span<const Eigen::Vector3d> points, const std::string& subject, const std::string& remedy) {
    if (points.empty()) return;
    const double extent = (maximumCorner(points) - minimumCorner(points)).maxCoeff();
    if (extent <= kLargestExtent_m) return;
    char problem[160];
    std::snprintf(problem, sizeof(problem), "is %.4g m long if its unit is metres; it seems to be in millimetres",
                  extent);
    throw Error(subject, problem, remedy);
}

}  // namespace

void requireUsableCloud(std::span<const Eigen::Vector3d> points, const std::string& subject) {
    if (points.size() < kFewestPoints) {
        throw Error(subject,
                    "holds only " + std::to_string(points.size()) + (points.size() == 1 ? " point" : " points") +
                        ", too few to compare",
                    "give a point cloud of the whole space");
    }
    requireMetres(points, subject, "give the cloud in metres (scale it by 0.001)");
}

void requireMetres(const TriangleMesh& mesh, const std::string& subject) {
    requireMetres(mesh.vertices, subject, "give the mesh in metres, or its scale (0.001 for millimetres)");
}

}  // namespace fodscope
