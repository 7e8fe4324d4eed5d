// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/cloud/PointCloud.h"
#include "core/detection/LiveCandidates.h"
#include "core/inspection/Parameters.h"
#include "core/reference/ReferenceMap.h"

namespace fodscope {

/// The results of the stages from map to candidates. Every stage's result is kept and shared, never changed.
struct DetectionResult {
    std::shared_ptr<const PointCloud> denoisedMap;
    RegistrationResult registration;
    /// Null when the alignment is bad or ambiguous: no candidates are claimed from it.
    std::shared_ptr<const DiscrepancyField> field;
    std::shared_ptr<const CandidateSet> candidates;
    std::shared_ptr<const Coverage> coverage;
    double floorHeight_m = 0.0;
    /// Wall time of each stage that was run for this result.
    std::map<std::string, double> stageSeconds;
};

/// The last stage of a run. What comes after the discrepancy is quick to redo, and not needed by those who search for
/// its settings.
enum class PipelineEnd { Discrepancy, Coverage };

/// The paper's pipeline from a map to candidates: denoise → register → discrepancy → candidates, and coverage. It keeps
/// the result of every stage with the settings that made it, and run() starts at the first stage that changed. Used
/// from one thread at a time.
class DetectionPipeline {
  public:
    void setReference(std::shared_ptr<const ReferenceMap> reference);
    void setMap(std::shared_ptr<const PointCloud> map);
    /// A map that nobody else needs. Its outliers are removed from it in place, so that memory holds it once and not
    /// twice; a run with other settings of the outlier removal then needs the map anew.
    void giveMap(PointCloud map);
    /// A transform given by the user replaces the registration; empty goes back to registering.
    void setGivenTransform(std::optional<Transform> T_reference_from_map);

    /// A known start pose, from which the registration sets out instead of searching all poses. To choose one of the
    /// poses of an ambiguous registration, give it here.
    void setStart(std::optional<Transform> T_reference_from_map);

    /// @throws Error when reference or map are missing, or from a stage; Cancelled. The last good result is then kept.
    /// Candidates and coverage of the result are null when it ends before them.
    const DetectionResult& run(const Parameters& parameters, Progress& progress,
                               PipelineEnd end = PipelineEnd::Coverage);

  private:
    using Seconds = std::map<std::string, double>;

    /// The latest result of each stage with the settings that made it; no settings: it has to run (again).
    struct Kept {
        std::optional<OutlierRemovalSettings> denoiseSettings;
        std::shared_ptr<const PointCloud> denoised;
        std::optional<RegistrationSettings> registrationSettings;
        RegistrationResult registration;
        std::optional<DiscrepancySettings> discrepancySettings;
        std::shared_ptr<const DiscrepancyField> field;
        /// The field with the local statistical test: only made for the metric that needs it.
        std::optional<LocalStatisticalTestSettings> testSettings;
        std::shared_ptr<const DiscrepancyField> testedField;
        std::optional<CandidateSettings> candidateSettings;
        std::shared_ptr<const CandidateSet> candidates;
        /// Finds them anew when only their settings changed.
        std::optional<LiveCandidates> live;
        std::optional<CoverageSettings> coverageSettings;
        std::shared_ptr<const Coverage> coverage;
        std::optional<double> floorHeight_m;
    };

    /// Discrepancy and what rests on it have to run again.
    void forgetDiscrepancy();
    void denoise(const OutlierRemovalSettings& settings, Seconds& seconds, Progress& progress);
    void align(const RegistrationSettings& settings, Seconds& seconds, Progress& progress);
    void measure(const DiscrepancySettings& settings, Seconds& seconds, Progress& progress);
    void test(const LocalStatisticalTestSettings& settings, Seconds& seconds, Progress& progress);
    void cluster(const Parameters& parameters, Seconds& seconds, Progress& progress);
    void cover(const Parameters& parameters, Seconds& seconds, Progress& progress);
    /// With the local statistical test if and only if the metric needs it.
    const std::shared_ptr<const DiscrepancyField>& fieldFor(Metric metric) const;

    std::shared_ptr<const ReferenceMap> reference_;
    std::shared_ptr<const PointCloud> map_;
    /// The same one when it was given, until it was denoised.
    std::shared_ptr<PointCloud> givenMap_;
    /// Looked through once, not for every moved threshold.
    bool inputsAreFinite_ = false;
    std::optional<Transform> givenTransform_;
    std::optional<Transform> start_;
    Kept kept_;
    DetectionResult result_;
};

}  // namespace fodscope
