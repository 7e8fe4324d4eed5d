// SPDX-License-Identifier: MIT
#include "ui/view3d/Picking.h"

#include <cmath>
#include <limits>

namespace fodscope {
namespace {

constexpr double kNearest_m = 1e-3;

}  // namespace

ScreenProjection::ScreenProjection(const OrbitCamera& camera, double width_px, double height_px)
    : eye_(camera.eye()),
      right_(camera.right()),
      up_(camera.up()),
      forward_(camera.forward()),
      centreX_px_(0.5 * width_px),
      centreY_px_(0.5 * height_px),
      focal_px_(0.5 * height_px / std::tan(0.5 * camera.viewAngle_rad)),
      scale_px_(height_px / camera.visibleHeight_m()),
      focusDepth_m_(camera.distance_m),
      parallel_(camera.parallel) {}

std::optional<ScreenProjection::Spot> ScreenProjection::project(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d offset = point - eye_;
    const double depth = forward_.dot(offset);
    if (depth < kNearest_m && !parallel_) return std::nullopt;
    const double scale = parallel_ ? scale_px_ : focal_px_ / depth;
    return Spot{centreX_px_ + scale * right_.dot(offset), centreY_px_ - scale * up_.dot(offset), depth};
}

Eigen::Vector3d ScreenProjection::unproject(double x_px, double y_px, double depth_m) const {
    const double scale = parallel_ ? scale_px_ : focal_px_ / depth_m;
    return eye_ + depth_m * forward_ + (x_px - centreX_px_) / scale * right_ - (y_px - centreY_px_) / scale * up_;
}

std::optional<PickHit> pickNearest(std::span<const Eigen::Vector3f> points, const ScreenProjection& projection,
                                   double x_px, double y_px, double radius_px, std::optional<double> peelHeight_m) {
    std::optional<PickHit> best;
    double bestScore = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (peelHeight_m && points[i].z() > *peelHeight_m) continue;
        const auto spot = projection.project(points[i].cast<double>());
        if (!spot) continue;
        const double dx = spot->x_px - x_px;
        const double dy = spot->y_px - y_px;
        const double squared = dx * dx + dy * dy;
        if (squared > radius_px * radius_px) continue;
        // A pixel aside counts as much as four pixels behind, so that the point under the pointer wins on a surface.
        const double score = spot->depth_m + 4.0 * std::sqrt(squared) / projection.pixelsPerMetre();
        if (score < bestScore) {
            bestScore = score;
            best = PickHit{i, spot->depth_m};
        }
    }
    return best;
}

}  // namespace fodscope
