// SPDX-License-Identifier: MIT
#pragma once

#include "core/common/Camera.h"
#include "core/planning/PhotoPart.h"

namespace fodscope {

/// Why a thing is not whole in the picture.
enum class PictureFit { Fits, TooHigh, TooNear, TooFar };

/// Yaws of the robot, radians, ascending; not wrapped.
struct YawRange {
    double lowest_rad = 0.0;
    double highest_rad = 0.0;
};

/// What the robot's camera has in its picture, for a robot that stands on the floor.
class CameraFit {
  public:
    /// @throws Error for a camera that cannot be
    CameraFit(const CameraSettings& camera, const WaypointSettings& settings);

    /// @param yaws set when it fits: the yaws with which a robot at the place has the whole part in the picture, round
    ///        the bearing of its centre
    PictureFit fit(const Eigen::Vector2d& place_map, const PhotoPart& part, YawRange& yaws) const;

    /// What is farther from the lens is too coarse.
    double range_m() const { return range_m_; }
    double height_m() const { return height_m_; }

  private:
    struct Reach {
        PictureFit fit = PictureFit::Fits;
        double turn_rad = 0.0;
    };
    Reach reachOf(double distance_m, double height_m) const;

    double height_m_;
    double near_m_;
    double range_m_;
    double sine_;
    double cosine_;
    /// Tangents of the half angles, less the margin.
    double across_;
    double upright_;
};

}  // namespace fodscope
