// SPDX-License-Identifier: MIT
#include "core/robot/VisitChecks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/common/Hash.h"
#include "core/robot/PhotoIntegrity.h"

namespace fodscope {
namespace {

std::string formatted(const char* format, double first, double second = 0.0) {
    char text[160];
    std::snprintf(text, sizeof text, format, first, second);
    return text;
}

std::optional<VisitProblem> placeProblem(const Photo& photo, const PhotoExpectation& expected,
                                         const VisitSettings& settings) {
    if (!photo.waypointId.empty() && photo.waypointId != expected.waypointId)
        return VisitProblem{VisitReason::PhotoOfAnotherPlace, "the robot says it is of " + photo.waypointId};
    const Eigen::Vector2d camera = photo.T_map_from_camera.translation().head<2>();
    const double away_m = (camera - Eigen::Vector2d(expected.pose_map.x_m, expected.pose_map.y_m)).norm();
    if (away_m <= settings.cameraReach_m) return std::nullopt;
    return VisitProblem{VisitReason::PhotoOfAnotherPlace,
                        std::isfinite(away_m) ? formatted("the camera was %.2f m from the waypoint", away_m)
                                              : "the camera's pose is no number"};
}

std::optional<VisitProblem> timeProblem(const Photo& photo, const PhotoExpectation& expected,
                                        const VisitSettings& settings) {
    const double taken_s = 1e-3 * static_cast<double>(photo.taken.milliseconds) - expected.clockOffset_s;
    const double early_s = 1e-3 * static_cast<double>(expected.arrived.milliseconds) - taken_s;
    const double late_s = taken_s - 1e-3 * static_cast<double>(expected.now.milliseconds);
    if (early_s > settings.maximumClockOffset_s)
        return VisitProblem{VisitReason::PhotoOfAnotherTime,
                            formatted("its time is %.0f s before the arrival", early_s)};
    if (late_s > settings.maximumClockOffset_s)
        return VisitProblem{VisitReason::PhotoOfAnotherTime, formatted("its time is %.0f s ahead", late_s)};
    return std::nullopt;
}

}  // namespace

bool isFinite(const Pose2& pose) {
    return std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.yaw_rad);
}

std::optional<VisitProblem> arrivalProblem(const Pose2& stands_map, const Pose2& goal_map,
                                           const VisitSettings& settings) {
    const double away_m = std::hypot(stands_map.x_m - goal_map.x_m, stands_map.y_m - goal_map.y_m);
    const double turned_rad = std::abs(wrapAngle(stands_map.yaw_rad - goal_map.yaw_rad));
    if (away_m <= settings.arrivalTolerance_m && turned_rad <= settings.arrivalTolerance_rad) return std::nullopt;
    return VisitProblem{VisitReason::ArrivedElsewhere,
                        formatted("%.2f m and %.0f° from the waypoint", away_m, degreesFromRadians(turned_rad))};
}

std::optional<VisitProblem> photoProblem(Photo& photo, const PhotoExpectation& expected,
                                         const VisitSettings& settings) {
    const PhotoCheck check = checkPhoto(photo.bytes);
    if (!check.problem.empty()) return VisitProblem{VisitReason::PhotoCorrupt, check.problem};
    photo.mediaType = check.mediaType;
    photo.sha256 = sha256(photo.bytes);
    if (auto problem = placeProblem(photo, expected, settings)) return problem;
    if (auto problem = timeProblem(photo, expected, settings)) return problem;
    if (check.contrast < settings.leastContrast)
        return VisitProblem{VisitReason::PhotoBlank,
                            formatted("its grey levels differ by %.0f of 255", check.contrast)};
    const bool isKnown = expected.kept != nullptr &&
                         std::ranges::find(*expected.kept, photo.sha256, &PhotoMark::sha256) != expected.kept->end();
    if (isKnown) return VisitProblem{VisitReason::PhotoRepeated, "the camera may be frozen"};
    return std::nullopt;
}

}  // namespace fodscope
