// SPDX-License-Identifier: MIT
#include "core/detection/LiveLinkage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/detection/CentroidLinkage.h"
#include "core/detection/Places.h"

namespace fodscope {
namespace {

/// Dense enough for all points at once, so that rounds are the same for all sets.
double firstReachOf(std::span<const Eigen::Vector3d> all) {
    constexpr double usualCutoff_m = 0.345;
    constexpr double least_m = 1e-9;
    constexpr std::size_t sample = 1u << 15;
    const std::size_t stride = std::max<std::size_t>(1, all.size() / sample);
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < all.size(); i += stride)
        if (all[i].allFinite()) points.push_back(all[i]);
    if (points.empty()) return usualCutoff_m;
    return std::max(least_m, firstReach(placesOf(points).clusters, usualCutoff_m, static_cast<double>(stride)));
}

}  // namespace

LiveLinkage::LiveLinkage(std::span<const Eigen::Vector3d> all)
    : firstReach_m_(firstReachOf(all)), slotOfId_(all.size(), ClusterGrid::kNone) {}

void LiveLinkage::restart(std::vector<LivingCluster> clusters) {
    living_ = std::move(clusters);
    points_ = living_.size();
    done_ = 0;
}

double LiveLinkage::reachOf(std::size_t round) const {
    return firstReach_m_ * std::pow(kRoundStep, static_cast<double>(round));
}

void LiveLinkage::advance(double cutoff_m, Progress& progress) {
    progress.throwIfCancelled();
    // A round's reach squared is rounded, so it must be beyond the cutoff by more than that.
    while (living_.size() > 1 && cutoff_m > 0.0 && (done_ == 0 || reachOf(done_ - 1) < 1.0001 * cutoff_m)) {
        const double reach_m = reachOf(done_);
        const double limit = reach_m * reach_m;
        const LinkageProgress soFar{progress, points_ - living_.size(), points_};
        RoundRecord record{living_, {}};
        if (done_ < records_.size()) {
            record.merges = replayRound(records_[done_], living_, reach_m, limit, slotOfId_, soFar);
            records_[done_] = std::move(record);
        } else {
            record.merges = runRound(living_, reach_m, limit, soFar);
            records_.push_back(std::move(record));
        }
        ++done_;
    }
}

}  // namespace fodscope
