// SPDX-License-Identifier: MIT
#include "core/inspection/CandidateIds.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace {

using fodscope::Candidate;
using fodscope::CandidateSet;
using fodscope::carryOverIds;

/// A clustering of a field: for each voxel the cluster it belongs to, or −1.
CandidateSet clustering(std::initializer_list<std::int32_t> candidateOfVoxel) {
    CandidateSet set;
    set.candidateOfVoxel = candidateOfVoxel;
    for (std::uint32_t voxel = 0; voxel < set.candidateOfVoxel.size(); ++voxel) {
        const std::int32_t index = set.candidateOfVoxel[voxel];
        if (index < 0) continue;
        if (set.candidates.size() <= static_cast<std::size_t>(index)) {
            set.candidates.resize(static_cast<std::size_t>(index) + 1);
        }
        set.candidates[static_cast<std::size_t>(index)].voxels.push_back(voxel);
    }
    return set;
}

std::vector<std::string> idsOf(const CandidateSet& set) {
    std::vector<std::string> ids;
    for (const Candidate& candidate : set.candidates)
        ids.push_back(candidate.id);
    return ids;
}

TEST(CandidateIds, TheFirstClusteringIsNumberedInOrderOfSuspicion) {
    CandidateSet first = clustering({0, 0, 1, -1, 2});
    int highest = 0;
    carryOverIds({}, first, highest);
    EXPECT_EQ(idsOf(first), (std::vector<std::string>{"C-001", "C-002", "C-003"}));
    EXPECT_EQ(highest, 3);
}

TEST(CandidateIds, AClusterKeepsItsIdWhenTheOrderChanges) {
    CandidateSet first = clustering({0, 0, 1, 1});
    int highest = 0;
    carryOverIds({}, first, highest);
    CandidateSet later = clustering({1, 1, 0, 0});
    carryOverIds(first, later, highest);
    EXPECT_EQ(idsOf(later), (std::vector<std::string>{"C-002", "C-001"}));
    EXPECT_EQ(highest, 2);
}

TEST(CandidateIds, OfASplitClusterTheLargerPartKeepsTheId) {
    CandidateSet first = clustering({0, 0, 0, 0, 0});
    int highest = 0;
    carryOverIds({}, first, highest);
    CandidateSet later = clustering({0, 0, 1, 1, 1});
    carryOverIds(first, later, highest);
    EXPECT_EQ(idsOf(later), (std::vector<std::string>{"C-002", "C-001"}));
}

TEST(CandidateIds, MergedClustersKeepTheIdOfTheLargerPartAndOfEqualPartsTheLowerId) {
    CandidateSet first = clustering({0, 1, 1, 2, 2});
    int highest = 0;
    carryOverIds({}, first, highest);
    CandidateSet later = clustering({0, 0, 0, 0, 0});
    carryOverIds(first, later, highest);
    EXPECT_EQ(idsOf(later), (std::vector<std::string>{"C-002"}));
}

TEST(CandidateIds, ANumberOnceGivenIsNeverGivenAgain) {
    CandidateSet first = clustering({0, -1, 1});
    int highest = 0;
    carryOverIds({}, first, highest);
    CandidateSet without = clustering({0, -1, -1});
    carryOverIds(first, without, highest);
    CandidateSet again = clustering({0, -1, 1});
    carryOverIds(without, again, highest);
    EXPECT_EQ(idsOf(again), (std::vector<std::string>{"C-001", "C-003"}));
    EXPECT_EQ(highest, 3);
}

TEST(CandidateIds, ClustersOfAnotherFieldGetNewNumbers) {
    CandidateSet first = clustering({0, 0});
    int highest = 0;
    carryOverIds({}, first, highest);
    CandidateSet other = clustering({0, 0, 0});
    carryOverIds(first, other, highest);
    EXPECT_EQ(idsOf(other), (std::vector<std::string>{"C-002"}));
}

TEST(CandidateIds, NumbersBeyondThreeDigitsStayDistinct) {
    CandidateSet first = clustering({0, 1});
    int highest = 999;
    carryOverIds({}, first, highest);
    EXPECT_EQ(idsOf(first), (std::vector<std::string>{"C-1000", "C-1001"}));
}

}  // namespace
