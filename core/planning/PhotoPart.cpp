// SPDX-License-Identifier: MIT
#include "core/planning/PhotoPart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/common/ConvexHull.h"

namespace fodscope {
namespace {

/// Parts shorter than this are not divided: half a tool is hard to name.
constexpr double kLeastLength_m = 0.3;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

double leastExtent(const std::vector<Eigen::Vector2d>& hull) {
    double least_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Eigen::Vector2d side = (hull[(i + 1) % hull.size()] - hull[i]).normalized();
        least_m = std::min(least_m, extentAlong(hull, {-side.y(), side.x()}));
    }
    return hull.size() < 3 ? 0.0 : least_m;
}

/// Voxels that fill the box of a target of which only the size is known.
std::vector<Eigen::Vector3d> boxVoxels(const PlanTarget& target, double edge_m) {
    const Eigen::Vector2d along(std::cos(target.lengthDirection_rad), std::sin(target.lengthDirection_rad));
    const Eigen::Vector2d across(-along.y(), along.x());
    const Eigen::Vector3d reach = 0.5 * (target.size_m.array() - edge_m).max(0.0).matrix();
    const auto steps = [&](double reach_m) { return static_cast<int>(std::ceil(std::min(reach_m / edge_m, 200.0))); };
    const auto at = [](int step, int count, double reach_m) { return count == 0 ? 0.0 : reach_m * step / count; };
    std::vector<Eigen::Vector3d> voxels;
    const int lengthSteps = steps(reach.x()), widthSteps = steps(reach.y());
    for (int i = -lengthSteps; i <= lengthSteps; ++i) {
        for (int j = -widthSteps; j <= widthSteps; ++j) {
            const Eigen::Vector2d plan = target.centroid_map.head<2>() + at(i, lengthSteps, reach.x()) * along +
                                         at(j, widthSteps, reach.y()) * across;
            for (const double height_m : {-reach.z(), 0.0, reach.z()})
                voxels.emplace_back(plan.x(), plan.y(), target.centroid_map.z() + height_m);
        }
    }
    return voxels;
}

/// Fills in what follows from the voxels.
void measure(PhotoPart& part) {
    const double half_m = 0.5 * part.voxelSize_m;
    std::vector<Eigen::Vector2d> plan;
    double low_m = std::numeric_limits<double>::infinity();
    double high_m = -low_m;
    for (const Eigen::Vector3d& voxel : part.voxels) {
        plan.emplace_back(voxel.head<2>());
        low_m = std::min(low_m, voxel.z());
        high_m = std::max(high_m, voxel.z());
    }
    std::vector<Eigen::Vector2d> corners;
    for (const Eigen::Vector2d& corner : convexHull(std::move(plan))) {
        for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
            corners.emplace_back(corner + half_m * Eigen::Vector2d(x, y));
    }
    part.footprint_map = convexHull(std::move(corners));
    part.width_m = leastExtent(part.footprint_map);
    // Nothing lies under the floor; a voxel's lower half may.
    part.low_m = std::max(0.0, low_m - half_m);
    part.high_m = std::max(part.low_m, high_m + half_m);
}

Eigen::Vector3d meanOf(const std::vector<Eigen::Vector3d>& points) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : points)
        sum += point;
    return sum / static_cast<double>(points.size());
}

/// The direction in the plane along which the voxels scatter most.
Eigen::Vector2d longAxis(const std::vector<Eigen::Vector3d>& voxels) {
    const Eigen::Vector3d mean = meanOf(voxels);
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (const Eigen::Vector3d& voxel : voxels) {
        const Eigen::Vector3d d = voxel - mean;
        xx += d.x() * d.x();
        xy += d.x() * d.y();
        yy += d.y() * d.y();
    }
    const double angle_rad = 0.5 * std::atan2(2.0 * xy, xx - yy);
    return {std::cos(angle_rad), std::sin(angle_rad)};
}

Eigen::Vector2d nearestOnEdge(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& point) {
    const Eigen::Vector2d edge = b - a;
    const double length2 = edge.squaredNorm();
    return a + (length2 > 0.0 ? std::clamp((point - a).dot(edge) / length2, 0.0, 1.0) : 0.0) * edge;
}

/// @return from the footprint's nearest point to the place; zero on the footprint
Eigen::Vector2d awayFrom(const PhotoPart& part, const Eigen::Vector2d& place_map) {
    const std::vector<Eigen::Vector2d>& hull = part.footprint_map;
    bool isInside = hull.size() >= 3;
    Eigen::Vector2d away = Eigen::Vector2d::Zero();
    double least2 = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Eigen::Vector2d& a = hull[i];
        const Eigen::Vector2d& b = hull[(i + 1) % hull.size()];
        if (cross(b - a, place_map - a) < 0.0) isInside = false;
        const Eigen::Vector2d here = place_map - nearestOnEdge(a, b, place_map);
        if (!(here.squaredNorm() < least2)) continue;
        away = here;
        least2 = here.squaredNorm();
    }
    return isInside ? Eigen::Vector2d::Zero() : away;
}

}  // namespace

PhotoPart wholeOf(const PlanTarget& target, std::size_t index) {
    PhotoPart part;
    part.target = index;
    part.voxelSize_m = target.voxelSize_m;
    part.voxels = target.voxels;
    if (part.voxels.empty()) part.voxels = boxVoxels(target, target.voxelSize_m);
    part.centre_map = target.centroid_map.head<2>();
    measure(part);
    return part;
}

std::optional<std::pair<PhotoPart, PhotoPart>> halvesOf(const PhotoPart& part) {
    const Eigen::Vector2d along = longAxis(part.voxels);
    const Eigen::Vector3d directions[] = {{along.x(), along.y(), 0.0}, {-along.y(), along.x(), 0.0}, {0.0, 0.0, 1.0}};
    Eigen::Vector3d longest = directions[0];
    double low_m = 0.0, high_m = -1.0;
    for (const Eigen::Vector3d& direction : directions) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const Eigen::Vector3d& voxel : part.voxels) {
            low = std::min(low, voxel.dot(direction));
            high = std::max(high, voxel.dot(direction));
        }
        if (high - low <= high_m - low_m) continue;
        longest = direction;
        low_m = low;
        high_m = high;
    }
    if (high_m - low_m + part.voxelSize_m < kLeastLength_m) return std::nullopt;
    std::pair<PhotoPart, PhotoPart> halves;
    const double middle_m = 0.5 * (low_m + high_m);
    for (const Eigen::Vector3d& voxel : part.voxels)
        (voxel.dot(longest) < middle_m ? halves.first : halves.second).voxels.push_back(voxel);
    for (PhotoPart* half : {&halves.first, &halves.second}) {
        half->target = part.target;
        half->voxelSize_m = part.voxelSize_m;
        half->centre_map = meanOf(half->voxels).head<2>();
        measure(*half);
    }
    return halves;
}

double distanceTo(const PhotoPart& part, const Eigen::Vector2d& place_map) {
    return awayFrom(part, place_map).norm();
}

Eigen::Vector2d placeBeside(const PhotoPart& part, const Eigen::Vector2d& direction, double distance_m) {
    // Along a ray the distance from something convex is convex, so Newton's steps from beyond come down to the place
    // and never pass it.
    double at_m = distance_m;
    for (const Eigen::Vector2d& corner : part.footprint_map)
        at_m = std::max(at_m, distance_m + (corner - part.centre_map).norm());
    constexpr double kPrecision_m = 1e-10;
    constexpr int kMostSteps = 50;
    for (int step = 0; step < kMostSteps; ++step) {
        const Eigen::Vector2d away = awayFrom(part, part.centre_map + at_m * direction);
        const double here_m = away.norm();
        const double slope = here_m > 0.0 ? away.dot(direction) / here_m : 0.0;
        if (!(here_m - distance_m > kPrecision_m) || !(slope > 0.0)) break;
        at_m -= (here_m - distance_m) / slope;
    }
    return part.centre_map + at_m * direction;
}

bool isInTheWay(const PhotoPart& part, const Eigen::Vector3d& lens, const Eigen::Vector3d& point) {
    // The stretch of the line over the footprint, cut edge by edge (Cyrus and Beck).
    const Eigen::Vector2d from = lens.head<2>();
    const Eigen::Vector2d way = point.head<2>() - from;
    double enters = 0.0, leaves = 1.0;
    const std::vector<Eigen::Vector2d>& hull = part.footprint_map;
    if (hull.size() < 3) return false;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Eigen::Vector2d edge = hull[(i + 1) % hull.size()] - hull[i];
        const double inside = cross(edge, from - hull[i]);
        const double change = cross(edge, way);
        if (change == 0.0) {
            if (inside < 0.0) return false;
            continue;
        }
        const double at = -inside / change;
        if (change > 0.0)
            enters = std::max(enters, at);
        else
            leaves = std::min(leaves, at);
    }
    if (enters >= leaves) return false;
    const double rise = point.z() - lens.z();
    const double lowest = std::min(lens.z() + enters * rise, lens.z() + leaves * rise);
    const double highest = std::max(lens.z() + enters * rise, lens.z() + leaves * rise);
    return lowest < part.high_m && highest > part.low_m;
}

}  // namespace fodscope
