// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/detection/CandidateMeasures.h"
#include "core/detection/Candidates.h"
#include "core/detection/LiveLinkage.h"

namespace fodscope {

/// Candidates of one field while their settings are moved: those of findCandidates(), to the bit, with what is kept
/// from the moves before. Used from one thread at a time.
///
/// The merges of the last threshold are kept: a lower cutoff takes fewer of them, a greater one goes on from the last.
/// For another threshold those merges are gone through again, and only what came of other voxels is merged anew (see
/// LinkageRound.h; single linkage begins again). A cluster that was there before keeps its measures.
class LiveCandidates {
  public:
    /// @param T_reference_from_map for the candidates' centroids in the map frame
    LiveCandidates(std::shared_ptr<const DiscrepancyField> field, double voxelSize_m, double floorHeight_m,
                   const Transform& T_reference_from_map);

    /// @throws Error, Cancelled as findCandidates() does; the next call then starts from nothing
    std::shared_ptr<const CandidateSet> find(const CandidateSettings& settings, Progress& progress);

    const std::shared_ptr<const DiscrepancyField>& field() const { return field_; }

  private:
    void threshold(const CandidateSettings& settings);
    void beginMerges(Linkage linkage);
    /// @return a label for each voxel above the threshold, numbered by first voxel
    std::vector<std::uint32_t> labels(const CandidateSettings& settings, Progress& progress);
    std::vector<std::uint32_t> centroidLabels(double cutoff_m, Progress& progress);
    std::vector<std::vector<std::uint32_t>> clusters(const CandidateSettings& settings, Progress& progress);
    CandidateSet measured(std::vector<std::vector<std::uint32_t>> clusters, const CandidateSettings& settings,
                          Progress& progress) const;
    /// @return null when there was no such cluster before
    const Candidate* earlierWith(const std::vector<std::uint32_t>& voxels) const;

    std::shared_ptr<const DiscrepancyField> field_;
    CandidateFrame frame_;
    /// What the merges belong to.
    std::optional<CandidateSettings> settings_;
    std::vector<std::uint32_t> above_;
    std::optional<LiveLinkage> centroidMerges_;
    /// Those of voxels at one place, which go first; once it is known that a field has none they are not looked for.
    std::vector<Merge> samePlaceMerges_;
    std::optional<bool> hasSharedPlaces_;
    std::optional<GrowingMergeSequence> singleMerges_;
    /// Per voxel of the field, valid for those above the threshold.
    std::vector<std::uint32_t> parents_;
    std::vector<std::uint32_t> labels_;
    std::shared_ptr<const CandidateSet> last_;
};

}  // namespace fodscope
