// SPDX-License-Identifier: MIT
#include "ui/view3d/Shapes.h"

#include <algorithm>
#include <cmath>

#include "ui/theme/Colours.h"

namespace fodscope {
namespace {

constexpr double kTurn_rad = 6.28318530717958647692;
/// Lifts what lies on the floor out of it, so that the two do not flicker.
constexpr double kLift_m = 0.012;
constexpr double kRobotRadius_m = 0.22;
constexpr double kWaypointRadius_m = 0.07;

Eigen::Vector3d onFloor(const Pose2& pose, double ahead_m, double left_m, double z_m) {
    const double c = std::cos(pose.yaw_rad);
    const double s = std::sin(pose.yaw_rad);
    return {pose.x_m + c * ahead_m - s * left_m, pose.y_m + s * ahead_m + c * left_m, z_m};
}

std::vector<Eigen::Vector3d> circle(const Pose2& pose, double radius_m, double z_m, bool closed) {
    constexpr int corners = 28;
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < corners + (closed ? 1 : 0); ++i) {
        const double angle = kTurn_rad * i / corners;
        points.push_back(onFloor(pose, radius_m * std::cos(angle), radius_m * std::sin(angle), z_m));
    }
    return points;
}

QColor faded(QColor colour, double alpha) {
    colour.setAlphaF(alpha);
    return colour;
}

void addCone(Shapes& shapes, const ViewWaypoint& waypoint, double z_m, const QColor& colour) {
    const Eigen::Vector3d start(waypoint.pose.x_m, waypoint.pose.y_m, z_m);
    Eigen::Vector3d reach = *waypoint.target - start;
    reach.z() = 0.0;
    const Eigen::Vector3d side(-reach.y(), reach.x(), 0.0);
    constexpr double halfOpening = 0.36;
    const std::array<Eigen::Vector3d, 3> cone = {start, start + reach + halfOpening * side,
                                                 start + reach - halfOpening * side};
    shapes.addPolygon(cone, faded(colour, 0.16));
    const std::array<Eigen::Vector3d, 3> edges = {cone[1], cone[0], cone[2]};
    shapes.addLine(edges, faded(colour, 0.6));
}

}  // namespace

std::uint32_t Shapes::add(const Eigen::Vector3d& vertex) {
    vertices.push_back(vertex);
    return static_cast<std::uint32_t>(vertices.size() - 1);
}

void Shapes::addLine(std::span<const Eigen::Vector3d> points, const QColor& colour) {
    if (points.size() < 2) return;
    Line line;
    line.colour = colour;
    for (const auto& point : points)
        line.vertices.push_back(add(point));
    lines.push_back(std::move(line));
}

void Shapes::addPolygon(std::span<const Eigen::Vector3d> points, const QColor& colour) {
    if (points.size() < 3) return;
    const std::uint32_t first = add(points[0]);
    std::uint32_t previous = add(points[1]);
    for (std::size_t i = 2; i < points.size(); ++i) {
        const std::uint32_t next = add(points[i]);
        triangles.push_back({{first, previous, next}, colour});
        previous = next;
    }
}

Bounds Shapes::bounds() const {
    Bounds box;
    for (const auto& vertex : vertices)
        box.extend(vertex);
    return box;
}

Shapes gridShapes(const Bounds& bounds, double height_m, const Theme& theme) {
    Shapes shapes;
    if (bounds.empty()) return shapes;
    const double longest = std::max(bounds.maximum.x() - bounds.minimum.x(), bounds.maximum.y() - bounds.minimum.y());
    // A plan of a whole ship needs no line every metre.
    const double step = longest > 200.0 ? 10.0 : longest > 60.0 ? 5.0 : 1.0;
    const double left = std::floor(bounds.minimum.x() / step - 0.2) * step;
    const double right = std::ceil(bounds.maximum.x() / step + 0.2) * step;
    const double front = std::floor(bounds.minimum.y() / step - 0.2) * step;
    const double back = std::ceil(bounds.maximum.y() / step + 0.2) * step;
    const QColor thin = mixed(theme.surface0, theme.line, 0.7);
    const QColor heavy = mixed(theme.line, theme.muted, 0.25);
    const auto colourOf = [&](double at) {
        return std::abs(std::remainder(at, 5.0 * step)) < 1e-6 * step ? heavy : thin;
    };
    const auto count = [step](double from, double to) { return static_cast<int>(std::lround((to - from) / step)); };
    for (int i = 0; i <= count(left, right); ++i) {
        const double x = left + i * step;
        const std::array<Eigen::Vector3d, 2> line = {Eigen::Vector3d(x, front, height_m),
                                                     Eigen::Vector3d(x, back, height_m)};
        shapes.addLine(line, colourOf(x));
    }
    for (int i = 0; i <= count(front, back); ++i) {
        const double y = front + i * step;
        const std::array<Eigen::Vector3d, 2> line = {Eigen::Vector3d(left, y, height_m),
                                                     Eigen::Vector3d(right, y, height_m)};
        shapes.addLine(line, colourOf(y));
    }
    return shapes;
}

Shapes waypointShapes(std::span<const ViewWaypoint> waypoints, double floor_m, const Theme& theme) {
    Shapes shapes;
    const double z = floor_m + kLift_m;
    for (const ViewWaypoint& waypoint : waypoints) {
        const QColor colour = waypoint.selected ? theme.accent : statusColour(theme, waypoint.state);
        if (waypoint.target) addCone(shapes, waypoint, z, colour);
        shapes.addPolygon(circle(waypoint.pose, kWaypointRadius_m, z + kLift_m, false), colour);
        const std::array<Eigen::Vector3d, 3> nose = {onFloor(waypoint.pose, 2.4 * kWaypointRadius_m, 0.0, z + kLift_m),
                                                     onFloor(waypoint.pose, 0.0, kWaypointRadius_m, z + kLift_m),
                                                     onFloor(waypoint.pose, 0.0, -kWaypointRadius_m, z + kLift_m)};
        shapes.addPolygon(nose, colour);
        if (waypoint.selected) {
            shapes.addLine(circle(waypoint.pose, 2.0 * kWaypointRadius_m, z + kLift_m, true), theme.accent);
        }
    }
    return shapes;
}

Shapes robotShapes(const ViewRobot& robot, double floor_m, const Theme& theme) {
    Shapes shapes;
    const double z = floor_m + 3.0 * kLift_m;
    const QColor colour = robot.stale ? theme.attention : theme.text;
    if (!robot.stale) {
        shapes.addPolygon(circle(robot.pose, kRobotRadius_m, z, false), mixed(theme.surface0, theme.text, 0.45));
        const std::array<Eigen::Vector3d, 3> arrow = {onFloor(robot.pose, 0.8 * kRobotRadius_m, 0.0, z + kLift_m),
                                                      onFloor(robot.pose, -0.5 * kRobotRadius_m, 0.13, z + kLift_m),
                                                      onFloor(robot.pose, -0.5 * kRobotRadius_m, -0.13, z + kLift_m)};
        shapes.addPolygon(arrow, theme.text);
    }
    shapes.addLine(circle(robot.pose, kRobotRadius_m, z + kLift_m, true), colour);
    if (robot.stale) {
        const std::array<Eigen::Vector3d, 3> heading = {onFloor(robot.pose, -0.1, 0.12, z),
                                                        onFloor(robot.pose, 0.8 * kRobotRadius_m, 0.0, z),
                                                        onFloor(robot.pose, -0.1, -0.12, z)};
        shapes.addLine(heading, colour);
    }
    return shapes;
}

Shapes lineShapes(std::span<const Eigen::Vector3d> points, const QColor& colour) {
    Shapes shapes;
    std::vector<Eigen::Vector3d> lifted(points.begin(), points.end());
    for (auto& point : lifted)
        point.z() += kLift_m;
    shapes.addLine(lifted, colour);
    return shapes;
}

Shapes bracketShapes(const Bounds& bounds, const QColor& colour) {
    Shapes shapes;
    if (bounds.empty()) return shapes;
    constexpr double air_m = 0.03;
    const Eigen::Vector3d low = bounds.minimum - Eigen::Vector3d::Constant(air_m);
    const Eigen::Vector3d high = bounds.maximum + Eigen::Vector3d::Constant(air_m);
    const Eigen::Vector3d arm = 0.3 * (high - low);
    for (int corner = 0; corner < 8; ++corner) {
        Eigen::Vector3d point;
        for (int axis = 0; axis < 3; ++axis)
            point[axis] = corner & (1 << axis) ? high[axis] : low[axis];
        for (int axis = 0; axis < 3; ++axis) {
            Eigen::Vector3d end = point;
            end[axis] += corner & (1 << axis) ? -arm[axis] : arm[axis];
            const std::array<Eigen::Vector3d, 2> line = {point, end};
            shapes.addLine(line, colour);
        }
    }
    return shapes;
}

}  // namespace fodscope
