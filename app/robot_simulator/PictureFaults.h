// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "app/robot_simulator/RobotModel.h"

/// What broken cameras send.
namespace fodscope::robot_simulator {

/// The lamps are out.
Picture blackened(Picture picture);
/// Cut off and with wrong bytes within, as after a bad cable.
Picture corrupted(Picture picture);
/// A header that claims another size than the data have.
Picture claimingSize(Picture picture, std::uint32_t width_px, std::uint32_t height_px);
/// A depth image in the format of compressed_depth_image_transport: 12 bytes of its own, then a PNG of 16 bit.
std::vector<std::uint8_t> compressedDepth(int width_px, int height_px);

}  // namespace fodscope::robot_simulator
