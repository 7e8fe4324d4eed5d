// SPDX-License-Identifier: MIT
#include "core/inspection/DetectionPipeline.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/cloud/Bounds.h"
#include "core/common/Error.h"
#include "core/inspection/ParameterTable.h"

namespace fodscope {
namespace {

/// Adds the time until its end to a stage.
class StageClock {
  public:
    StageClock(std::map<std::string, double>& seconds, std::string stage)
        : seconds_(seconds), stage_(std::move(stage)), begin_(std::chrono::steady_clock::now()) {}
    ~StageClock() {
        seconds_[stage_] += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    }
    StageClock(const StageClock&) = delete;
    StageClock& operator=(const StageClock&) = delete;

  private:
    std::map<std::string, double>& seconds_;
    std::string stage_;
    std::chrono::steady_clock::time_point begin_;
};

void requireFinite(const std::string& subject, const std::vector<Eigen::Vector3d>& points) {
    if (!boundsOf(points).areFinite) throw Error(subject, "a coordinate is not finite", "drop such points first");
}

void requireGood(const Parameters& parameters) {
    std::string text;
    for (const std::string& problem : parameterProblems(parameters))
        text += (text.empty() ? "" : ", ") + problem;
    if (!text.empty()) throw Error("parameters", text, "give values that are allowed");
}

}  // namespace

void DetectionPipeline::setReference(std::shared_ptr<const ReferenceMap> reference) {
    reference_ = std::move(reference);
    inputsAreFinite_ = false;
    kept_.registrationSettings.reset();
    kept_.floorHeight_m.reset();
    forgetDiscrepancy();
}

void DetectionPipeline::setMap(std::shared_ptr<const PointCloud> map) {
    map_ = std::move(map);
    givenMap_.reset();
    inputsAreFinite_ = false;
    kept_.denoiseSettings.reset();
    kept_.registrationSettings.reset();
    forgetDiscrepancy();
}

void DetectionPipeline::giveMap(PointCloud map) {
    auto given = std::make_shared<PointCloud>(std::move(map));
    setMap(given);
    givenMap_ = std::move(given);
}

void DetectionPipeline::setGivenTransform(std::optional<Transform> T_reference_from_map) {
    const bool same = givenTransform_.has_value() == T_reference_from_map.has_value() &&
                      (!givenTransform_ || givenTransform_->matrix() == T_reference_from_map->matrix());
    if (same) return;
    givenTransform_ = T_reference_from_map;
    kept_.registrationSettings.reset();
}

void DetectionPipeline::setStart(std::optional<Transform> T_reference_from_map) {
    const bool same = start_.has_value() == T_reference_from_map.has_value() &&
                      (!start_ || start_->matrix() == T_reference_from_map->matrix());
    if (same) return;
    start_ = T_reference_from_map;
    kept_.registrationSettings.reset();
}

void DetectionPipeline::forgetDiscrepancy() {
    kept_.discrepancySettings.reset();
    kept_.testSettings.reset();
    kept_.testedField.reset();
    kept_.candidateSettings.reset();
    kept_.live.reset();
    kept_.coverageSettings.reset();
}

void DetectionPipeline::denoise(const OutlierRemovalSettings& settings, Seconds& seconds, Progress& progress) {
    if (kept_.denoiseSettings == settings) return;
    const StageClock clock(seconds, "denoise");
    std::shared_ptr<const PointCloud> denoised = map_;
    if (settings.enabled) {
        const auto indices = keptByOutlierRemoval(map_->points, settings, progress);
        if (indices.empty()) {
            throw Error("map", "has no points left after outlier removal",
                        "check that the file holds a whole map, or switch the outlier removal off");
        }
        if (givenMap_) {
            keepOnly(*givenMap_, indices);
            map_.reset();
        } else if (indices.size() < map_->size()) {
            denoised = std::make_shared<PointCloud>(select(*map_, indices));
        }
    }
    // It is the result's too from now on, and results never change.
    givenMap_.reset();
    kept_.denoised = std::move(denoised);
    kept_.denoiseSettings = settings;
    kept_.registrationSettings.reset();
    forgetDiscrepancy();
}

void DetectionPipeline::align(const RegistrationSettings& settings, Seconds& seconds, Progress& progress) {
    if (kept_.registrationSettings == settings) return;
    const StageClock clock(seconds, "registration");
    const RegistrationResult aligned =
        givenTransform_
            ? judgeTransform(kept_.denoised->points, reference_->points, *givenTransform_, settings, progress)
            : registerMap(kept_.denoised->points, reference_->points, start_, settings, progress);
    const bool moved = aligned.T_reference_from_map.matrix() != kept_.registration.T_reference_from_map.matrix();
    kept_.registration = aligned;
    kept_.registrationSettings = settings;
    if (moved) forgetDiscrepancy();
}

void DetectionPipeline::measure(const DiscrepancySettings& settings, Seconds& seconds, Progress& progress) {
    if (kept_.discrepancySettings == settings) return;
    const StageClock clock(seconds, "discrepancy");
    kept_.field = std::make_shared<DiscrepancyField>(measureDiscrepancy(
        kept_.denoised->points, kept_.registration.T_reference_from_map, *reference_, settings, progress));
    forgetDiscrepancy();
    kept_.discrepancySettings = settings;
}

void DetectionPipeline::test(const LocalStatisticalTestSettings& settings, Seconds& seconds, Progress& progress) {
    if (kept_.testSettings == settings) return;
    const StageClock clock(seconds, "chi_square");
    kept_.testedField = std::make_shared<DiscrepancyField>(withChiSquare(*kept_.field, settings, progress));
    kept_.testSettings = settings;
    kept_.candidateSettings.reset();
}

const std::shared_ptr<const DiscrepancyField>& DetectionPipeline::fieldFor(Metric metric) const {
    return metric == Metric::ChiSquare ? kept_.testedField : kept_.field;
}

void DetectionPipeline::cluster(const Parameters& parameters, Seconds& seconds, Progress& progress) {
    if (kept_.candidateSettings == parameters.candidates) return;
    const StageClock clock(seconds, "candidates");
    if (!kept_.floorHeight_m) kept_.floorHeight_m = floorHeight(*reference_);
    const auto& field = fieldFor(parameters.candidates.metric);
    if (!kept_.live || kept_.live->field() != field) {
        kept_.live.emplace(field, parameters.discrepancy.voxelSize_m, *kept_.floorHeight_m,
                           kept_.registration.T_reference_from_map);
    }
    kept_.candidates = kept_.live->find(parameters.candidates, progress);
    kept_.candidateSettings = parameters.candidates;
}

void DetectionPipeline::cover(const Parameters& parameters, Seconds& seconds, Progress& progress) {
    if (kept_.coverageSettings == parameters.coverage) return;
    const StageClock clock(seconds, "coverage");
    kept_.coverage = std::make_shared<Coverage>(
        measureCoverage(*reference_, *kept_.field, parameters.discrepancy, parameters.coverage, progress));
    kept_.coverageSettings = parameters.coverage;
}

const DetectionResult& DetectionPipeline::run(const Parameters& parameters, Progress& progress, PipelineEnd end) {
    if (!reference_ || reference_->points.empty()) {
        throw Error("reference", "is missing", "choose a reference map first");
    }
    const bool isGivenAndDenoised = !map_ && kept_.denoiseSettings == parameters.denoise;
    if (!isGivenAndDenoised && (!map_ || map_->empty())) throw Error("map", "is missing", "choose a map first");
    if (parameters.candidates.metric == Metric::Mahalanobis && !reference_->hasCovariance()) {
        throw Error("reference", "has no covariances, which the Mahalanobis metric needs",
                    "use the Euclidean metric, or a reference made from nominal maps");
    }
    if (!inputsAreFinite_) {
        requireFinite("reference", reference_->points);
        requireFinite("map", (map_ ? map_ : kept_.denoised)->points);
        inputsAreFinite_ = true;
    }
    requireGood(parameters);
    Seconds seconds;
    denoise(parameters.denoise, seconds, progress);
    align(parameters.registration, seconds, progress);
    DetectionResult next;
    next.denoisedMap = kept_.denoised;
    next.registration = kept_.registration;
    if (isTrusted(kept_.registration.quality)) {
        measure(parameters.discrepancy, seconds, progress);
        if (parameters.candidates.metric == Metric::ChiSquare) test(parameters.chiSquare, seconds, progress);
        next.field = fieldFor(parameters.candidates.metric);
        if (end == PipelineEnd::Coverage) {
            cluster(parameters, seconds, progress);
            cover(parameters, seconds, progress);
            next.candidates = kept_.candidates;
            next.coverage = kept_.coverage;
        }
    }
    if (!kept_.floorHeight_m) kept_.floorHeight_m = floorHeight(*reference_);
    next.floorHeight_m = *kept_.floorHeight_m;
    next.stageSeconds = seconds;
    result_ = std::move(next);
    return result_;
}

}  // namespace fodscope
