// SPDX-License-Identifier: MIT
#include "core/registration/PoseFitter.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/registration/PlanSearch.h"

namespace fodscope {
namespace {

constexpr const char* kFineStage = "aligning the map with the reference";
constexpr const char* kCoarseStage = "comparing coarse alignments";

constexpr std::size_t kProposals = 24;
constexpr std::size_t kGlanceSample = 400;
constexpr std::size_t kCoarseSample = 1500;
constexpr std::size_t kScoreSample = 6000;
constexpr int kGlanceIterations = 6;
constexpr int kCoarseIterations = 16;
constexpr double kCoarseTolerance_m = 1e-4;
/// What a coarse fit, or a glance, may still gain: poses that fall behind the best by more than the margin and this are
/// dropped.
constexpr double kCoarseReserve = 0.1;
constexpr double kGlanceReserve = 0.3;
/// Glances that move the map's parts by less than this from each other lead to the same pose.
constexpr double kSameGlance_m = 0.05;
/// A coarse fit is off by less than this.
constexpr double kFromCoarse_m = 0.1;
constexpr std::size_t kMostAlternatives = 5;
/// Poses that move the map's parts by less than this from each other are one.
constexpr double kSamePose_m = 0.15;
/// Patches on edges have no plane to fit.
constexpr double kLeastPlanarity = 0.2;
/// Fewer patches are no map.
constexpr std::size_t kLeastPatches = 30;

void sortByExplained(std::vector<FittedPose>& poses) {
    std::ranges::stable_sort(poses, [](const FittedPose& a, const FittedPose& b) { return a.explained > b.explained; });
}

}  // namespace

PoseFitter::PoseFitter(const SurfacePatches& map, const SurfacePatches& reference, const RegistrationSettings& settings,
                       Progress& progress)
    : settings_(settings),
      progress_(progress),
      map_(map),
      reference_(reference),
      glanceSample_(map.balancedSample(kGlanceSample)),
      coarseSample_(map.balancedSample(kCoarseSample)),
      scoreSample_(map.balancedSample(kScoreSample)) {
    for (std::uint32_t i = 0; i < map_.size(); ++i) {
        if (map_.all()[i].planarity >= kLeastPlanarity) planar_.push_back(i);
    }
}

bool PoseFitter::hasSurfaces() const {
    return planar_.size() >= kLeastPatches && reference_.size() >= kLeastPatches;
}

FittedPose PoseFitter::from(const Transform& start) const {
    return fine(start, settings_.maximumCorrespondence_m);
}

double PoseFitter::explained(const Transform& pose) const {
    PatchPairs pairs(map_, scoreSample_, reference_);
    return explainedShare(pairs, pose, settings_.overlapDistance_m, progress_);
}

std::vector<FittedPose> PoseFitter::fromAnywhere() const {
    std::vector<FittedPose> settled;
    std::vector<Transform> known;
    double best = 0.0;
    for (const FittedPose& coarse : coarseFits()) {
        if (settled.size() > kMostAlternatives) break;
        if (coarse.explained < best - settings_.ambiguityMargin - kCoarseReserve) continue;
        if (isAmong(known, coarse.fit.T_target_from_source, kSamePose_m)) continue;
        const FittedPose pose = fine(coarse.fit.T_target_from_source, kFromCoarse_m);
        if (isAmong(known, pose.fit.T_target_from_source, kSamePose_m)) continue;
        best = std::max(best, pose.explained);
        settled.push_back(pose);
        known.push_back(pose.fit.T_target_from_source);
    }
    sortByExplained(settled);
    return settled;
}

FittedPose PoseFitter::fine(const Transform& start, double firstLimit_m) const {
    PlaneFitSettings settings{settings_.maximumCorrespondence_m, settings_.maximumIterations};
    settings.firstLimit_m = firstLimit_m;
    PatchPairs pairs(map_, planar_, reference_);
    FittedPose pose{fitToPlanes(pairs, start, settings, kFineStage, progress_), 0.0};
    pose.explained = explained(pose.fit.T_target_from_source);
    return pose;
}

/// Coarse fits from the proposals of the search, and from the identity: nominal maps may lie there already. A few steps
/// with few patches tell which proposals lead nowhere, and which to the same pose.
std::vector<FittedPose> PoseFitter::coarseFits() const {
    std::vector<Transform> proposals = searchPlan(map_, reference_, kProposals, progress_);
    proposals.push_back(Transform::Identity());
    std::vector<Transform> promising;
    double best = 0.0;
    for (const FittedPose& glance : fitsFrom(proposals, glanceSample_, kGlanceIterations)) {
        best = std::max(best, glance.explained);
        if (glance.explained < best - settings_.ambiguityMargin - kGlanceReserve) break;
        if (!isAmong(promising, glance.fit.T_target_from_source, kSameGlance_m))
            promising.push_back(glance.fit.T_target_from_source);
    }
    return fitsFrom(promising, coarseSample_, kCoarseIterations);
}

/// A fit with some patches from each start, the best first.
std::vector<FittedPose> PoseFitter::fitsFrom(std::span<const Transform> starts, std::span<const std::uint32_t> sample,
                                             int iterations) const {
    progress_.report(kCoarseStage, 0.0);
    std::vector<FittedPose> fits(starts.size());
    const PlaneFitSettings settings{settings_.maximumCorrespondence_m, iterations, kCoarseTolerance_m};
    tbb::parallel_for(std::size_t{0}, starts.size(), [&](std::size_t i) {
        // Only the calling thread reports.
        Progress inner([&](const std::string&, double) { progress_.throwIfCancelled(); });
        PatchPairs pairs(map_, sample, reference_);
        fits[i].fit = fitToPlanes(pairs, starts[i], settings, kCoarseStage, inner);
        fits[i].explained = explainedShare(pairs, fits[i].fit.T_target_from_source, settings_.overlapDistance_m, inner);
    });
    sortByExplained(fits);
    return fits;
}

bool PoseFitter::isAmong(std::span<const Transform> known, const Transform& pose, double distance_m) const {
    return std::ranges::any_of(known, [&](const Transform& other) {
        double squares_m2 = 0.0;
        for (const std::uint32_t i : coarseSample_) {
            const Eigen::Vector3d& place = map_.all()[i].centre;
            squares_m2 += (pose * place - other * place).squaredNorm();
        }
        return squares_m2 < distance_m * distance_m * static_cast<double>(coarseSample_.size());
    });
}

}  // namespace fodscope
