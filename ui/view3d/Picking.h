// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>

#include "ui/view3d/OrbitCamera.h"

namespace fodscope {

/// Where points of the scene are on the screen, in pixels from the upper left corner.
class ScreenProjection {
  public:
    ScreenProjection(const OrbitCamera& camera, double width_px, double height_px);

    struct Spot {
        double x_px = 0.0;
        double y_px = 0.0;
        double depth_m = 0.0;
    };
    /// Empty behind the eye.
    std::optional<Spot> project(const Eigen::Vector3d& point) const;
    /// @return the point at that depth under a pixel
    Eigen::Vector3d unproject(double x_px, double y_px, double depth_m) const;
    /// At the distance of the focus.
    double pixelsPerMetre() const { return scale_px_; }
    double depthOfFocus_m() const { return focusDepth_m_; }

  private:
    Eigen::Vector3d eye_;
    Eigen::Vector3d right_;
    Eigen::Vector3d up_;
    Eigen::Vector3d forward_;
    double centreX_px_ = 0.0;
    double centreY_px_ = 0.0;
    double focal_px_ = 1.0;
    double scale_px_ = 1.0;
    double focusDepth_m_ = 1.0;
    bool parallel_ = false;
};

struct PickHit {
    std::size_t index = 0;
    double depth_m = 0.0;
};

/// The foremost point that is drawn within `radius_px` of a pixel; among points in one surface, the one nearest to the
/// pixel. Points higher than `peelHeight_m` are not there.
std::optional<PickHit> pickNearest(std::span<const Eigen::Vector3f> points, const ScreenProjection& projection,
                                   double x_px, double y_px, double radius_px, std::optional<double> peelHeight_m);

}  // namespace fodscope
