// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "core/evaluation/Evaluation.h"

namespace fodscope {

/// Photographs every candidate of a trial with the simulated robot in the trial's world FOLDER/NAME.json: planned and
/// driven as in an inspection, on the trial's grid where it has one, else on one made from its map. A photo shows a FOD
/// when at least GroundTruthLabeller::kLeastPixels of its 1280×720 pixels do. Nothing is kept of the photos.
/// @throws Error when a trial's world is missing; all that are missing are named at once. What it returns throws Error
///         naming the world when that is damaged or holds other FOD than the trial; Cancelled
PhotoTaker makePhotoTaker(const std::filesystem::path& worlds, std::span<const Trial> trials,
                          std::shared_ptr<const ReferenceMap> reference, const Parameters& parameters);

}  // namespace fodscope
