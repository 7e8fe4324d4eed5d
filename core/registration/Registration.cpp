// SPDX-License-Identifier: MIT
#include "core/registration/Registration.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/cloud/VoxelGrid.h"
#include "core/common/Error.h"
#include "core/registration/NeighbourGraph.h"
#include "core/registration/PointFit.h"
#include "core/registration/PoseFitter.h"
#include "core/registration/RegistrationSummary.h"
#include "core/registration/SurfacePatches.h"

namespace fodscope {
namespace {

constexpr const char* kSurfaceStage = "finding the surfaces";
constexpr const char* kRefineStage = "refining the alignment";
constexpr const char* kJudgeStage = "judging the alignment";

/// A refinement that moves the map's parts by more than this does not refine.
constexpr double kFarthestRefinement_m = 0.05;

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

/// One registration: fits, judges and decides.
class Alignment {
  public:
    Alignment(std::span<const Eigen::Vector3d> map, std::span<const Eigen::Vector3d> reference,
              const RegistrationSettings& settings, Progress& progress)
        : settings_(settings), progress_(progress) {
        tbb::parallel_invoke([&] { map_.emplace(map, settings.coarseVoxelSize_m, progress); },
                             [&] { reference_.emplace(reference, settings.coarseVoxelSize_m, progress); },
                             [&] { judge_.emplace(map, reference, settings, progress); });
        fitter_.emplace(*map_, *reference_, settings, progress);
    }

    RegistrationResult aligned(const std::optional<Transform>& start) {
        RegistrationResult result = fitted(start);
        // What the map does not hold, the nearest points do not hold either.
        const bool isHeld = !isLoose(result);
        if (settings_.refinement != Refinement::PointToPoint || !isTrusted(result.quality) || !isHeld) return result;
        const std::optional<Transform> refined = judge_->refined(result.T_reference_from_map);
        if (!refined) return result;
        const PoseAlternative judged = judge_->judged(*refined);
        result.T_reference_from_map = *refined;
        result.overlap = judged.overlap;
        result.rms_m = judged.rms_m;
        result.explained = fitter_->explained(*refined);
        return result;
    }

  private:
    RegistrationResult fitted(const std::optional<Transform>& start) {
        if (!fitter_->hasSurfaces()) {
            RegistrationResult nothing = resultOf({}, start);
            nothing.T_reference_from_map = start.value_or(Transform::Identity());
            nothing.converged = false;
            return nothing;
        }
        if (start) {
            RegistrationResult near = resultOf(fitter_->from(*start), start);
            // A turn or two directions that nothing holds leave too much to a start pose.
            near.quality = fits(near) && !isFarTooLoose(near) ? RegistrationQuality::Good : RegistrationQuality::Bad;
            if (near.quality == RegistrationQuality::Good || fits(near)) return near;
            RegistrationResult elsewhere = searched(start);
            return fits(elsewhere) ? elsewhere : near;
        }
        return searched(start);
    }

    RegistrationResult resultOf(const FittedPose& pose, const std::optional<Transform>& start) {
        const PoseAlternative judged = judge_->judged(pose.fit.T_target_from_source);
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
        const std::vector<FittedPose> poses = fitter_->fromAnywhere();
        RegistrationResult result = resultOf(poses.front(), start);
        if (!fits(result) || isFarTooLoose(result)) return result;
        for (std::size_t i = 1; i < poses.size(); ++i) {
            if (!poses[i].fit.converged || poses[i].explained < result.explained - settings_.ambiguityMargin) continue;
            PoseAlternative other = judge_->judged(poses[i].fit.T_target_from_source);
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
    std::optional<SurfacePatches> map_;
    std::optional<SurfacePatches> reference_;
    std::optional<PoseFitter> fitter_;
    std::optional<Judge> judge_;
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
