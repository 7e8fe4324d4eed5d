// SPDX-License-Identifier: MIT
#include "core/evaluation/Association.h"

#include <algorithm>
#include <cmath>

#include "core/common/Error.h"

namespace fodscope {
namespace {

void requireFinite(std::span<const Eigen::Vector3d> points, const char* subject) {
    for (const Eigen::Vector3d& point : points)
        if (!point.allFinite())
            throw Error(subject, "a centroid is not finite", "leave out what has no place, or mend its position");
}

AssociatedFod nearestCandidate(const Eigen::Vector3d& fod, std::span<const Eigen::Vector3d> candidates) {
    AssociatedFod result;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const double distance_m = (candidates[i] - fod).norm();
        if (result.distance_m && !(distance_m < *result.distance_m)) continue;
        result.distance_m = distance_m;
        result.nearest = i;
    }
    return result;
}

bool isFarFromAll(const Eigen::Vector3d& candidate, std::span<const Eigen::Vector3d> fods) {
    return std::ranges::all_of(
        fods, [&](const Eigen::Vector3d& fod) { return (candidate - fod).norm() > kFalseCandidateDistance_m; });
}

double meanDistance(const std::vector<AssociatedFod>& fods) {
    if (fods.empty()) return 0.0;
    double sum_m = 0.0;
    for (const AssociatedFod& fod : fods)
        sum_m += fod.distance_m.value_or(kNoCandidateDistance_m);
    return sum_m / static_cast<double>(fods.size());
}

}  // namespace

Association associate(std::span<const Eigen::Vector3d> fods, std::span<const Eigen::Vector3d> candidates,
                      double lambda) {
    requireFinite(fods, "ground truth");
    requireFinite(candidates, "candidates");
    if (!std::isfinite(lambda) || lambda < 0.0)
        throw Error("lambda", "is not a number of at least 0", "give the cost of an unassociated candidate, e.g. 0.05");
    Association result;
    result.isAssociated.assign(candidates.size(), 0);
    for (const Eigen::Vector3d& fod : fods) {
        result.fods.push_back(nearestCandidate(fod, candidates));
        if (result.fods.back().nearest) result.isAssociated[*result.fods.back().nearest] = 1;
    }
    result.unassociatedCandidates = static_cast<std::size_t>(std::ranges::count(result.isAssociated, 0));
    result.falseCandidates = static_cast<std::size_t>(std::ranges::count_if(
        candidates, [&](const Eigen::Vector3d& candidate) { return isFarFromAll(candidate, fods); }));
    result.cost = meanDistance(result.fods) + lambda * static_cast<double>(result.unassociatedCandidates);
    return result;
}

}  // namespace fodscope
