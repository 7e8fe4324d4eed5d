// SPDX-License-Identifier: MIT
#include "ui/labelling/CandidateOutline.h"

#include <QRectF>
#include <algorithm>
#include <cmath>

namespace fodscope {

namespace {

/// Nearer points would project to anywhere.
constexpr double kNearestDepth_m = 0.02;
constexpr int kHaloCorners = 16;

double cross(const Eigen::Vector2d& origin, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return (a.x() - origin.x()) * (b.y() - origin.y()) - (a.y() - origin.y()) * (b.x() - origin.x());
}

std::vector<Eigen::Vector3d> cubeCorners(std::span<const Eigen::Vector3d> centres, double edge_m) {
    std::vector<Eigen::Vector3d> corners;
    corners.reserve(centres.size() * 8);
    for (const Eigen::Vector3d& centre : centres) {
        for (int corner = 0; corner < 8; ++corner) {
            const Eigen::Vector3d step((corner & 1) ? 0.5 : -0.5, (corner & 2) ? 0.5 : -0.5, (corner & 4) ? 0.5 : -0.5);
            corners.push_back(centre + edge_m * step);
        }
    }
    return corners;
}

std::vector<Eigen::Vector2d> grown(const QPolygonF& polygon_px, double halo_px) {
    std::vector<Eigen::Vector2d> points;
    for (const QPointF& corner : polygon_px) {
        for (int step = 0; step < kHaloCorners; ++step) {
            const double angle_rad = 2.0 * M_PI * step / kHaloCorners;
            points.emplace_back(corner.x() + halo_px * std::cos(angle_rad), corner.y() + halo_px * std::sin(angle_rad));
        }
    }
    return points;
}

}  // namespace

std::vector<Eigen::Vector2d> projectPoints(std::span<const Eigen::Vector3d> points_map,
                                           const Transform& T_map_from_camera, const CameraIntrinsics& intrinsics) {
    const Transform T_camera_from_map = T_map_from_camera.inverse();
    std::vector<Eigen::Vector2d> points_px;
    points_px.reserve(points_map.size());
    for (const Eigen::Vector3d& point_map : points_map) {
        const Eigen::Vector3d point = T_camera_from_map * point_map;
        if (!(point.z() > kNearestDepth_m)) continue;
        points_px.emplace_back(intrinsics.fx_px * point.x() / point.z() + intrinsics.cx_px,
                               intrinsics.fy_px * point.y() / point.z() + intrinsics.cy_px);
    }
    return points_px;
}

QPolygonF convexHull(std::vector<Eigen::Vector2d> points_px) {
    const auto before = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    };
    std::sort(points_px.begin(), points_px.end(), before);
    points_px.erase(std::unique(points_px.begin(), points_px.end()), points_px.end());

    std::vector<Eigen::Vector2d> hull;
    if (points_px.size() < 3) {
        hull = points_px;
    } else {
        // Andrew's monotone chain: the lower side from left to right, then the upper one back.
        const auto extend = [&hull](const Eigen::Vector2d& point, std::size_t keep) {
            while (hull.size() >= keep + 2 && cross(hull[hull.size() - 2], hull.back(), point) <= 0.0)
                hull.pop_back();
            hull.push_back(point);
        };
        for (const Eigen::Vector2d& point : points_px)
            extend(point, 0);
        const std::size_t lower = hull.size() - 1;
        for (auto point = std::next(points_px.rbegin()); point != points_px.rend(); ++point)
            extend(*point, lower);
        hull.pop_back();
    }
    QPolygonF polygon;
    for (const Eigen::Vector2d& point : hull)
        polygon << QPointF(point.x(), point.y());
    return polygon;
}

QPolygonF projectedOutline(std::span<const Eigen::Vector3d> voxels_map, double voxelSize_m,
                           const Transform& T_map_from_camera, const CameraIntrinsics& intrinsics, double halo_px) {
    const std::vector<Eigen::Vector3d> corners_map = cubeCorners(voxels_map, voxelSize_m);
    const QPolygonF hull = convexHull(projectPoints(corners_map, T_map_from_camera, intrinsics));
    const QRectF image(0, 0, intrinsics.width_px, intrinsics.height_px);
    if (hull.size() < 3 || hull.intersected(QPolygonF(image)).isEmpty()) return {};
    QPolygonF outline = convexHull(grown(hull, halo_px)).intersected(QPolygonF(image));
    if (outline.isClosed() && outline.size() > 1) outline.removeLast();
    return outline;
}

std::vector<CandidateOutline> candidateOutlines(const DetectionRecord& detection, const Photo& photo) {
    std::vector<CandidateOutline> outlines;
    if (!detection.field || !detection.candidates) return outlines;
    const Transform T_map_from_reference = detection.registration.T_reference_from_map.inverse();
    for (const Candidate& candidate : detection.candidates->candidates) {
        const auto& ids = photo.candidateIds;
        if (std::find(ids.begin(), ids.end(), candidate.id) == ids.end()) continue;
        std::vector<Eigen::Vector3d> voxels_map;
        voxels_map.reserve(candidate.voxels.size());
        for (const std::uint32_t voxel : candidate.voxels) {
            if (voxel < detection.field->points.size()) {
                voxels_map.push_back(T_map_from_reference * detection.field->points[voxel]);
            }
        }
        QPolygonF polygon = projectedOutline(voxels_map, detection.parameters.discrepancy.voxelSize_m,
                                             photo.T_map_from_camera, photo.intrinsics);
        if (!polygon.isEmpty()) outlines.push_back({candidate.id, std::move(polygon)});
    }
    return outlines;
}

}  // namespace fodscope
