// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/cloud/PointCloud.h"
#include "core/inspection/Parameters.h"
#include "core/reference/ReferenceMap.h"

namespace fodscope {

/// The results of the stages from map to candidates. Every stage's result is kept and shared, never changed.
struct DetectionResult {
    std::shared_ptr<const PointCloud> denoisedMap;
    RegistrationResult registration;
    /// Null when the alignment is bad: no candidates are claimed from it.
    std::shared_ptr<const DiscrepancyField> field;
    std::shared_ptr<const CandidateSet> candidates;
    std::shared_ptr<const Coverage> coverage;
    double floorHeight_m = 0.0;
    /// Wall time of each stage that was run for this result.
    std::map<std::string, double> stageSeconds;
};

/// The paper's pipeline from a map to candidates: denoise → register → discrepancy → candidates, and coverage. It keeps
/// the result of every stage with the settings that made it, and run() starts at the first stage that changed. Used
/// from one thread at a time.
class DetectionPipeline {
  public:
    void setReference(std::shared_ptr<const ReferenceMap> reference);
    void setMap(std::shared_ptr<const PointCloud> map);
    /// A transform given by the user replaces the registration; empty goes back to registering.
    void setGivenTransform(std::optional<Transform> T_reference_from_map);

    /// @throws Error when reference or map are missing, or from a stage; Cancelled. The last good result is then kept.
    const DetectionResult& run(const Parameters& parameters, Progress& progress);

  private:
    std::shared_ptr<const ReferenceMap> reference_;
    std::shared_ptr<const PointCloud> map_;
    std::optional<Transform> givenTransform_;
    std::optional<Parameters> ran_;
    DetectionResult result_;
};

}  // namespace fodscope
