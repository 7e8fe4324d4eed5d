// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "core/cloud/VoxelGrid.h"
#include "core/common/Geometry.h"

namespace fodscope::test {

/// A rectangle in space, sampled uniformly.
struct Panel {
    Eigen::Vector3d corner;
    Eigen::Vector3d first;
    Eigen::Vector3d second;
};

inline std::vector<Panel> boxPanels(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    const Eigen::Vector3d size = high - low;
    const Eigen::Vector3d x(size.x(), 0, 0);
    const Eigen::Vector3d y(0, size.y(), 0);
    const Eigen::Vector3d z(0, 0, size.z());
    return {{low, x, y}, {low + z, x, y}, {low, x, z}, {low + y, x, z}, {low, y, z}, {low + x, y, z}};
}

/// A room of 4 × 3 × 1.2 m without a ceiling, with a block, a column and a ledge that no rotation maps onto themselves.
inline std::vector<Panel> roomPanels() {
    std::vector<Panel> panels = boxPanels({0, 0, 0}, {4.0, 3.0, 1.2});
    panels.erase(panels.begin() + 1);
    for (const auto& [low, high] : {std::pair(Eigen::Vector3d(0.4, 0.3, 0), Eigen::Vector3d(1.1, 0.8, 0.5)),
                                    std::pair(Eigen::Vector3d(2.9, 0.6, 0), Eigen::Vector3d(3.1, 0.8, 1.2)),
                                    std::pair(Eigen::Vector3d(1.8, 2.6, 0), Eigen::Vector3d(3.4, 3.0, 0.3))}) {
        const std::vector<Panel> part = boxPanels(low, high);
        panels.insert(panels.end(), part.begin(), part.end());
    }
    return panels;
}

/// Points on the panels, `perSquareMetre` of them on the average, with Gaussian noise.
inline std::vector<Eigen::Vector3d> sample(const std::vector<Panel>& panels, double perSquareMetre, double noise_m,
                                           std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::normal_distribution<double> noise(0.0, noise_m);
    std::vector<Eigen::Vector3d> points;
    for (const Panel& panel : panels) {
        const double area_m2 = panel.first.cross(panel.second).norm();
        const auto count = static_cast<std::size_t>(area_m2 * perSquareMetre);
        for (std::size_t i = 0; i < count; ++i) {
            const double u = uniform(random);
            const double v = uniform(random);
            points.push_back(panel.corner + u * panel.first + v * panel.second +
                             Eigen::Vector3d(noise(random), noise(random), noise(random)));
        }
    }
    return points;
}

/// A room of 4 × 3 × 1.2 m without a ceiling that half a turn maps onto itself, but for a small block where one is
/// told.
inline std::vector<Panel> mirrorRoomPanels(bool withBlock) {
    std::vector<Panel> panels = boxPanels({0, 0, 0}, {4.0, 3.0, 1.2});
    panels.erase(panels.begin() + 1);
    if (withBlock) {
        const std::vector<Panel> block = boxPanels({0.5, 1.0, 0}, {0.7, 1.2, 0.2});
        panels.insert(panels.end(), block.begin(), block.end());
    }
    return panels;
}

/// As a mean reference holds it: voxel means of 5 cm.
inline std::vector<Eigen::Vector3d> referenceOf(const std::vector<Panel>& panels) {
    const std::vector<Eigen::Vector3d> points = sample(panels, 4000.0, 0.002, 1);
    return voxelGrid(points, minimumCorner(points) - Eigen::Vector3d::Constant(0.025), {0.05}).points;
}

inline std::vector<Eigen::Vector3d> mapOf(const std::vector<Panel>& panels, const Transform& T_map_from_room,
                                          std::uint64_t seed = 2) {
    std::vector<Eigen::Vector3d> points = sample(panels, 2500.0, 0.003, seed);
    for (Eigen::Vector3d& point : points)
        point = T_map_from_room * point;
    return points;
}

inline std::vector<Eigen::Vector3d> roomReference() {
    return referenceOf(roomPanels());
}

inline std::vector<Eigen::Vector3d> roomMap(const Transform& T_map_from_room) {
    return mapOf(roomPanels(), T_map_from_room);
}

inline Transform motion(double yaw_deg, const Eigen::Vector3d& shift_m) {
    Transform transform = Transform::Identity();
    transform.linear() = Eigen::AngleAxisd(radiansFromDegrees(yaw_deg), Eigen::Vector3d::UnitZ()).toRotationMatrix();
    transform.translation() = shift_m;
    return transform;
}

/// Leaning by `tilt_deg` about a horizontal axis, after the turn.
inline Transform leaningMotion(double yaw_deg, double tilt_deg, double axis_deg, const Eigen::Vector3d& shift_m) {
    const Eigen::Vector3d axis(std::cos(radiansFromDegrees(axis_deg)), std::sin(radiansFromDegrees(axis_deg)), 0.0);
    Transform lean = Transform::Identity();
    lean.linear() = Eigen::AngleAxisd(radiansFromDegrees(tilt_deg), axis).toRotationMatrix();
    return lean * motion(yaw_deg, shift_m);
}

/// The greatest displacement of the room's corners between two poses: what a misalignment does at its worst.
inline double cornerDisplacement_m(const Transform& a, const Transform& b) {
    double worst_m = 0.0;
    for (const double x : {0.0, 4.0}) {
        for (const double y : {0.0, 3.0}) {
            for (const double z : {0.0, 1.2}) {
                const Eigen::Vector3d corner(x, y, z);
                worst_m = std::max(worst_m, (a * corner - b * corner).norm());
            }
        }
    }
    return worst_m;
}

}  // namespace fodscope::test
