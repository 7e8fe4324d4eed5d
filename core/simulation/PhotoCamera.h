// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/common/Camera.h"
#include "core/common/Progress.h"
#include "core/simulation/Raycaster.h"

namespace fodscope {

/// The photo camera with a headlight.
struct PhotoCameraSettings : CameraSettings {
    /// Of the image noise; paint and rust belong to the world.
    std::uint64_t seed = 1;
};

/// A colour image as JPEG: headlight with distance and angle fall-off, paint, rust, noise.
/// @throws Cancelled within a few rows of the image
std::vector<std::byte> renderPhoto(const World& world, const Raycaster& raycaster, const Transform& T_world_from_camera,
                                   const PhotoCameraSettings& settings, const Progress& progress = Progress());

/// What of an object a photo shows. The rectangle is half open and empty where nothing is seen.
struct VisibleObject {
    std::size_t pixels = 0;
    int left_px = 0;
    int top_px = 0;
    int right_px = 0;
    int bottom_px = 0;
};

/// @return for each object of the world how many pixels of such a photo show it, and the rectangle that holds them
std::vector<VisibleObject> visibleObjects(const World& world, const Raycaster& raycaster,
                                          const Transform& T_world_from_camera, const CameraIntrinsics& intrinsics);

/// @return for each object of the world how many pixels of such a photo show it
std::vector<std::size_t> visiblePixels(const World& world, const Raycaster& raycaster,
                                       const Transform& T_world_from_camera, const CameraIntrinsics& intrinsics);

}  // namespace fodscope
