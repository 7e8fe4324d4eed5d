// SPDX-License-Identifier: MIT
#include "ui/session/CandidateFinder.h"

namespace fodscope {

std::shared_ptr<const CandidateSet> CandidateFinder::find(const DetectionRecord& detection,
                                                          const std::shared_ptr<const DiscrepancyField>& field,
                                                          const CandidateSettings& settings, Progress& progress) {
    const std::lock_guard lock(mutex_);
    const Transform& T_reference_from_map = detection.registration.T_reference_from_map;
    const Frame frame{detection.parameters.discrepancy.voxelSize_m, detection.floorHeight_m,
                      T_reference_from_map.matrix()};
    if (!live_ || live_->field() != field || frame != frame_) {
        frame_ = frame;
        live_.emplace(field, frame.voxelSize_m, frame.floorHeight_m, T_reference_from_map);
    }
    return live_->find(settings, progress);
}

}  // namespace fodscope
