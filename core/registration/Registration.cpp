// SPDX-License-Identifier: MIT
#include "core/registration/Registration.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/cloud/VoxelGrid.h"
#include "core/common/Error.h"
#include "core/registration/NeighbourGraph.h"
#include "core/registration/PlanSearch.h"
#include "core/registration/PlaneFit.h"
#include "core/registration/PointFit.h"
#include "core/registration/RegistrationSummary.h"
#include "core/registration/SurfacePatches.h"

namespace fodscope {
namespace {

constexpr const char* kSurfaceStage = "finding the surfaces";
constexpr const char* kFineStage = "aligning the map with the reference";
constexpr const char* kCoarseStage = "comparing coarse alignments";
constexpr const char* kRefineStage = "refining the alignment";
constexpr const char* kJudgeStage = "judging the alignment";

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
/// A refinement that moves the map's parts by more than this does not refine.
constexpr double kFarthestRefinement_m = 0.05;
/// Patches on edges have no plane to fit.
constexpr double kLeastPlanarity = 0.2;
/// Fewer patches are no map.
constexpr std::size_t kLeastPatches = 30;

/// Voxel means on a lattice that starts half a voxel below the least coordinates (Open3D's).
std::vector<Eigen::Vector3d> voxelMeans(std::span<const Eigen::Vector3d> points, double voxelSize_m) {
    const Eigen::Vector3d origin = minimumCorner(points) - Eigen::Vector3d::Constant(voxelSize_m / 2.0);
    return voxelGrid(points, origin, {voxelSize_m}).points;
}

void requirePoints(std::span<const Eigen::Vector3d> map, std::span<const Eigen::Vector3d> reference) {
    if (map.empty()) throw Error("map", "has no points to align", "give a map with points");
    if (reference.empty()) throw Error("reference", "has no points to align with", "give a reference with points");
}

double diagonal_m(std::span<const Eigen::Vector3d> points) {
    return (maximumCorner(points) - minimumCorner(points)).norm();
}

/// Overlap and residual of poses, by the voxels of the map and all points of the reference.
class Judge {
  public:
    Judge(std::span<const Eigen::Vector3d> map, std::span<const Eigen::Vector3d> reference,
          const RegistrationSettings& settings, Progress& progress)
        : settings_(settings),
          progress_(progress),
          graph_(reference, progress),
          voxels_map_(voxelMeans(map, settings.mapVoxelSize_m)),
          pairs_(voxels_map_, graph_) {}

    PoseAlternative judged(const Transform& transform) {
        pairs_.moveTo(transform, progress_);
        const PointPairs::Closeness closeness = pairs_.within(settings_.overlapDistance_m);
        PoseAlternative judged;
        judged.T_reference_from_map = transform;
        judged.overlap = closeness.share;
        judged.rms_m = closeness.rms_m;
        return judged;
    }

    /// @return the pose refined point to point; empty when it does not settle, or leaves for somewhere else
    std::optional<Transform> refined(const Transform& pose) {
        const PointFitSettings settings{settings_.maximumCorrespondence_m, settings_.maximumIterations};
        const PointFit fit = fitToPoints(pairs_, pose, settings, kRefineStage, progress_);
        if (!fit.converged) return std::nullopt;
        double squares_m2 = 0.0;
        for (const Eigen::Vector3d& voxel : voxels_map_)
            squares_m2 += (fit.T_target_from_source * voxel - pose * voxel).squaredNorm();
        const double farthest_m2 = kFarthestRefinement_m * kFarthestRefinement_m;
        if (squares_m2 > farthest_m2 * static_cast<double>(voxels_map_.size())) return std::nullopt;
        return fit.T_target_from_source;
    }

  private:
    const RegistrationSettings& settings_;
    Progress& progress_;
    NeighbourGraph graph_;
    std::vector<Eigen::Vector3d> voxels_map_;
    PointPairs pairs_;
};

struct FittedPose {
    PlaneFit fit;
    double explained = 0.0;
};

/// The surfaces of map and reference, and the fits between them.
class Fitter {
  public:
    Fitter(std::span<const Eigen::Vector3d> map, std::span<const Eigen::Vector3d> reference,
           const RegistrationSettings& settings, Progress& progress)
        : settings_(settings),
          progress_(progress),
          map_(map, settings.coarseVoxelSize_m, progress),
          reference_(reference, settings.coarseVoxelSize_m, progress),
          glanceSample_(map_.balancedSample(kGlanceSample)),
          coarseSample_(map_.balancedSample(kCoarseSample)),
          scoreSample_(map_.balancedSample(kScoreSample)) {
        for (std::uint32_t i = 0; i < map_.size(); ++i) {
            if (map_.all()[i].planarity >= kLeastPlanarity) planar_.push_back(i);
        }
    }

    bool hasSurfaces() const { return planar_.size() >= kLeastPatches && reference_.size() >= kLeastPatches; }

    FittedPose fine(const Transform& start) const { return fine(start, settings_.maximumCorrespondence_m); }

    double explained(const Transform& pose) const {
        PatchPairs pairs(map_, scoreSample_, reference_);
        return explainedShare(pairs, pose, settings_.overlapDistance_m, progress_);
    }

    /// Poses from anywhere, finely fitted and all different, the best first.
    std::vector<FittedPose> fromAnywhere() const {
        std::vector<FittedPose> fine;
        std::vector<Transform> known;
        double best = 0.0;
        for (const FittedPose& pose : coarseFits()) {
            if (fine.size() > kMostAlternatives) break;
            if (pose.explained < best - settings_.ambiguityMargin - kCoarseReserve) continue;
            if (isAmong(known, pose.fit.T_target_from_source, kSamePose_m)) continue;
            const FittedPose settled = this->fine(pose.fit.T_target_from_source, kFromCoarse_m);
            if (isAmong(known, settled.fit.T_target_from_source, kSamePose_m)) continue;
            best = std::max(best, settled.explained);
            fine.push_back(settled);
            known.push_back(settled.fit.T_target_from_source);
        }
        std::ranges::stable_sort(fine,
                                 [](const FittedPose& a, const FittedPose& b) { return a.explained > b.explained; });
        return fine;
    }

  private:
    FittedPose fine(const Transform& start, double firstLimit_m) const {
        PlaneFitSettings settings{settings_.maximumCorrespondence_m, settings_.maximumIterations};
        settings.firstLimit_m = firstLimit_m;
        PatchPairs pairs(map_, planar_, reference_);
        FittedPose pose{fitToPlanes(pairs, start, settings, kFineStage, progress_), 0.0};
        pose.explained = explained(pose.fit.T_target_from_source);
        return pose;
    }

    /// Coarse fits from the proposals of the search, and from the identity: nominal maps may lie there already. A few
    /// steps with few patches tell which proposals lead nowhere, and which to the same pose.
    std::vector<FittedPose> coarseFits() const {
        std::vector<Transform> proposals = searchPlan(map_, reference_, kProposals, progress_);
        proposals.push_back(Transform::Identity());
        std::vector<Transform> promising;
        double best = 0.0;
        for (const FittedPose& pose : fitsFrom(proposals, glanceSample_, kGlanceIterations)) {
            best = std::max(best, pose.explained);
            if (pose.explained < best - settings_.ambiguityMargin - kGlanceReserve) break;
            if (!isAmong(promising, pose.fit.T_target_from_source, kSameGlance_m))
                promising.push_back(pose.fit.T_target_from_source);
        }
        return fitsFrom(promising, coarseSample_, kCoarseIterations);
    }

    /// A fit with some patches from each start, the best first.
    std::vector<FittedPose> fitsFrom(std::span<const Transform> starts, std::span<const std::uint32_t> sample,
                                     int iterations) const {
        progress_.report(kCoarseStage, 0.0);
        std::vector<FittedPose> fits(starts.size());
        const PlaneFitSettings settings{settings_.maximumCorrespondence_m, iterations, kCoarseTolerance_m};
        tbb::parallel_for(std::size_t{0}, starts.size(), [&](std::size_t i) {
            Progress inner([&](const std::string&, double) { progress_.throwIfCancelled(); });
            PatchPairs pairs(map_, sample, reference_);
            fits[i].fit = fitToPlanes(pairs, starts[i], settings, kCoarseStage, inner);
            fits[i].explained =
                explainedShare(pairs, fits[i].fit.T_target_from_source, settings_.overlapDistance_m, inner);
        });
        std::ranges::stable_sort(fits,
                                 [](const FittedPose& a, const FittedPose& b) { return a.explained > b.explained; });
        return fits;
    }

    bool isAmong(std::span<const Transform> known, const Transform& pose, double distance_m) const {
        return std::ranges::any_of(known, [&](const Transform& other) {
            double squares_m2 = 0.0;
            for (const std::uint32_t i : coarseSample_) {
                const Eigen::Vector3d& place = map_.all()[i].centre;
                squares_m2 += (pose * place - other * place).squaredNorm();
            }
            return squares_m2 < distance_m * distance_m * static_cast<double>(coarseSample_.size());
        });
    }

    const RegistrationSettings& settings_;
    Progress& progress_;
    SurfacePatches map_;
    SurfacePatches reference_;
    std::vector<std::uint32_t> glanceSample_;
    std::vector<std::uint32_t> coarseSample_;
    std::vector<std::uint32_t> scoreSample_;
    std::vector<std::uint32_t> planar_;
};

/// One registration: fits, judges and decides.
class Alignment {
  public:
    Alignment(std::span<const Eigen::Vector3d> map, std::span<const Eigen::Vector3d> reference,
              const RegistrationSettings& settings, Progress& progress)
        : settings_(settings),
          progress_(progress),
          fitter_(map, reference, settings, progress),
          judge_(map, reference, settings, progress) {}

    RegistrationResult aligned(const std::optional<Transform>& start) {
        RegistrationResult result = fitted(start);
        // What the map does not hold, the nearest points do not hold either.
        const bool isHeld = !isLoose(result);
        if (settings_.refinement != Refinement::PointToPoint || !isTrusted(result.quality) || !isHeld) return result;
        const std::optional<Transform> refined = judge_.refined(result.T_reference_from_map);
        if (!refined) return result;
        const PoseAlternative judged = judge_.judged(*refined);
        result.T_reference_from_map = *refined;
        result.overlap = judged.overlap;
        result.rms_m = judged.rms_m;
        result.explained = fitter_.explained(*refined);
        return result;
    }

  private:
    RegistrationResult fitted(const std::optional<Transform>& start) {
        if (!fitter_.hasSurfaces()) {
            RegistrationResult nothing = resultOf({}, start);
            nothing.T_reference_from_map = start.value_or(Transform::Identity());
            nothing.converged = false;
            return nothing;
        }
        if (start) {
            RegistrationResult near = resultOf(fitter_.fine(*start), start);
            // A turn or two directions that nothing holds leave too much to a start pose.
            near.quality = fits(near) && !isFarTooLoose(near) ? RegistrationQuality::Good : RegistrationQuality::Bad;
            if (near.quality == RegistrationQuality::Good || fits(near)) return near;
            RegistrationResult elsewhere = searched(start);
            return fits(elsewhere) ? elsewhere : near;
        }
        return searched(start);
    }

    RegistrationResult resultOf(const FittedPose& pose, const std::optional<Transform>& start) {
        const PoseAlternative judged = judge_.judged(pose.fit.T_target_from_source);
        RegistrationResult result;
        result.T_reference_from_map = judged.T_reference_from_map;
        result.converged = pose.fit.converged;
        result.rms_m = judged.rms_m;
        result.overlap = judged.overlap;
        result.explained = pose.explained;
        result.uncertainty = pose.fit.uncertainty;
        result.start_T_reference_from_map = start;
        return result;
    }

    bool fits(const RegistrationResult& result) const {
        return result.converged.value_or(false) && result.overlap >= settings_.minimumOverlap &&
               result.explained >= settings_.minimumExplained;
    }

    static bool isLoose(const RegistrationResult& result) {
        return result.uncertainty && result.uncertainty->isLoose();
    }

    static bool isFarTooLoose(const RegistrationResult& result) {
        return result.uncertainty && (result.uncertainty->looseTurn || result.uncertainty->looseDirections.size() > 1);
    }

    RegistrationResult searched(const std::optional<Transform>& start) {
        const std::vector<FittedPose> poses = fitter_.fromAnywhere();
        RegistrationResult result = resultOf(poses.front(), start);
        if (!fits(result) || isFarTooLoose(result)) return result;
        for (std::size_t i = 1; i < poses.size(); ++i) {
            if (!poses[i].fit.converged || poses[i].explained < result.explained - settings_.ambiguityMargin) continue;
            PoseAlternative other = judge_.judged(poses[i].fit.T_target_from_source);
            other.explained = poses[i].explained;
            if (other.overlap >= settings_.minimumOverlap && other.explained >= settings_.minimumExplained)
                result.alternatives.push_back(other);
        }
        const bool doubtful = start || !result.alternatives.empty() || isLoose(result);
        result.quality = doubtful ? RegistrationQuality::Ambiguous : RegistrationQuality::Good;
        return result;
    }

    const RegistrationSettings& settings_;
    Progress& progress_;
    Fitter fitter_;
    Judge judge_;
};

}  // namespace

RegistrationResult registerMap(std::span<const Eigen::Vector3d> map, std::span<const Eigen::Vector3d> reference,
                               const std::optional<Transform>& start_T_reference_from_map,
                               const RegistrationSettings& settings, Progress& progress) {
    requirePoints(map, reference);
    progress.report(kSurfaceStage, 0.0);
    const double scale = diagonal_m(map) / std::max(diagonal_m(reference), 1e-9);
    const bool sizesAgree = scale <= kAbsurdScale && scale >= 1.0 / kAbsurdScale;
    RegistrationResult result;
    if (sizesAgree) {
        result = Alignment(map, reference, settings, progress).aligned(start_T_reference_from_map);
    } else {
        result.converged = false;
        result.start_T_reference_from_map = start_T_reference_from_map;
    }
    result.summary = result.quality == RegistrationQuality::Good        ? goodSummary(result)
                     : result.quality == RegistrationQuality::Ambiguous ? ambiguousSummary(result)
                                                                        : badSummary(result, settings, scale);
    return result;
}

RegistrationResult judgeTransform(std::span<const Eigen::Vector3d> map, std::span<const Eigen::Vector3d> reference,
                                  const Transform& T_reference_from_map, const RegistrationSettings& settings,
                                  Progress& progress) {
    requirePoints(map, reference);
    progress.report(kJudgeStage, 0.0);
    const PoseAlternative judged = Judge(map, reference, settings, progress).judged(T_reference_from_map);
    RegistrationResult result;
    result.T_reference_from_map = T_reference_from_map;
    result.quality = RegistrationQuality::Given;
    result.rms_m = judged.rms_m;
    result.overlap = judged.overlap;
    result.summary = givenSummary(result, settings);
    return result;
}

}  // namespace fodscope
