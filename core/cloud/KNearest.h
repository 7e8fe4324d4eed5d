// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/cloud/BlockTree.h"
#include "core/cloud/NeighbourIndex.h"

namespace fodscope {

/// Farther than any point: where nothing was found yet. Finite, so that what is missing (infinitely far) stays out.
inline constexpr double kAnywhere_m2 = std::numeric_limits<double>::max();

/// The nearer first; of two at the same distance the one with the lower index. A lambda, so that sorting inlines it.
inline constexpr auto isNearer = [](const Neighbour& a, const Neighbour& b) {
    return a.squaredDistance_m2 < b.squaredDistance_m2 ||
           (a.squaredDistance_m2 == b.squaredDistance_m2 && a.index < b.index);
};

/// Calls `use(i)` for every bit that is set.
template <class Use>
void forEachBit(std::uint32_t bits, const Use& use) {
    for (; bits != 0; bits &= bits - 1)
        use(static_cast<std::size_t>(std::countr_zero(bits)));
}

/// Gathers the k nearest points of one query. More than k are gathered before the farther ones are dropped, by counting
/// how many lie how far instead of comparing them with each other: a processor guesses the outcome of comparisons wrong
/// half of the time, and that costs more than all the arithmetic.
class KNearest {
  public:
    void start(std::size_t k);

    /// Nothing farther is wanted any more, squared.
    double reach() const { return reach_m2_; }

    /// Takes the points of a block whose bits are set; they lie within reach().
    void add(const PointBlock& block, std::uint32_t within, const BlockDistances& distances) {
        const bool wasShort = found_.size() < k_;
        forEachBit(within, [&](std::size_t i) { found_.push_back({block.original[i], distances[i]}); });
        const bool isFirstTime = wasShort && found_.size() >= k_;
        if (isFirstTime || found_.size() > fullAt_) dropFarther();
    }

    /// @return the k nearest, nearest first; valid until the next start()
    std::span<const Neighbour> sorted();

  private:
    void dropFarther();
    void dropAllButNearest();

    std::size_t k_ = 0;
    std::size_t fullAt_ = 0;
    double reach_m2_ = kAnywhere_m2;
    std::vector<Neighbour> found_;
    std::vector<Neighbour> inOrder_;
    std::vector<float> keys_;
    std::vector<std::uint32_t> smallerOf_;
};

}  // namespace fodscope
