// SPDX-License-Identifier: MIT
#include "core/inspection/CandidateIds.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace fodscope {
namespace {

/// @return the number in "C-017", 0 for any other text
int numberOf(const std::string& id) {
    int number = 0;
    if (id.starts_with("C-")) std::from_chars(id.data() + 2, id.data() + id.size(), number);
    return number;
}

std::string idOf(int number) {
    char text[32];
    std::snprintf(text, sizeof text, "C-%03d", number);
    return text;
}

struct Overlap {
    std::size_t shared = 0;
    std::size_t earlier = 0;
    std::size_t later = 0;
};

/// @return every pair of clusters that share a voxel, the largest share first; ties go to the lower earlier id
std::vector<Overlap> overlapsOf(const CandidateSet& earlier, const CandidateSet& later) {
    // Indices of two different fields say nothing about each other.
    if (earlier.candidateOfVoxel.size() != later.candidateOfVoxel.size()) return {};
    std::vector<Overlap> overlaps;
    std::vector<std::size_t> shared(earlier.candidates.size(), 0);
    for (std::size_t i = 0; i < later.candidates.size(); ++i) {
        const std::size_t first = overlaps.size();
        for (const std::uint32_t voxel : later.candidates[i].voxels) {
            const std::int32_t index = earlier.candidateOfVoxel[voxel];
            if (index < 0) continue;
            const auto before = static_cast<std::size_t>(index);
            if (shared[before]++ == 0) overlaps.push_back({0, before, i});
        }
        for (Overlap& overlap : std::span(overlaps).subspan(first))
            overlap.shared = std::exchange(shared[overlap.earlier], 0);
    }
    std::vector<int> numbers(earlier.candidates.size());
    std::ranges::transform(earlier.candidates, numbers.begin(), numberOf, &Candidate::id);
    std::ranges::sort(overlaps, [&](const Overlap& a, const Overlap& b) {
        return std::tuple(b.shared, numbers[a.earlier], a.later) < std::tuple(a.shared, numbers[b.earlier], b.later);
    });
    return overlaps;
}

}  // namespace

void carryOverIds(const CandidateSet& earlier, CandidateSet& later, int& highestUsed) {
    for (const Candidate& candidate : earlier.candidates)
        highestUsed = std::max(highestUsed, numberOf(candidate.id));

    std::vector<bool> taken(earlier.candidates.size(), false);
    std::vector<bool> named(later.candidates.size(), false);
    for (const Overlap& overlap : overlapsOf(earlier, later)) {
        if (taken[overlap.earlier] || named[overlap.later]) continue;
        later.candidates[overlap.later].id = earlier.candidates[overlap.earlier].id;
        taken[overlap.earlier] = true;
        named[overlap.later] = true;
    }
    for (std::size_t i = 0; i < later.candidates.size(); ++i) {
        if (!named[i]) later.candidates[i].id = idOf(++highestUsed);
    }
}

}  // namespace fodscope
