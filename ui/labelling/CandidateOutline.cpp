// SPDX-License-Identifier: MIT
#include "ui/labelling/CandidateOutline.h"

#include <QRectF>
#include <algorithm>
#include <cmath>

#include "core/common/ConvexHull.h"
#include "core/inspection/PhotoProjection.h"

namespace fodscope {

namespace {

constexpr int kHaloCorners = 16;

std::vector<Eigen::Vector2d> grown(std::span<const Eigen::Vector2d> hull_px, double halo_px) {
    std::vector<Eigen::Vector2d> points;
    for (const Eigen::Vector2d& corner : hull_px) {
        for (int step = 0; step < kHaloCorners; ++step) {
            const double angle_rad = 2.0 * M_PI * step / kHaloCorners;
            points.emplace_back(corner.x() + halo_px * std::cos(angle_rad), corner.y() + halo_px * std::sin(angle_rad));
        }
    }
    return points;
}

QPolygonF polygonOf(std::span<const Eigen::Vector2d> corners_px) {
    QPolygonF polygon;
    for (const Eigen::Vector2d& corner : corners_px)
        polygon << QPointF(corner.x(), corner.y());
    return polygon;
}

}  // namespace

QPolygonF projectedOutline(std::span<const Eigen::Vector3d> voxels_map, double voxelSize_m,
                           const Transform& T_map_from_camera, const CameraIntrinsics& intrinsics, double halo_px) {
    const std::vector<Eigen::Vector2d> hull =
        projectVoxels(voxels_map, voxelSize_m, T_map_from_camera, intrinsics).hull_px;
    const QRectF image(0, 0, intrinsics.width_px, intrinsics.height_px);
    if (hull.size() < 3 || polygonOf(hull).intersected(QPolygonF(image)).isEmpty()) return {};
    QPolygonF outline = polygonOf(convexHull(grown(hull, halo_px))).intersected(QPolygonF(image));
    if (outline.isClosed() && outline.size() > 1) outline.removeLast();
    return outline;
}

std::vector<CandidateOutline> candidateOutlines(const DetectionRecord& detection, const Photo& photo) {
    std::vector<CandidateOutline> outlines;
    if (!detection.field || !detection.candidates) return outlines;
    for (const Candidate& candidate : detection.candidates->candidates) {
        const auto& ids = photo.candidateIds;
        if (std::find(ids.begin(), ids.end(), candidate.id) == ids.end()) continue;
        QPolygonF polygon =
            projectedOutline(voxelsInMap(candidate, detection), detection.parameters.discrepancy.voxelSize_m,
                             photo.T_map_from_camera, photo.intrinsics);
        if (!polygon.isEmpty()) outlines.push_back({candidate.id, std::move(polygon)});
    }
    return outlines;
}

}  // namespace fodscope
