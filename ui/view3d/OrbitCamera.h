// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace fodscope {

/// A box in metres; empty while its minimum is greater than its maximum.
struct Bounds {
    Eigen::Vector3d minimum = Eigen::Vector3d::Constant(1.0);
    Eigen::Vector3d maximum = Eigen::Vector3d::Constant(-1.0);

    bool empty() const { return minimum.x() > maximum.x(); }
    Eigen::Vector3d centre() const { return 0.5 * (minimum + maximum); }
    void extend(const Eigen::Vector3d& point);
    void extend(const Bounds& other);
};

/// A camera that turns about a point and keeps z up, so that a tank never lies on its side. Angles in radians: azimuth
/// from +x counter-clockwise, elevation from the floor.
struct OrbitCamera {
    Eigen::Vector3d focus = Eigen::Vector3d::Zero();
    double distance_m = 10.0;
    double azimuth_rad = -1.0;
    double elevation_rad = 0.6;
    /// Vertical opening.
    double viewAngle_rad = 0.6;
    /// Parallel projection with the scale that the perspective has at the focus; for views along an axis.
    bool parallel = false;

    /// From the eye towards the focus.
    Eigen::Vector3d forward() const;
    Eigen::Vector3d up() const;
    Eigen::Vector3d right() const;
    Eigen::Vector3d eye() const { return focus - distance_m * forward(); }
    /// Height of what is seen in the plane of the focus.
    double visibleHeight_m() const;
};

/// Pixels that the pointer moved; a full window height is half a turn. Ends the parallel projection.
OrbitCamera orbited(const OrbitCamera& camera, double dx_px, double dy_px, double viewHeight_px);
/// The point under the pointer follows it.
OrbitCamera panned(const OrbitCamera& camera, double dx_px, double dy_px, double viewHeight_px);
/// @param factor less than 1 comes closer
/// @param anchor a point that keeps its place on the screen
OrbitCamera zoomed(const OrbitCamera& camera, double factor, const Eigen::Vector3d& anchor);
/// The closest distance at which the whole box is seen.
/// @param aspect width over height
/// @param margin share of the view left free, 0..1
OrbitCamera fitted(const OrbitCamera& camera, const Bounds& bounds, double aspect, double margin);
/// @param share 0: from, 1: to; the azimuth takes the shorter way
OrbitCamera between(const OrbitCamera& from, const OrbitCamera& to, double share);

}  // namespace fodscope
