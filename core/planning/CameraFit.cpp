// SPDX-License-Identifier: MIT
#include "core/planning/CameraFit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/common/Error.h"

namespace fodscope {
namespace {

constexpr double kQuarterTurn_rad = std::numbers::pi / 2.0;

void requireUsable(const CameraSettings& camera) {
    const bool image =
        camera.width_px >= 1 && camera.height_px >= 1 && camera.width_px <= 16384 && camera.height_px <= 16384;
    const bool view = camera.horizontalFieldOfView_rad > 0.0 && camera.horizontalFieldOfView_rad < std::numbers::pi &&
                      std::abs(camera.pitchDown_rad) < kQuarterTurn_rad;
    const bool place = std::isfinite(camera.height_m) && camera.height_m >= 0.0 && camera.nearLimit_m >= 0.0 &&
                       std::isfinite(camera.nearLimit_m);
    if (!image || !view || !place) {
        throw Error("camera", "a value is out of range",
                    "give 1 to 16384 pixels, a field of view between 0 and 180 degrees, a pitch under 90 degrees and "
                    "lengths of 0 m or more");
    }
}

}  // namespace

CameraFit::CameraFit(const CameraSettings& camera, const WaypointSettings& settings) {
    requireUsable(camera);
    const CameraIntrinsics k = intrinsicsOf(camera);
    const double used = 1.0 - 2.0 * settings.edgeMargin;
    height_m_ = camera.height_m;
    near_m_ = std::max(camera.nearLimit_m, 1e-3);
    range_m_ = settings.coarsestPixel_m * k.fx_px;
    sine_ = std::sin(camera.pitchDown_rad);
    cosine_ = std::cos(camera.pitchDown_rad);
    across_ = used * 0.5 * k.width_px / k.fx_px;
    upright_ = used * 0.5 * k.height_px / k.fy_px;
}

/// How far the robot may turn away from a point so that it stays in the picture. With φ the turn, r the level distance
/// and d the height over the lens, the point has the depth c·r·cos φ − s·d, lies s·r·cos φ + c·d over the axis and
/// r·sin φ beside it. All but the last depend on cos φ alone, and turning away from a point only makes them worse
/// wherever the picture reaches over and under the horizon; where it does not, turning away is left unused.
CameraFit::Reach CameraFit::reachOf(double distance_m, double height_m) const {
    const double r = std::max(distance_m, 1e-6);
    const double d = height_m - height_m_;
    if (std::hypot(r, d) > range_m_) return {PictureFit::TooFar, 0.0};
    const double depth_m = cosine_ * r - sine_ * d;
    if (depth_m < near_m_) return {PictureFit::TooNear, 0.0};
    const double over_m = sine_ * r + cosine_ * d;
    if (over_m > upright_ * depth_m) return {PictureFit::TooHigh, 0.0};
    if (over_m < -upright_ * depth_m) return {PictureFit::TooNear, 0.0};

    // Each bound is one on cos φ from below.
    double least = (near_m_ + sine_ * d) / (cosine_ * r);
    const double toUpperEdge = upright_ * cosine_ - sine_;
    if (toUpperEdge > 0.0) least = std::max(least, d * (cosine_ + upright_ * sine_) / (r * toUpperEdge));
    const double toLowerEdge = upright_ * cosine_ + sine_;
    if (toLowerEdge > 0.0) least = std::max(least, -d * (cosine_ - upright_ * sine_) / (r * toLowerEdge));
    double turn_rad = least <= 0.0 ? kQuarterTurn_rad : std::acos(std::min(least, 1.0));

    // r·sin φ ≤ a·(c·r·cos φ − s·d)
    const double slope = across_ * cosine_;
    const double side = -across_ * sine_ * d / (r * std::hypot(1.0, slope));
    turn_rad = std::min(turn_rad, std::atan(slope) + std::asin(std::clamp(side, -1.0, 1.0)));
    if (turn_rad < 0.0) return {PictureFit::TooNear, 0.0};
    return {PictureFit::Fits, turn_rad};
}

PictureFit CameraFit::fit(const Eigen::Vector2d& place_map, const PhotoPart& part, YawRange& yaws) const {
    const Eigen::Vector2d way = part.centre_map - place_map;
    const double bearing_rad = std::atan2(way.y(), way.x());
    double lowest_rad = -std::numeric_limits<double>::infinity();
    double highest_rad = -lowest_rad;
    for (const Eigen::Vector2d& corner : part.footprint_map) {
        const Eigen::Vector2d towards = corner - place_map;
        const double distance_m = towards.norm();
        const double beside_rad = wrapAngle(std::atan2(towards.y(), towards.x()) - bearing_rad);
        for (const double height_m : {part.low_m, part.high_m}) {
            const Reach reach = reachOf(distance_m, height_m);
            if (reach.fit != PictureFit::Fits) return reach.fit;
            lowest_rad = std::max(lowest_rad, beside_rad - reach.turn_rad);
            highest_rad = std::min(highest_rad, beside_rad + reach.turn_rad);
        }
    }
    // Wider than the picture.
    if (lowest_rad > highest_rad) return PictureFit::TooNear;
    yaws = {bearing_rad + lowest_rad, bearing_rad + highest_rad};
    return PictureFit::Fits;
}

}  // namespace fodscope
