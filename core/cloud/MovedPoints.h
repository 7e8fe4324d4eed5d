// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <span>

#include "core/common/Geometry.h"

namespace fodscope {

/// The points of a cloud as another frame sees them, and of those only what lies strictly between two corners. Nothing
/// is copied: a map of ten million points takes 240 MB.
struct MovedPoints {
    std::span<const Eigen::Vector3d> points;
    Transform T_target_from_points = Transform::Identity();
    Eigen::Vector3d low = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());
    Eigen::Vector3d high = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());

    std::size_t size() const { return points.size(); }

    /// @return whether point i lies between the corners; `moved` is where
    bool get(std::size_t i, Eigen::Vector3d& moved) const {
        moved = T_target_from_points * points[i];
        return (moved.array() > low.array()).all() && (moved.array() < high.array()).all();
    }
};

/// All points where they are, for code that takes either.
struct UnmovedPoints {
    std::span<const Eigen::Vector3d> points;

    std::size_t size() const { return points.size(); }
    bool get(std::size_t i, Eigen::Vector3d& point) const {
        point = points[i];
        return true;
    }
};

}  // namespace fodscope
