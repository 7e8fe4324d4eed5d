// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/common/Geometry.h"
#include "core/common/Progress.h"
#include "core/registration/PlaneFit.h"
#include "core/registration/Registration.h"
#include "core/registration/SurfacePatches.h"

namespace fodscope {

struct FittedPose {
    PlaneFit fit;
    /// Share of the map's surfaces, every direction counting alike, that lie in surfaces of the reference.
    double explained = 0.0;
};

/// Fits the surfaces of a map to those of a reference, from a start pose or from anywhere.
class PoseFitter {
  public:
    /// All must outlive this.
    PoseFitter(const SurfacePatches& map, const SurfacePatches& reference, const RegistrationSettings& settings,
               Progress& progress);

    /// Too few surfaces are no map.
    bool hasSurfaces() const;

    FittedPose from(const Transform& start) const;
    /// Poses from anywhere, finely fitted and all different, the best first.
    std::vector<FittedPose> fromAnywhere() const;
    double explained(const Transform& pose) const;

  private:
    FittedPose fine(const Transform& start, double firstLimit_m) const;
    std::vector<FittedPose> coarseFits() const;
    std::vector<FittedPose> fitsFrom(std::span<const Transform> starts, std::span<const std::uint32_t> sample,
                                     int iterations) const;
    bool isAmong(std::span<const Transform> known, const Transform& pose, double distance_m) const;

    const RegistrationSettings& settings_;
    Progress& progress_;
    const SurfacePatches& map_;
    const SurfacePatches& reference_;
    std::vector<std::uint32_t> glanceSample_;
    std::vector<std::uint32_t> coarseSample_;
    std::vector<std::uint32_t> scoreSample_;
    std::vector<std::uint32_t> planar_;
};

}  // namespace fodscope
