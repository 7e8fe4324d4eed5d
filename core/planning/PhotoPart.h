// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "core/planning/Waypoints.h"

namespace fodscope {

/// What one photo has to show: a target, or a part of a large one. It is taken for the upright prism over its
/// footprint.
struct PhotoPart {
    /// Index of the target.
    std::size_t target = 0;
    /// Where the lines of sight lead to.
    Eigen::Vector2d centre_map = Eigen::Vector2d::Zero();
    /// Corners of its convex footprint, counter-clockwise; the voxels' own edges are in it.
    std::vector<Eigen::Vector2d> footprint_map;
    /// From the floor to its lower and upper end.
    double low_m = 0.0;
    double high_m = 0.0;
    /// Least extent of the footprint in any direction.
    double width_m = 0.0;
    /// Centres of its voxels: x, y in the map frame, z over the floor.
    std::vector<Eigen::Vector3d> voxels;
    double voxelSize_m = 0.0;
};

/// The whole target as one part.
PhotoPart wholeOf(const PlanTarget& target, std::size_t index);

/// The halves of a part along its longest extent; empty for one that is shorter than 0.3 m.
std::optional<std::pair<PhotoPart, PhotoPart>> halvesOf(const PhotoPart& part);

/// @return from the place to the nearest point of the footprint; 0 on it
double distanceTo(const PhotoPart& part, const Eigen::Vector2d& place_map);

/// @return the place that lies in this direction from the part's centre, so far from its footprint
Eigen::Vector2d placeBeside(const PhotoPart& part, const Eigen::Vector2d& direction, double distance_m);

/// Whether a part is in the way of a look from a lens to a point (z over the floor).
bool isInTheWay(const PhotoPart& part, const Eigen::Vector3d& lens, const Eigen::Vector3d& point);

}  // namespace fodscope
