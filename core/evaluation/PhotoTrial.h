// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "core/evaluation/TrialSelection.h"
#include "core/inspection/GroundTruthLabeller.h"

namespace fodscope {

/// The world that a trial was mapped in, and what photos taken there show of the trial's FOD.
class PhotoTrial {
  public:
    /// @param file the trial's world
    /// @throws Error naming the world when it is damaged or holds other FOD than the trial
    PhotoTrial(const Trial& trial, const std::filesystem::path& file, const CameraSettings& camera);

    const std::shared_ptr<const World>& world() const { return world_; }
    Pose2 robotStart_map() const;

    /// @return 1 for each FOD of the trial, in its order, that covers at least GroundTruthLabeller::kLeastPixels of a
    ///         photo 1280 pixels wide taken there
    std::vector<std::uint8_t> fodSeenFrom(const Transform& T_map_from_camera) const;

  private:
    std::shared_ptr<const World> world_;
    std::vector<std::size_t> objects_;
    CameraIntrinsics intrinsics_;
    GroundTruthLabeller truth_;
};

/// The same view in another number of pixels.
CameraSettings scaledTo(CameraSettings camera, int width_px);

/// @return the world NAME.json of a trial
std::filesystem::path worldFile(const std::filesystem::path& worlds, const Trial& trial);

/// @throws Error naming all worlds that are missing; maps without FOD need none
void requireWorlds(const std::filesystem::path& worlds, std::span<const Trial> trials);

/// The trial's own grid where it has one, else one made from its map.
OccupancyGrid gridOf(const Trial& trial, const DetectionResult& detection, double floorHeight_m,
                     const OccupancySettings& settings);

}  // namespace fodscope
