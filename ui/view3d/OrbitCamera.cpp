// SPDX-License-Identifier: MIT
#include "ui/view3d/OrbitCamera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/common/Geometry.h"

namespace fodscope {
namespace {

constexpr double kHalfTurn_rad = 3.14159265358979323846;
constexpr double kLeastDistance_m = 0.02;
constexpr double kGreatestDistance_m = 2000.0;

Eigen::Vector3d cornerOf(const Bounds& bounds, int corner) {
    return {corner & 1 ? bounds.maximum.x() : bounds.minimum.x(), corner & 2 ? bounds.maximum.y() : bounds.minimum.y(),
            corner & 4 ? bounds.maximum.z() : bounds.minimum.z()};
}

double fittingDistance(const OrbitCamera& camera, const Bounds& bounds, double aspect, double margin) {
    const double halfHeight = std::tan(0.5 * camera.viewAngle_rad) * (1.0 - margin);
    const double halfWidth = halfHeight * aspect;
    double distance = 0.1;
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d offset = cornerOf(bounds, corner) - camera.focus;
        const double behind = camera.parallel ? 0.0 : camera.forward().dot(offset);
        distance = std::max(distance, std::abs(camera.right().dot(offset)) / halfWidth - behind);
        distance = std::max(distance, std::abs(camera.up().dot(offset)) / halfHeight - behind);
    }
    return std::min(distance, kGreatestDistance_m);
}

/// @return how far, in the plane of the focus, the picture of the box is off the middle
Eigen::Vector3d offCentre(const OrbitCamera& camera, const Bounds& bounds) {
    Eigen::Vector2d least = Eigen::Vector2d::Constant(1e9);
    Eigen::Vector2d most = Eigen::Vector2d::Constant(-1e9);
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d offset = cornerOf(bounds, corner) - camera.focus;
        const double depth = camera.distance_m + (camera.parallel ? 0.0 : camera.forward().dot(offset));
        const double scale = camera.distance_m / std::max(1e-6, depth);
        const Eigen::Vector2d spot(scale * camera.right().dot(offset), scale * camera.up().dot(offset));
        least = least.cwiseMin(spot);
        most = most.cwiseMax(spot);
    }
    const Eigen::Vector2d middle = 0.5 * (least + most);
    return middle.x() * camera.right() + middle.y() * camera.up();
}

}  // namespace

void Bounds::extend(const Eigen::Vector3d& point) {
    if (empty()) {
        minimum = maximum = point;
        return;
    }
    minimum = minimum.cwiseMin(point);
    maximum = maximum.cwiseMax(point);
}

void Bounds::extend(const Bounds& other) {
    if (other.empty()) return;
    extend(other.minimum);
    extend(other.maximum);
}

Eigen::Vector3d OrbitCamera::forward() const {
    return {-std::cos(elevation_rad) * std::cos(azimuth_rad), -std::cos(elevation_rad) * std::sin(azimuth_rad),
            -std::sin(elevation_rad)};
}

Eigen::Vector3d OrbitCamera::up() const {
    return {-std::sin(elevation_rad) * std::cos(azimuth_rad), -std::sin(elevation_rad) * std::sin(azimuth_rad),
            std::cos(elevation_rad)};
}

Eigen::Vector3d OrbitCamera::right() const {
    return {-std::sin(azimuth_rad), std::cos(azimuth_rad), 0.0};
}

double OrbitCamera::visibleHeight_m() const {
    return 2.0 * distance_m * std::tan(0.5 * viewAngle_rad);
}

OrbitCamera orbited(const OrbitCamera& camera, double dx_px, double dy_px, double viewHeight_px) {
    OrbitCamera result = camera;
    const double radiansPerPixel = kHalfTurn_rad / std::max(1.0, viewHeight_px);
    result.azimuth_rad = wrapAngle(camera.azimuth_rad - dx_px * radiansPerPixel);
    result.elevation_rad =
        std::clamp(camera.elevation_rad + dy_px * radiansPerPixel, -0.5 * kHalfTurn_rad, 0.5 * kHalfTurn_rad);
    result.parallel = false;
    return result;
}

OrbitCamera panned(const OrbitCamera& camera, double dx_px, double dy_px, double viewHeight_px) {
    OrbitCamera result = camera;
    const double metresPerPixel = camera.visibleHeight_m() / std::max(1.0, viewHeight_px);
    result.focus += metresPerPixel * (-dx_px * camera.right() + dy_px * camera.up());
    return result;
}

OrbitCamera zoomed(const OrbitCamera& camera, double factor, const Eigen::Vector3d& anchor) {
    OrbitCamera result = camera;
    result.distance_m = std::clamp(camera.distance_m * factor, kLeastDistance_m, kGreatestDistance_m);
    result.focus = anchor + (camera.focus - anchor) * (result.distance_m / camera.distance_m);
    return result;
}

OrbitCamera fitted(const OrbitCamera& camera, const Bounds& bounds, double aspect, double margin) {
    if (bounds.empty()) return camera;
    OrbitCamera result = camera;
    result.focus = bounds.centre();
    // A perspective picture of a box is not centred where the box is; a few steps of shifting and fitting settle it.
    for (int round = 0; round < 5; ++round) {
        result.distance_m = fittingDistance(result, bounds, aspect, margin);
        result.focus += offCentre(result, bounds);
    }
    result.distance_m = fittingDistance(result, bounds, aspect, margin);
    return result;
}

OrbitCamera between(const OrbitCamera& from, const OrbitCamera& to, double share) {
    OrbitCamera result = to;
    result.focus = from.focus + share * (to.focus - from.focus);
    // Equal steps in the logarithm look like an even approach.
    result.distance_m = from.distance_m * std::pow(to.distance_m / from.distance_m, share);
    result.azimuth_rad = wrapAngle(from.azimuth_rad + share * wrapAngle(to.azimuth_rad - from.azimuth_rad));
    result.elevation_rad = from.elevation_rad + share * (to.elevation_rad - from.elevation_rad);
    result.parallel = share < 1.0 ? from.parallel && to.parallel : to.parallel;
    return result;
}

}  // namespace fodscope
