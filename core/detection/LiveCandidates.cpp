// SPDX-License-Identifier: MIT
#include "core/detection/LiveCandidates.h"

#include <tbb/parallel_for.h>

#include <utility>

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
        merges_.reset();
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
    std::vector<Eigen::Vector3d> points;
    points.reserve(above_.size());
    for (const std::uint32_t voxel : above_)
        points.push_back(field_->points[voxel]);
    merges_.emplace(points, settings.linkage);
}

std::vector<std::vector<std::uint32_t>> LiveCandidates::clusters(const CandidateSettings& settings,
                                                                 Progress& progress) {
    const std::vector<std::uint32_t> labels =
        clustersAt(merges_->upTo(settings.clusterCutoff_m, progress), settings.clusterCutoff_m);
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
