// SPDX-License-Identifier: MIT
#include "tests/fakes/SamplePhoto.h"

#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/inspection/PhotoProjection.h"

namespace fodscope {

namespace {

using Corners = std::array<Eigen::Vector3d, 4>;

QPolygonF project(const Corners& corners_map, const Transform& T_map_from_camera, const CameraIntrinsics& intrinsics) {
    QPolygonF polygon;
    const auto points_px = projectPoints(corners_map, T_map_from_camera, intrinsics);
    // A face that reaches behind the camera is left out.
    if (points_px.size() != corners_map.size()) return polygon;
    for (const Eigen::Vector2d& point : points_px)
        polygon << QPointF(point.x(), point.y());
    return polygon;
}

std::vector<std::pair<Corners, double>> facesOf(const SampleBlock& block) {
    const auto corner = [&](int index) {
        return Eigen::Vector3d((index & 1) ? block.maximum_map.x() : block.minimum_map.x(),
                               (index & 2) ? block.maximum_map.y() : block.minimum_map.y(),
                               (index & 4) ? block.maximum_map.z() : block.minimum_map.z());
    };
    const auto face = [&](int a, int b, int c, int d) { return Corners{corner(a), corner(b), corner(c), corner(d)}; };
    return {{face(0, 1, 5, 4), 0.75},
            {face(2, 3, 7, 6), 0.7},
            {face(0, 2, 6, 4), 0.9},
            {face(1, 3, 7, 5), 0.6},
            {face(4, 5, 7, 6), 1.1}};
}

double distanceTo(const Corners& corners_map, const Eigen::Vector3d& camera_map) {
    return (0.25 * (corners_map[0] + corners_map[1] + corners_map[2] + corners_map[3]) - camera_map).norm();
}

QColor lit(const QColor& colour, double share, double distance_m) {
    const double light = std::clamp(share * 1.5 / (0.6 + distance_m * distance_m * 0.35), 0.08, 1.3);
    return QColor::fromRgb(std::min(255, static_cast<int>(colour.red() * light)),
                           std::min(255, static_cast<int>(colour.green() * light)),
                           std::min(255, static_cast<int>(colour.blue() * light)));
}

void paintFloor(QPainter& painter, const Transform& T_map_from_camera, const CameraIntrinsics& intrinsics) {
    constexpr double kTile_m = 0.1;
    for (int row = -40; row < 40; ++row) {
        for (int column = -40; column < 40; ++column) {
            const double x = column * kTile_m;
            const double y = row * kTile_m;
            const Corners tile{Eigen::Vector3d(x, y, 0), Eigen::Vector3d(x + kTile_m, y, 0),
                               Eigen::Vector3d(x + kTile_m, y + kTile_m, 0), Eigen::Vector3d(x, y + kTile_m, 0)};
            const QPolygonF polygon = project(tile, T_map_from_camera, intrinsics);
            if (polygon.isEmpty()) continue;
            const int rust = (row * 37 + column * 101 + row * column * 13) & 31;
            const QColor colour =
                lit(QColor(118 + rust, 96 + rust / 2, 78), 1.0, distanceTo(tile, T_map_from_camera.translation()));
            painter.setBrush(colour);
            painter.setPen(colour);
            painter.drawPolygon(polygon);
        }
    }
}

}  // namespace

CameraIntrinsics sampleIntrinsics() {
    CameraIntrinsics intrinsics;
    intrinsics.width_px = 1280;
    intrinsics.height_px = 720;
    intrinsics.fx_px = intrinsics.fy_px = 640.0 / std::tan(0.5 * 1.2043);
    intrinsics.cx_px = 640.0;
    intrinsics.cy_px = 360.0;
    return intrinsics;
}

Transform sampleCameraPose(const Pose2& robot_map) {
    const double pitch_rad = radiansFromDegrees(5.0);
    const Eigen::Vector3d forward(std::cos(robot_map.yaw_rad) * std::cos(pitch_rad),
                                  std::sin(robot_map.yaw_rad) * std::cos(pitch_rad), -std::sin(pitch_rad));
    const Eigen::Vector3d right(std::sin(robot_map.yaw_rad), -std::cos(robot_map.yaw_rad), 0.0);
    Transform T_map_from_camera = Transform::Identity();
    T_map_from_camera.linear().col(0) = right;
    T_map_from_camera.linear().col(1) = forward.cross(right);
    T_map_from_camera.linear().col(2) = forward;
    T_map_from_camera.translation() = Eigen::Vector3d(robot_map.x_m, robot_map.y_m, 0.2);
    return T_map_from_camera;
}

std::vector<std::byte> samplePhoto(const std::vector<SampleBlock>& blocks, const Transform& T_map_from_camera,
                                   const CameraIntrinsics& intrinsics) {
    QImage image(intrinsics.width_px, intrinsics.height_px, QImage::Format_RGB32);
    image.fill(QColor(24, 26, 30));
    {
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        paintFloor(painter, T_map_from_camera, intrinsics);
        const Eigen::Vector3d camera_map = T_map_from_camera.translation();
        std::vector<std::tuple<double, Corners, QColor>> faces;
        for (const SampleBlock& block : blocks) {
            for (const auto& [corners, share] : facesOf(block)) {
                const double distance_m = distanceTo(corners, camera_map);
                faces.emplace_back(distance_m, corners, lit(QColor::fromRgb(block.colour), share, distance_m));
            }
        }
        std::sort(faces.begin(), faces.end(),
                  [](const auto& a, const auto& b) { return std::get<0>(a) > std::get<0>(b); });
        for (const auto& [distance_m, corners, colour] : faces) {
            painter.setPen(colour);
            painter.setBrush(colour);
            painter.drawPolygon(project(corners, T_map_from_camera, intrinsics));
        }
    }
    QByteArray jpeg;
    QBuffer buffer(&jpeg);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "JPEG", 88);
    const auto* first = reinterpret_cast<const std::byte*>(jpeg.constData());
    return {first, first + jpeg.size()};
}

}  // namespace fodscope
