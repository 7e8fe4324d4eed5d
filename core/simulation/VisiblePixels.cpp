// SPDX-License-Identifier: MIT
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/common/Error.h"
#include "core/simulation/MeshShapes.h"
#include "core/simulation/PhotoCamera.h"

namespace fodscope {
namespace {

/// Half-open ranges of pixels.
struct PixelRange {
    int left = 0, top = 0, right = 0, bottom = 0;

    bool contains(int column, int row) const { return column >= left && column < right && row >= top && row < bottom; }
};

/// A rectangle of pixels outside which the object cannot be seen.
PixelRange pixelsOf(const Eigen::AlignedBox3d& box_world, const Transform& T_camera_from_world,
                    const CameraIntrinsics& intrinsics) {
    constexpr double kNear_m = 1e-3;
    const PixelRange whole{0, 0, intrinsics.width_px, intrinsics.height_px};
    double left = intrinsics.width_px, top = intrinsics.height_px, right = 0.0, bottom = 0.0;
    int behind = 0;
    for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3d corner_camera =
            T_camera_from_world * box_world.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
        if (corner_camera.z() < kNear_m) {
            ++behind;
            continue;
        }
        const double column = intrinsics.cx_px + intrinsics.fx_px * corner_camera.x() / corner_camera.z();
        const double row = intrinsics.cy_px + intrinsics.fy_px * corner_camera.y() / corner_camera.z();
        left = std::min(left, column);
        right = std::max(right, column);
        top = std::min(top, row);
        bottom = std::max(bottom, row);
    }
    if (behind == 8) return {};
    // A box through the image plane projects to no rectangle.
    if (behind > 0) return whole;
    const auto limit = [](double value, int most) {
        return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(most)));
    };
    return {limit(std::floor(left) - 1.0, intrinsics.width_px), limit(std::floor(top) - 1.0, intrinsics.height_px),
            limit(std::ceil(right) + 1.0, intrinsics.width_px), limit(std::ceil(bottom) + 1.0, intrinsics.height_px)};
}

void add(VisibleObject& seen, const VisibleObject& more) {
    if (more.pixels == 0) return;
    if (seen.pixels == 0) {
        seen = more;
        return;
    }
    seen = {seen.pixels + more.pixels, std::min(seen.left_px, more.left_px), std::min(seen.top_px, more.top_px),
            std::max(seen.right_px, more.right_px), std::max(seen.bottom_px, more.bottom_px)};
}

}  // namespace

std::vector<VisibleObject> visibleObjects(const World& world, const Raycaster& raycaster,
                                          const Transform& T_world_from_camera, const CameraIntrinsics& intrinsics) {
    constexpr double kRange_m = 1000.0;
    const Transform T_camera_from_world = T_world_from_camera.inverse();
    std::vector<PixelRange> boxes;
    PixelRange all{intrinsics.width_px, intrinsics.height_px, 0, 0};
    for (const WorldObject& object : world.objects) {
        const Eigen::AlignedBox3d bounds = boundsOf(object.mesh);
        const PixelRange box = bounds.isEmpty() ? PixelRange{} : pixelsOf(bounds, T_camera_from_world, intrinsics);
        boxes.push_back(box);
        if (box.left >= box.right || box.top >= box.bottom) continue;
        all = {std::min(all.left, box.left), std::min(all.top, box.top), std::max(all.right, box.right),
               std::max(all.bottom, box.bottom)};
    }
    // Sums and extremes do not depend on which thread saw what.
    tbb::enumerable_thread_specific<std::vector<VisibleObject>> seenByThread(
        std::vector<VisibleObject>(world.objects.size()));
    if (all.left < all.right && all.top < all.bottom) {
        tbb::parallel_for(tbb::blocked_range<int>(all.top, all.bottom, 8), [&](const tbb::blocked_range<int>& rows) {
            std::vector<VisibleObject>& seen = seenByThread.local();
            for (int row = rows.begin(); row < rows.end(); ++row) {
                for (int column = all.left; column < all.right; ++column) {
                    if (std::none_of(boxes.begin(), boxes.end(),
                                     [&](const PixelRange& box) { return box.contains(column, row); }))
                        continue;
                    const Eigen::Vector3d ray_camera((column + 0.5 - intrinsics.cx_px) / intrinsics.fx_px,
                                                     (row + 0.5 - intrinsics.cy_px) / intrinsics.fy_px, 1.0);
                    const auto hit = raycaster.cast(T_world_from_camera.translation(),
                                                    T_world_from_camera.linear() * ray_camera, kRange_m);
                    if (hit && hit->object >= 0)
                        add(seen[static_cast<std::size_t>(hit->object)], {1, column, row, column + 1, row + 1});
                }
            }
        });
    }
    std::vector<VisibleObject> seen(world.objects.size());
    for (const std::vector<VisibleObject>& part : seenByThread) {
        for (std::size_t i = 0; i < seen.size(); ++i)
            add(seen[i], part[i]);
    }
    return seen;
}

std::vector<std::size_t> visiblePixels(const World& world, const Raycaster& raycaster,
                                       const Transform& T_world_from_camera, const CameraIntrinsics& intrinsics) {
    std::vector<std::size_t> counts;
    for (const VisibleObject& object : visibleObjects(world, raycaster, T_world_from_camera, intrinsics))
        counts.push_back(object.pixels);
    return counts;
}

}  // namespace fodscope
