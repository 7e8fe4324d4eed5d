// SPDX-License-Identifier: MIT
#include "core/planning/PhotoCover.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace fodscope {
namespace {

/// Steps of the search in one group of elements that sets connect.
constexpr int kMostSteps = 50'000;

struct Choice {
    std::vector<std::size_t> sets;
    double cost = 0.0;

    bool isBetterThan(const Choice& other) const {
        return sets.size() != other.sets.size() ? sets.size() < other.sets.size() : cost < other.cost;
    }
};

/// Branch and bound over the sets of one group.
class Search {
  public:
    Search(std::span<const CoverSet> sets, std::vector<std::size_t> group, std::size_t elementCount)
        : sets_(sets), setsOf_(elementCount), covered_(elementCount, 0) {
        for (const std::size_t set : group) {
            largest_ = std::max(largest_, sets[set].elements.size());
            for (const std::size_t element : sets[set].elements) {
                if (setsOf_[element].empty()) elements_.push_back(element);
                setsOf_[element].push_back(set);
            }
        }
        std::ranges::sort(elements_);
        for (const std::size_t element : elements_) {
            std::ranges::stable_sort(setsOf_[element], [&](std::size_t a, std::size_t b) {
                const std::size_t sizeA = sets[a].elements.size(), sizeB = sets[b].elements.size();
                return sizeA != sizeB ? sizeA > sizeB : sets[a].cost < sets[b].cost;
            });
        }
        open_ = elements_.size();
    }

    std::vector<std::size_t> run() {
        best_ = greedy();
        descend();
        return best_.sets;
    }

  private:
    std::size_t gainOf(std::size_t set) const {
        return static_cast<std::size_t>(
            std::ranges::count_if(sets_[set].elements, [&](std::size_t element) { return covered_[element] == 0; }));
    }

    void take(std::size_t set) {
        for (const std::size_t element : sets_[set].elements)
            if (covered_[element]++ == 0) --open_;
        now_.sets.push_back(set);
        now_.cost += sets_[set].cost;
    }

    void putBack(double costBefore) {
        for (const std::size_t element : sets_[now_.sets.back()].elements)
            if (--covered_[element] == 0) ++open_;
        now_.sets.pop_back();
        now_.cost = costBefore;
    }

    /// The set that covers most of what is left, the cheaper of two equal ones, each time.
    Choice greedy() {
        while (open_ > 0) {
            std::size_t best = 0, bestGain = 0;
            for (const std::size_t element : elements_) {
                if (covered_[element] != 0) continue;
                for (const std::size_t set : setsOf_[element]) {
                    const std::size_t gain = gainOf(set);
                    if (gain < bestGain || (gain == bestGain && !(sets_[set].cost < sets_[best].cost))) continue;
                    best = set;
                    bestGain = gain;
                }
            }
            take(best);
        }
        const Choice choice = now_;
        while (!now_.sets.empty())
            putBack(0.0);
        return choice;
    }

    void descend() {
        if (open_ == 0) {
            if (now_.isBetterThan(best_)) best_ = now_;
            return;
        }
        const std::size_t least = now_.sets.size() + (open_ + largest_ - 1) / largest_;
        if (least > best_.sets.size() || (least == best_.sets.size() && now_.cost >= best_.cost)) return;
        if (++steps_ > kMostSteps) return;
        // The element with the fewest sets leaves the fewest branches.
        std::size_t element = elements_.front(), fewest = std::numeric_limits<std::size_t>::max();
        for (const std::size_t each : elements_) {
            if (covered_[each] != 0 || setsOf_[each].size() >= fewest) continue;
            element = each;
            fewest = setsOf_[each].size();
        }
        for (const std::size_t set : setsOf_[element]) {
            const double costBefore = now_.cost;
            take(set);
            descend();
            putBack(costBefore);
        }
    }

    std::span<const CoverSet> sets_;
    std::vector<std::vector<std::size_t>> setsOf_;
    std::vector<std::size_t> elements_;
    /// By how many of the sets taken.
    std::vector<int> covered_;
    std::size_t open_ = 0;
    std::size_t largest_ = 1;
    int steps_ = 0;
    Choice now_;
    Choice best_;
};

/// A set is of no use when another one covers as much and costs no more.
std::vector<std::size_t> usefulSets(std::span<const CoverSet> sets, std::span<const std::size_t> group) {
    std::vector<std::size_t> useful;
    for (const std::size_t set : group) {
        if (sets[set].elements.empty()) continue;
        const bool isBeaten = std::ranges::any_of(group, [&](std::size_t other) {
            if (other == set || sets[other].cost > sets[set].cost) return false;
            const auto& mine = sets[set].elements;
            const auto& theirs = sets[other].elements;
            if (!std::ranges::includes(theirs, mine)) return false;
            // Of two alike the first stays.
            return theirs.size() > mine.size() || sets[other].cost < sets[set].cost || other < set;
        });
        if (!isBeaten) useful.push_back(set);
    }
    return useful;
}

/// Sets that share elements, directly or through others, in groups.
std::vector<std::vector<std::size_t>> groupsOf(std::span<const CoverSet> sets, std::size_t elementCount) {
    std::vector<std::size_t> parent(elementCount);
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto rootOf = [&](std::size_t element) {
        while (parent[element] != element)
            element = parent[element] = parent[parent[element]];
        return element;
    };
    for (const CoverSet& set : sets) {
        for (const std::size_t element : set.elements)
            parent[rootOf(element)] = rootOf(set.elements.front());
    }
    std::vector<std::vector<std::size_t>> groups(elementCount);
    for (std::size_t i = 0; i < sets.size(); ++i)
        if (!sets[i].elements.empty()) groups[rootOf(sets[i].elements.front())].push_back(i);
    return groups;
}

}  // namespace

std::vector<std::size_t> fewestSets(std::span<const CoverSet> sets, std::size_t elementCount) {
    std::vector<std::size_t> chosen;
    for (const std::vector<std::size_t>& group : groupsOf(sets, elementCount)) {
        if (group.empty()) continue;
        const std::vector<std::size_t> best = Search(sets, usefulSets(sets, group), elementCount).run();
        chosen.insert(chosen.end(), best.begin(), best.end());
    }
    std::ranges::sort(chosen);
    return chosen;
}

}  // namespace fodscope
