// SPDX-License-Identifier: MIT
#include "core/evaluation/ClusterSweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fodscope {
namespace {

/// A cluster in the making; its sums grow as others are merged into it.
struct Cluster {
    Eigen::Vector3d weightedSum = Eigen::Vector3d::Zero();
    double weight = 0.0;
    double discrepancySum = 0.0;
    std::uint32_t points = 1;
    bool isAlive = true;
};

/// The nearest candidate of a FOD so far.
struct Nearest {
    double distance_m = std::numeric_limits<double>::infinity();
    double discrepancySum = 0.0;
    std::uint32_t cluster = std::numeric_limits<std::uint32_t>::max();

    bool isSome() const { return cluster != std::numeric_limits<std::uint32_t>::max(); }

    /// Nearer, and of equally near ones that which findCandidates() lists first.
    bool goesBefore(const Nearest& other) const {
        if (distance_m != other.distance_m) return distance_m < other.distance_m;
        if (discrepancySum != other.discrepancySum) return discrepancySum > other.discrepancySum;
        return cluster < other.cluster;
    }
};

class Sweep {
  public:
    Sweep(const SearchTrial& trial, std::span<const std::uint32_t> voxels, const ParameterSearchSettings& settings,
          std::span<const int> leastPoints)
        : fods_map_(trial.fods_map),
          T_map_from_reference_(trial.T_reference_from_map.inverse()),
          leastPoints_(leastPoints),
          lambda_m_(settings.lambda_m),
          clusters_(voxels.size()),
          living_(voxels.size()) {
        const std::vector<double>& discrepancy = trial.field->smoothed(settings.metric);
        for (std::uint32_t i = 0; i < voxels.size(); ++i) {
            const double value = discrepancy[voxels[i]];
            clusters_[i].weight = settings.centroid == CentroidKind::DiscrepancyWeighted ? value : 1.0;
            clusters_[i].weightedSum = clusters_[i].weight * trial.field->points[voxels[i]];
            clusters_[i].discrepancySum = value;
            living_[i] = i;
        }
    }

    void merge(const Merge& merge) {
        Cluster& kept = clusters_[merge.kept];
        Cluster& removed = clusters_[merge.removed];
        kept.weightedSum += removed.weightedSum;
        kept.weight += removed.weight;
        kept.discrepancySum += removed.discrepancySum;
        kept.points += removed.points;
        removed.isAlive = false;
    }

    /// Adds the cost at the clusters as they are, for every least count.
    void appendCosts(std::vector<SearchCost>& costs) {
        std::erase_if(living_, [&](std::uint32_t cluster) { return !clusters_[cluster].isAlive; });
        const std::size_t levels = leastPoints_.size();
        // A cluster is filed under the highest least count that it reaches, and counts for the lower ones too.
        std::vector<std::size_t> counts(levels, 0);
        std::vector<Nearest> nearest(levels * fods_map_.size());
        for (const std::uint32_t id : living_) {
            const Cluster& cluster = clusters_[id];
            const auto reached = std::ranges::upper_bound(leastPoints_, static_cast<std::int64_t>(cluster.points));
            if (reached == leastPoints_.begin()) continue;
            const auto level = static_cast<std::size_t>(reached - leastPoints_.begin()) - 1;
            ++counts[level];
            const Eigen::Vector3d centroid_reference = cluster.weightedSum / cluster.weight;
            const Eigen::Vector3d centroid_map = T_map_from_reference_ * centroid_reference;
            for (std::size_t f = 0; f < fods_map_.size(); ++f) {
                const Nearest found{(centroid_map - fods_map_[f]).norm(), cluster.discrepancySum, id};
                Nearest& best = nearest[level * fods_map_.size() + f];
                if (found.goesBefore(best)) best = found;
            }
        }
        for (std::size_t level = levels - 1; level-- > 0;) {
            counts[level] += counts[level + 1];
            for (std::size_t f = 0; f < fods_map_.size(); ++f) {
                const Nearest& higher = nearest[(level + 1) * fods_map_.size() + f];
                Nearest& best = nearest[level * fods_map_.size() + f];
                if (higher.goesBefore(best)) best = higher;
            }
        }
        for (std::size_t level = 0; level < levels; ++level)
            costs.push_back(
                costOf(std::span(nearest).subspan(level * fods_map_.size(), fods_map_.size()), counts[level]));
    }

  private:
    SearchCost costOf(std::span<const Nearest> nearest, std::size_t candidates) const {
        if (candidates == 0) return costWithoutCandidates();
        std::vector<std::uint32_t> associated;
        double sum_m = 0.0;
        for (const Nearest& one : nearest) {
            sum_m += one.distance_m;
            associated.push_back(one.cluster);
        }
        std::ranges::sort(associated);
        const auto repeated = std::ranges::unique(associated);
        associated.erase(repeated.begin(), repeated.end());
        SearchCost cost;
        cost.distance_m = sum_m / static_cast<double>(nearest.size());
        cost.candidates = static_cast<double>(candidates);
        cost.unassociatedCandidates = static_cast<double>(candidates - associated.size());
        cost.cost = cost.distance_m + lambda_m_ * cost.unassociatedCandidates;
        return cost;
    }

    std::span<const Eigen::Vector3d> fods_map_;
    Transform T_map_from_reference_;
    std::span<const int> leastPoints_;
    double lambda_m_;
    std::vector<Cluster> clusters_;
    std::vector<std::uint32_t> living_;
};

}  // namespace

SearchCost costWithoutCandidates() {
    return {kNoCandidateDistance_m, kNoCandidateDistance_m, 0.0, 0.0};
}

std::vector<SearchCost> sweepClusters(const SearchTrial& trial, std::span<const std::uint32_t> voxels,
                                      const ParameterSearchSettings& settings, std::span<const double> cutoffs_m,
                                      std::span<const int> leastPoints, Progress& progress) {
    std::vector<Eigen::Vector3d> points;
    points.reserve(voxels.size());
    for (const std::uint32_t voxel : voxels)
        points.push_back(trial.field->points[voxel]);
    const MergeSequence sequence = mergeSequence(points, settings.linkage, cutoffs_m.back(), progress);
    Sweep sweep(trial, voxels, settings, leastPoints);
    std::vector<SearchCost> costs;
    costs.reserve(cutoffs_m.size() * leastPoints.size());
    std::size_t next = 0;
    for (const double cutoff_m : cutoffs_m) {
        progress.throwIfCancelled();
        for (; next < sequence.merges.size() && !(sequence.merges[next].distance_m > cutoff_m); ++next)
            sweep.merge(sequence.merges[next]);
        sweep.appendCosts(costs);
    }
    return costs;
}

}  // namespace fodscope
