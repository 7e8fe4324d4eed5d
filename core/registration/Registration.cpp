// SPDX-License-Identifier: MIT
#include "core/registration/Registration.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/cloud/NeighbourIndex.h"
#include "core/cloud/VoxelGrid.h"
#include "core/common/Error.h"
#include "core/registration/FeatureMatch.h"
#include "core/registration/Icp.h"

namespace fodscope {
namespace {

constexpr const char* kFineStage = "aligning the map with the reference";
constexpr const char* kCoarseStage = "comparing coarse alignments";
constexpr const char* kJudgeStage = "judging the alignment";
/// A map this many times as large as the reference, or as small, is in other units; no search helps it.
constexpr double kAbsurdScale = 20.0;

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

struct Fit {
    double overlap = 0.0;
    double rms_m = 0.0;
};

Fit measureFit(std::span<const Eigen::Vector3d> voxels_map, const NeighbourIndex& reference, const Transform& transform,
               double overlapDistance_m, Progress& progress) {
    std::vector<Eigen::Vector3d> moved;
    moved.reserve(voxels_map.size());
    for (const Eigen::Vector3d& point : voxels_map)
        moved.push_back(transform * point);
    Progress inner([&](const std::string&, double) { progress.throwIfCancelled(); });
    std::size_t overlapping = 0;
    double sum_m2 = 0.0;
    for (const Neighbour& neighbour : reference.nearestOfEach(moved, inner)) {
        if (neighbour.squaredDistance_m2 > overlapDistance_m * overlapDistance_m) continue;
        ++overlapping;
        sum_m2 += neighbour.squaredDistance_m2;
    }
    if (overlapping == 0) return {};
    return {static_cast<double>(overlapping) / static_cast<double>(voxels_map.size()),
            std::sqrt(sum_m2 / static_cast<double>(overlapping))};
}

std::string percent(double share) {
    // Rounded down: 59.7 % must not read as the 60 % that would have been enough.
    return std::to_string(static_cast<int>(std::floor(share * 100.0 + 1e-9))) + " %";
}

std::string millimetres(double length_m) {
    char text[32];
    std::snprintf(text, sizeof text, "%.0f mm", length_m * 1000.0);
    return text;
}

std::string badSummary(const RegistrationResult& result, const RegistrationSettings& settings, double scale) {
    std::string summary = "not aligned: " + percent(result.overlap) + " overlap";
    if (scale > kAbsurdScale || scale < 1.0 / kAbsurdScale) {
        char ratio[64];
        std::snprintf(ratio, sizeof ratio, "%.3g", scale);
        return summary + "; the map is " + ratio + " times the size of the reference, check that both are in metres";
    }
    if (result.overlap < settings.minimumOverlap) {
        return summary + ", at least " + percent(settings.minimumOverlap) +
               " is needed; check that the map shows this space, or give a start pose";
    }
    return summary + " but the search did not settle within " + std::to_string(settings.maximumIterations) +
           " steps; give a start pose or allow more steps";
}

/// One alignment under way: the clouds, the search over the reference, and what is asked of the result.
class Alignment {
  public:
    Alignment(std::span<const Eigen::Vector3d> map, std::span<const Eigen::Vector3d> reference,
              const RegistrationSettings& settings, Progress& progress)
        : map_(map), reference_(reference), settings_(settings), progress_(progress), index_(reference) {
        voxels_map_ = voxelMeans(map, settings.mapVoxelSize_m);
    }

    RegistrationResult judged(const Transform& transform) const {
        const Fit fit = measureFit(voxels_map_, index_, transform, settings_.overlapDistance_m, progress_);
        RegistrationResult result;
        result.T_reference_from_map = transform;
        result.overlap = fit.overlap;
        result.rms_m = fit.rms_m;
        return result;
    }

    RegistrationResult fine(const Transform& start) const {
        // A thinned map brings the pose near at a fraction of the cost; the whole map then settles it.
        std::vector<Eigen::Vector3d> thinned;
        for (std::size_t i = 0; i < voxels_map_.size(); i += kThinning)
            thinned.push_back(voxels_map_[i]);
        IcpSettings settings{settings_.maximumCorrespondence_m, settings_.maximumIterations, kThinnedTolerance};
        const IcpTarget target{reference_, index_};
        const IcpResult near = icp(thinned, target, start, settings, kFineStage, progress_);
        settings.tolerance = kTolerance;
        const IcpResult settled = icp(voxels_map_, target, near.T_target_from_source, settings, kFineStage, progress_);
        RegistrationResult result = judged(settled.T_target_from_source);
        result.converged = settled.converged;
        const bool good = settled.converged && result.overlap >= settings_.minimumOverlap;
        result.quality = good ? RegistrationQuality::Good : RegistrationQuality::Bad;
        return result;
    }

    /// @return the best fine alignment from a feature match; empty when the features match nowhere
    std::optional<RegistrationResult> fromFeatures() const {
        const std::vector<Eigen::Vector3d> coarseMap = voxelMeans(map_, settings_.coarseVoxelSize_m);
        const std::vector<Eigen::Vector3d> coarseReference = voxelMeans(reference_, settings_.coarseVoxelSize_m);
        const std::vector<Transform> proposals =
            matchFeatures(coarseMap, coarseReference, settings_.coarseVoxelSize_m, progress_);
        const IcpTarget target{reference_, index_};
        const IcpSettings settings{settings_.maximumCorrespondence_m, 40, kThinnedTolerance};
        std::optional<Transform> best;
        Fit bestFit;
        for (std::size_t i = 0; i < proposals.size(); ++i) {
            progress_.report(kCoarseStage, static_cast<double>(i) / static_cast<double>(proposals.size()));
            Progress inner([&](const std::string&, double) { progress_.throwIfCancelled(); });
            const Transform settled =
                icp(coarseMap, target, proposals[i], settings, kCoarseStage, inner).T_target_from_source;
            const Fit fit = measureFit(coarseMap, index_, settled, settings_.overlapDistance_m, progress_);
            if (best && fit.overlap <= bestFit.overlap) continue;
            best = settled;
            bestFit = fit;
        }
        if (!best) return std::nullopt;
        return fine(*best);
    }

  private:
    static constexpr std::size_t kThinning = 8;
    static constexpr double kThinnedTolerance = 1e-5;
    static constexpr double kTolerance = 1e-6;

    std::span<const Eigen::Vector3d> map_;
    std::span<const Eigen::Vector3d> reference_;
    const RegistrationSettings& settings_;
    Progress& progress_;
    NeighbourIndex index_;
    std::vector<Eigen::Vector3d> voxels_map_;
};

}  // namespace

RegistrationResult registerMap(std::span<const Eigen::Vector3d> map, std::span<const Eigen::Vector3d> reference,
                               const std::optional<Transform>& start_T_reference_from_map,
                               const RegistrationSettings& settings, Progress& progress) {
    requirePoints(map, reference);
    progress.report(kFineStage, 0.0);
    const double scale = diagonal_m(map) / std::max(diagonal_m(reference), 1e-9);
    const bool sizesAgree = scale <= kAbsurdScale && scale >= 1.0 / kAbsurdScale;

    const Alignment alignment(map, reference, settings, progress);
    const Transform start = start_T_reference_from_map.value_or(Transform::Identity());
    RegistrationResult result = sizesAgree ? alignment.fine(start) : alignment.judged(start);
    if (!sizesAgree) result.converged = false;
    bool byFeatures = false;
    if (sizesAgree && result.quality == RegistrationQuality::Bad) {
        const std::optional<RegistrationResult> matched = alignment.fromFeatures();
        byFeatures = matched && (matched->quality == RegistrationQuality::Good || matched->overlap > result.overlap);
        if (byFeatures) result = *matched;
    }
    if (result.quality == RegistrationQuality::Good) {
        result.summary = "aligned, " + millimetres(result.rms_m) + " rms, " + percent(result.overlap) + " overlap";
        if (byFeatures) result.summary += ", start found by its features";
    } else {
        result.summary = badSummary(result, settings, scale);
    }
    return result;
}

RegistrationResult judgeTransform(std::span<const Eigen::Vector3d> map, std::span<const Eigen::Vector3d> reference,
                                  const Transform& T_reference_from_map, const RegistrationSettings& settings,
                                  Progress& progress) {
    requirePoints(map, reference);
    progress.report(kJudgeStage, 0.0);
    RegistrationResult result = Alignment(map, reference, settings, progress).judged(T_reference_from_map);
    result.quality = RegistrationQuality::Given;
    result.summary = "transform given, ";
    if (result.overlap > 0.0) result.summary += millimetres(result.rms_m) + " rms, ";
    result.summary += percent(result.overlap) + " overlap";
    if (result.overlap < settings.minimumOverlap) result.summary += ": check the transform";
    return result;
}

}  // namespace fodscope
