// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "app/ros1_bridge/RosMessages.h"
#include "core/bridge/BridgeProtocol.h"

namespace fodscope::bridge {

/// A camera image as a photo.
struct Picture {
    /// JPEG or PNG; compressed images are left as they came.
    Bytes bytes;
    int width_px = 0;
    int height_px = 0;
};

/// @throws Error for images that are cut off, cannot be decoded, are larger than 100 megapixels, have an encoding that
///         is no photo, or are black all over
Picture pictureOf(const ImageMessage& message);

}  // namespace fodscope::bridge
