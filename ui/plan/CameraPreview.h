// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>

#include "core/inspection/InspectionState.h"
#include "ui/theme/Theme.h"

namespace fodscope {

/// What the robot's camera will have in its picture at a pose: the map's voxels as dots, the brighter the nearer, the
/// candidates in their colours. Not what it will look like: there is no light and no paint in a map.
/// @param width_px of the image; its height follows from the camera's
QImage cameraPreview(const DetectionRecord& detection, const CameraSettings& camera, const Pose2& pose_map,
                     int width_px, const Theme& theme);

}  // namespace fodscope
