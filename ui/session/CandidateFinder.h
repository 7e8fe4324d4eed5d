// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include "core/detection/LiveCandidates.h"
#include "core/inspection/InspectionState.h"

namespace fodscope {

/// Finds the candidates of a detection while their settings are moved. What it keeps from one call to the next serves
/// the previews and the settings that are kept in the end alike; threads take turns.
class CandidateFinder {
  public:
    /// @param field the detection's own, or the same with the local statistical test
    std::shared_ptr<const CandidateSet> find(const DetectionRecord& detection,
                                             const std::shared_ptr<const DiscrepancyField>& field,
                                             const CandidateSettings& settings, Progress& progress);

  private:
    /// What the candidates depend on beside field and settings.
    struct Frame {
        double voxelSize_m = 0.0;
        double floorHeight_m = 0.0;
        Eigen::Matrix4d T_reference_from_map = Eigen::Matrix4d::Identity();

        bool operator==(const Frame&) const = default;
    };

    std::mutex mutex_;
    Frame frame_;
    std::optional<LiveCandidates> live_;
};

}  // namespace fodscope
