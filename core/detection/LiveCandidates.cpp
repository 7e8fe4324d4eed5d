// SPDX-License-Identifier: MIT
#include "core/detection/LiveCandidates.h"

#include <tbb/parallel_for.h>

#include <utility>

#include "core/detection/Places.h"

namespace fodscope {

LiveCandidates::LiveCandidates(std::shared_ptr<const DiscrepancyField> field, double voxelSize_m, double floorHeight_m,
                               const Transform& T_reference_from_map)
    : field_(std::move(field)), frame_{voxelSize_m, floorHeight_m, T_reference_from_map.inverse()} {}

std::shared_ptr<const CandidateSet> LiveCandidates::find(const CandidateSettings& settings, Progress& progress) {
    checkCandidateSettings(settings, frame_.voxelSize_m);
    progress.throwIfCancelled();
    try {
        threshold(settings);
        last_ = std::make_shared<CandidateSet>(measured(clusters(settings, progress), settings, progress));
        settings_ = settings;
        return last_;
    } catch (...) {
        settings_.reset();
        centroidMerges_.reset();
        singleMerges_.reset();
        last_.reset();
        throw;
    }
}

void LiveCandidates::threshold(const CandidateSettings& settings) {
    // Measures depend on these two and on the voxels alone.
    if (!settings_ || settings_->metric != settings.metric || settings_->centroid != settings.centroid) last_.reset();
    const bool isKnown = settings_ && settings_->metric == settings.metric && settings_->linkage == settings.linkage;
    if (isKnown && settings_->threshold == settings.threshold) return;
    std::vector<std::uint32_t> above = voxelsAbove(field_->smoothed(settings.metric), settings.threshold);
    if (isKnown && above == above_) return;
    above_ = std::move(above);
    beginMerges(settings.linkage);
}

void LiveCandidates::beginMerges(Linkage linkage) {
    std::vector<Eigen::Vector3d> points;
    points.reserve(above_.size());
    for (const std::uint32_t voxel : above_)
        points.push_back(field_->points[voxel]);
    if (linkage == Linkage::Single) {
        singleMerges_.emplace(points, linkage);
        return;
    }
    requireFinite(points);
    // All voxels are looked through for shared places when it is seen to be worth it: at the second threshold.
    if (centroidMerges_ && !hasSharedPlaces_) hasSharedPlaces_ = !placesOf(field_->points).merges.empty();
    if (!centroidMerges_) centroidMerges_.emplace(field_->points);
    samePlaceMerges_.clear();
    std::vector<LivingCluster> clusters;
    if (hasSharedPlaces_.value_or(true)) {
        Places places = placesOf(points);
        clusters = std::move(places.clusters);
        for (LivingCluster& cluster : clusters)
            cluster.id = above_[cluster.id];
        for (const Merge& merge : places.merges)
            samePlaceMerges_.push_back({above_[merge.kept], above_[merge.removed], 0.0});
    } else {
        clusters.reserve(points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            clusters.push_back({points[i], above_[i], 1});
    }
    centroidMerges_->restart(std::move(clusters));
}

std::vector<std::uint32_t> LiveCandidates::centroidLabels(double cutoff_m, Progress& progress) {
    centroidMerges_->advance(cutoff_m, progress);
    parents_.resize(field_->size());
    labels_.resize(field_->size());
    for (const std::uint32_t voxel : above_)
        parents_[voxel] = voxel;
    for (const Merge& merge : samePlaceMerges_)
        parents_[merge.removed] = merge.kept;
    centroidMerges_->forEachMerge(cutoff_m,
                                  [&](std::uint32_t kept, std::uint32_t removed) { parents_[removed] = kept; });
    // A parent is lower than its child, so its label is known before it is needed.
    std::vector<std::uint32_t> labels;
    labels.reserve(above_.size());
    std::uint32_t next = 0;
    for (const std::uint32_t voxel : above_) {
        labels_[voxel] = parents_[voxel] == voxel ? next++ : labels_[parents_[voxel]];
        labels.push_back(labels_[voxel]);
    }
    return labels;
}

std::vector<std::uint32_t> LiveCandidates::labels(const CandidateSettings& settings, Progress& progress) {
    if (settings.linkage == Linkage::Centroid) return centroidLabels(settings.clusterCutoff_m, progress);
    return clustersAt(singleMerges_->upTo(settings.clusterCutoff_m, progress), settings.clusterCutoff_m);
}

std::vector<std::vector<std::uint32_t>> LiveCandidates::clusters(const CandidateSettings& settings,
                                                                 Progress& progress) {
    const std::vector<std::uint32_t> labels = this->labels(settings, progress);
    std::vector<std::uint32_t> sizes;
    for (const std::uint32_t label : labels) {
        // Labels are numbered by first point, so a new one is always the next.
        if (label == sizes.size()) sizes.push_back(0);
        ++sizes[label];
    }
    std::vector<std::vector<std::uint32_t>> clusters(sizes.size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        std::vector<std::uint32_t>& cluster = clusters[labels[i]];
        if (cluster.empty()) cluster.reserve(sizes[labels[i]]);
        cluster.push_back(above_[i]);
    }
    return clusters;
}

const Candidate* LiveCandidates::earlierWith(const std::vector<std::uint32_t>& voxels) const {
    if (!last_) return nullptr;
    const std::int32_t index = last_->candidateOfVoxel[voxels.front()];
    if (index < 0) return nullptr;
    const Candidate& earlier = last_->candidates[static_cast<std::size_t>(index)];
    return earlier.voxels == voxels ? &earlier : nullptr;
}

CandidateSet LiveCandidates::measured(std::vector<std::vector<std::uint32_t>> clusters,
                                      const CandidateSettings& settings, Progress& progress) const {
    const std::vector<double>& discrepancy = field_->smoothed(settings.metric);
    std::erase_if(clusters, [&](const std::vector<std::uint32_t>& voxels) {
        return voxels.size() < static_cast<std::size_t>(settings.minimumPoints);
    });
    CandidateSet set;
    set.candidateOfVoxel.assign(field_->size(), -1);
    set.pointsAboveThreshold = above_.size();
    set.candidates.resize(clusters.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, clusters.size(), 4), [&](const auto& range) {
        progress.throwIfCancelled();
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            if (const Candidate* earlier = earlierWith(clusters[i]))
                set.candidates[i] = *earlier;
            else
                set.candidates[i] =
                    measuredCandidate(*field_, discrepancy, std::move(clusters[i]), settings.centroid, frame_);
        }
    });
    arrangeCandidates(set);
    return set;
}

}  // namespace fodscope
