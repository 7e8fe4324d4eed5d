// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

namespace fodscope {

/// A pair of clusters that was the closest one of `owner` when it was entered.
struct ClusterPair {
    double squaredDistance = 0.0;
    std::uint32_t owner = 0;
    std::uint32_t partner = 0;
    /// How often each had been merged then: the pair still exists only if neither moved since.
    std::uint32_t ownerVersion = 0;
    std::uint32_t partnerVersion : 31 = 0;
    /// It was the closest one of the partner too, which has no entry of its own.
    std::uint32_t isMutual : 1 = 0;
};

/// Pairs, the closest first; `Order` says which of two goes first and must begin with the squared distance. A pair is
/// entered into one of many bins by its distance, and the pairs of a bin are put in order only once it is the first:
/// so most of the queue is not touched between a pair's entry and its turn.
template <typename Order>
class PairQueue {
  public:
    /// @param expected about how many pairs there will be
    PairQueue(double largestSquaredDistance, std::size_t expected, Order goesBefore)
        : goesBefore_(goesBefore), first_(std::bit_ceil(expected / kPairsPerBin + 1), kNone) {
        binsPerUnit_ = static_cast<double>(first_.size()) / largestSquaredDistance;
        // Distances too small or too large to be told apart share a bin.
        if (!(binsPerUnit_ <= std::numeric_limits<double>::max())) binsPerUnit_ = 0.0;
        entries_.reserve(expected);
    }

    void push(const ClusterPair& pair) {
        const std::size_t bin = binOf(pair.squaredDistance);
        if (bin <= bin_) {
            now_.push_back(pair);
            std::push_heap(now_.begin(), now_.end(), goesAfter());
            return;
        }
        std::uint32_t entry = free_;
        if (entry == kNone) {
            entry = static_cast<std::uint32_t>(entries_.size());
            entries_.emplace_back();
        } else {
            free_ = entries_[entry].next;
        }
        entries_[entry] = {pair, first_[bin]};
        first_[bin] = entry;
    }

    /// @return the first, or null when there is none
    const ClusterPair* top() {
        while (now_.empty()) {
            if (bin_ + 1 >= first_.size()) return nullptr;
            openNextBin();
        }
        return &now_.front();
    }

    /// Takes the first one, which there must be, off.
    ClusterPair pop() {
        std::pop_heap(now_.begin(), now_.end(), goesAfter());
        const ClusterPair pair = now_.back();
        now_.pop_back();
        return pair;
    }

  private:
    static constexpr std::size_t kPairsPerBin = 16;
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    struct Entry {
        ClusterPair pair;
        std::uint32_t next = kNone;
    };

    /// Never decreases with the distance.
    std::size_t binOf(double squaredDistance) const {
        const double bin = squaredDistance * binsPerUnit_;
        const auto last = static_cast<double>(first_.size() - 1);
        return bin < last ? static_cast<std::size_t>(bin) : first_.size() - 1;
    }

    auto goesAfter() const {
        return [this](const ClusterPair& a, const ClusterPair& b) { return goesBefore_(b, a); };
    }

    void openNextBin() {
        ++bin_;
        for (std::uint32_t entry = first_[bin_]; entry != kNone;) {
            now_.push_back(entries_[entry].pair);
            const std::uint32_t following = entries_[entry].next;
            entries_[entry].next = free_;
            free_ = entry;
            entry = following;
        }
        std::make_heap(now_.begin(), now_.end(), goesAfter());
    }

    Order goesBefore_;
    std::vector<std::uint32_t> first_;
    std::vector<Entry> entries_;
    std::uint32_t free_ = kNone;
    /// The pairs of this bin and of those before it are in `now_`, a heap.
    std::size_t bin_ = 0;
    std::vector<ClusterPair> now_;
    double binsPerUnit_ = 0.0;
};

}  // namespace fodscope
