// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <QColor>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ui/theme/Theme.h"
#include "ui/view3d/OrbitCamera.h"
#include "ui/view3d/View3D.h"

namespace fodscope {

/// Coloured lines and triangles: what is drawn that is no cloud and no mesh. Built by the functions below, which need
/// no renderer.
struct Shapes {
    struct Line {
        std::vector<std::uint32_t> vertices;
        QColor colour;
    };
    struct Triangle {
        std::array<std::uint32_t, 3> vertices;
        QColor colour;
    };
    std::vector<Eigen::Vector3d> vertices;
    std::vector<Line> lines;
    std::vector<Triangle> triangles;

    bool empty() const { return lines.empty() && triangles.empty(); }
    std::uint32_t add(const Eigen::Vector3d& vertex);
    void addLine(std::span<const Eigen::Vector3d> points, const QColor& colour);
    void addPolygon(std::span<const Eigen::Vector3d> points, const QColor& colour);
    Bounds bounds() const;
};

/// A 1 m grid over the bounds at a height, with a heavier line every 5 m.
Shapes gridShapes(const Bounds& bounds, double height_m, const Theme& theme);
/// Disc, direction and view cone of each waypoint.
Shapes waypointShapes(std::span<const ViewWaypoint> waypoints, double floor_m, const Theme& theme);
/// Footprint with nose; hollow when stale.
Shapes robotShapes(const ViewRobot& robot, double floor_m, const Theme& theme);
Shapes lineShapes(std::span<const Eigen::Vector3d> points, const QColor& colour);
/// The corners of a box round the candidate's points.
Shapes bracketShapes(const Bounds& bounds, const QColor& colour);

}  // namespace fodscope
