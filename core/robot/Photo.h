// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/common/Camera.h"
#include "core/common/UtcTime.h"

namespace fodscope {

/// A photo as the robot sent it. The bytes are never changed.
struct Photo {
    /// "P-001", in order of arrival.
    std::string id;
    std::string waypointId;
    /// The request that it answers, e.g. "W-01/1/photo-1": goal, and the how manieth photo asked for with it.
    std::string requestId;
    std::vector<std::string> candidateIds;
    UtcTime taken;
    /// Optical frame (z forward, x right, y down; REP 103).
    Transform T_map_from_camera = Transform::Identity();
    CameraIntrinsics intrinsics;
    /// "image/jpeg" or "image/png".
    std::string mediaType;
    std::vector<std::byte> bytes;
    std::string sha256;
};

}  // namespace fodscope
