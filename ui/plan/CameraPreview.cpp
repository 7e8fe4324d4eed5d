// SPDX-License-Identifier: MIT
#include "ui/plan/CameraPreview.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/theme/Colours.h"

namespace fodscope {
namespace {

/// Nearer voxels would cover the picture.
constexpr double kNearest_m = 0.1;
/// What lies farther is as dark as can be seen.
constexpr double kFarthest_m = 4.0;

struct Dot {
    double depth_m = 0.0;
    QRectF place;
    QColor colour;
};

QColor colourAt(double depth_m, const Theme& theme) {
    const double share = std::clamp(depth_m / kFarthest_m, 0.0, 1.0);
    return mixed(theme.text, theme.surface0, 0.25 + 0.6 * share);
}

}  // namespace

QImage cameraPreview(const DetectionRecord& detection, const CameraSettings& camera, const Pose2& pose_map,
                     int width_px, const Theme& theme) {
    const double scale = static_cast<double>(width_px) / camera.width_px;
    QImage image(width_px, std::max(1, static_cast<int>(std::lround(scale * camera.height_px))), QImage::Format_RGB32);
    image.fill(theme.surface0);
    if (!detection.field) return image;
    const CameraIntrinsics k = intrinsicsOf(camera);
    const Transform T_camera_from_floor = cameraPose(pose_map, camera).inverse();
    const Transform T_map_from_reference = detection.registration.T_reference_from_map.inverse();
    std::vector<QColor> colourOf(detection.field->size());
    if (detection.candidates) {
        for (const Candidate& candidate : detection.candidates->candidates)
            for (const std::uint32_t voxel : candidate.voxels)
                colourOf[voxel] = candidateColour(QString::fromStdString(candidate.id));
    }
    const double voxel_m = detection.parameters.discrepancy.voxelSize_m;
    std::vector<Dot> dots;
    for (std::size_t i = 0; i < detection.field->size(); ++i) {
        const Eigen::Vector3d& point_reference = detection.field->points[i];
        Eigen::Vector3d point = T_map_from_reference * point_reference;
        point.z() = point_reference.z() - detection.floorHeight_m;
        const Eigen::Vector3d seen = T_camera_from_floor * point;
        if (seen.z() < kNearest_m) continue;
        const Eigen::Vector2d pixel = scale * pixelOf(seen, k);
        const double edge = std::max(1.0, scale * k.fx_px * voxel_m / seen.z());
        const QRectF place(pixel.x() - 0.5 * edge, pixel.y() - 0.5 * edge, edge, edge);
        if (!place.intersects(image.rect())) continue;
        dots.push_back({seen.z(), place, colourOf[i].isValid() ? colourOf[i] : colourAt(seen.z(), theme)});
    }
    std::ranges::stable_sort(dots, std::greater<>(), &Dot::depth_m);
    QPainter painter(&image);
    for (const Dot& dot : dots)
        painter.fillRect(dot.place, dot.colour);
    return image;
}

}  // namespace fodscope
