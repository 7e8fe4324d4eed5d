// SPDX-License-Identifier: MIT
#include "core/registration/SurfacePatches.h"

#include <pcl/common/centroid.h>
#include <pcl/common/eigen.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/cloud/VoxelGrid.h"
#include "core/registration/OrderedSum.h"

namespace fodscope {
namespace {

/// Neighbours farther off than this many voxels belong to another surface.
constexpr double kReach_voxels = 3.0;
/// Round the edge of two equal surfaces at a right angle the least spread (squared) is a quarter of the middle one.
constexpr double kEdgeRatio = 4.0;
constexpr double kLeastPlanarity = 0.3;

/// Floats suffice for PCL's points because they are near the origin, wherever the cloud lies.
pcl::PointCloud<pcl::PointXYZ> pclPoints(std::span<const Eigen::Vector3d> points, const Eigen::Vector3d& origin) {
    pcl::PointCloud<pcl::PointXYZ> cloud;
    cloud.reserve(points.size());
    for (const Eigen::Vector3d& point : points) {
        const Eigen::Vector3f local = (point - origin).cast<float>();
        cloud.emplace_back(local.x(), local.y(), local.z());
    }
    return cloud;
}

/// The plane through the neighbours that are within reach, from PCL's covariance and eigenvectors in double.
SurfacePatch patchAt(std::size_t place, const NeighbourGraph& graph, const pcl::PointCloud<pcl::PointXYZ>& points,
                     const Eigen::Vector3d& origin, double reach_m) {
    const Eigen::Vector3d& centre = graph.points()[place];
    // Round a voxel on a plane lie eight others; some more bridge the gaps of a sparse map.
    pcl::Indices near{static_cast<pcl::index_t>(place)};
    for (const std::uint32_t other : graph.linksOf(place)) {
        if ((graph.points()[other] - centre).squaredNorm() > reach_m * reach_m) break;
        near.push_back(static_cast<pcl::index_t>(other));
    }
    SurfacePatch patch;
    patch.centre = centre;
    if (near.size() < 4) return patch;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    Eigen::Vector4d mean = Eigen::Vector4d::Zero();
    pcl::computeMeanAndCovarianceMatrix(points, near, covariance, mean);
    Eigen::Matrix3d directions;
    Eigen::Vector3d spread;
    pcl::eigen33(covariance, directions, spread);
    if (!(spread[1] > 0.0)) return patch;
    patch.normal = directions.col(0).normalized();
    // The voxel's own mean may lie off the plane by its noise; the plane through all is steadier.
    const Eigen::Vector3d middle = origin + mean.head<3>();
    patch.centre = centre - patch.normal * patch.normal.dot(centre - middle);
    patch.planarity = std::clamp(1.0 - kEdgeRatio * spread[0] / spread[1], 0.0, 1.0);
    return patch;
}

/// Level surfaces, and six sectors each of upright and of sloping ones; opposite normals share a sector.
constexpr std::size_t kSectors = 6;
constexpr std::size_t kDirections = 1 + 2 * kSectors;

std::size_t directionOf(const Eigen::Vector3d& normal) {
    const double up = std::abs(normal.z());
    if (up > 0.9) return 0;
    double angle_rad = std::atan2(normal.y(), normal.x());
    if (angle_rad < 0.0) angle_rad += std::numbers::pi;
    const auto sector =
        std::min(static_cast<std::size_t>(angle_rad / std::numbers::pi * static_cast<double>(kSectors)), kSectors - 1);
    return 1 + sector + (up > 0.45 ? kSectors : 0);
}

}  // namespace

std::vector<Eigen::Vector3d> voxelMeans(std::span<const Eigen::Vector3d> points, double voxelSize_m) {
    const Eigen::Vector3d origin = minimumCorner(points) - Eigen::Vector3d::Constant(voxelSize_m / 2.0);
    return voxelGrid(points, origin, {voxelSize_m}).points;
}

SurfacePatches::SurfacePatches(std::span<const Eigen::Vector3d> points, double voxelSize_m, Progress& progress)
    : voxelSize_m_(voxelSize_m),
      places_(voxelMeans(points, voxelSize_m)),
      graph_(places_, progress),
      patches_(places_.size()) {
    const Eigen::Vector3d origin = 0.5 * (minimumCorner(places_) + maximumCorner(places_));
    const pcl::PointCloud<pcl::PointXYZ> cloud = pclPoints(places_, origin);
    forEachPart(places_.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
        progress.throwIfCancelled();
        for (std::size_t i = begin; i < end; ++i)
            patches_[i] = patchAt(i, graph_, cloud, origin, kReach_voxels * voxelSize_m_);
    });
}

std::vector<std::uint32_t> SurfacePatches::balancedSample(std::size_t count) const {
    std::array<std::vector<std::uint32_t>, kDirections> byDirection;
    for (std::uint32_t i = 0; i < patches_.size(); ++i) {
        if (patches_[i].planarity >= kLeastPlanarity) byDirection[directionOf(patches_[i].normal)].push_back(i);
    }
    // Directions with few patches give all they have; the others share the rest.
    std::array<std::size_t, kDirections> order;
    for (std::size_t i = 0; i < kDirections; ++i)
        order[i] = i;
    std::ranges::stable_sort(
        order, [&](std::size_t a, std::size_t b) { return byDirection[a].size() < byDirection[b].size(); });
    std::vector<std::uint32_t> sample;
    for (std::size_t i = 0; i < kDirections; ++i) {
        const std::vector<std::uint32_t>& patches = byDirection[order[i]];
        const std::size_t left = count > sample.size() ? count - sample.size() : 0;
        const std::size_t quota = std::min(patches.size(), left / (kDirections - i));
        for (std::size_t k = 0; k < quota; ++k)
            sample.push_back(patches[k * patches.size() / quota]);
    }
    std::ranges::sort(sample);
    return sample;
}

}  // namespace fodscope
