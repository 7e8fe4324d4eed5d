// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/cloud/BlockKernels.h"
#include "core/cloud/NeighbourIndex.h"

namespace fodscope {

/// Farther than any point: where nothing was found yet. Finite, so that what is missing (infinitely far) stays out.
inline constexpr double kAnywhere_m2 = std::numeric_limits<double>::max();

/// No point's index.
inline constexpr std::uint32_t kNowhere = std::numeric_limits<std::uint32_t>::max();

/// The nearer first; of two at the same distance the one with the lower index. A lambda, so that sorting inlines it.
inline constexpr auto isNearer = [](const Neighbour& a, const Neighbour& b) {
    return a.squaredDistance_m2 < b.squaredDistance_m2 ||
           (a.squaredDistance_m2 == b.squaredDistance_m2 && a.index < b.index);
};

/// What is nearest when the distances to all points are more than the largest double.
inline constexpr Neighbour kInfinitelyFar{0, std::numeric_limits<double>::infinity()};

/// Calls `use(i)` for every bit that is set.
template <class Use>
void forEachBit(std::uint32_t bits, const Use& use) {
    for (; bits != 0; bits &= bits - 1)
        use(static_cast<std::size_t>(std::countr_zero(bits)));
}

/// Points found and how far they are, in the order of the search.
class FoundPoints {
  public:
    std::size_t size() const { return size_; }
    void clear() { size_ = 0; }
    Neighbour operator[](std::size_t i) const { return {index_[i], squaredDistance_m2_[i]}; }
    std::span<const double> squaredDistances_m2() const { return std::span(squaredDistance_m2_).first(size_); }

    /// Adds the points of a block that are at most `limit` from the query.
    void take(const BlockKernels& kernels, const PointBlock& block, const Eigen::Vector3d& query, double limit) {
        if (size_ + kBlockSize > index_.size()) grow();
        size_ += kernels.takeWithin(block, query, limit, &squaredDistance_m2_[size_], &index_[size_]);
    }

    /// Keeps the points for which `isKept(i)` holds.
    template <class IsKept>
    void keepIf(const IsKept& isKept) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < size_; ++i) {
            const bool keep = isKept(i);
            squaredDistance_m2_[kept] = squaredDistance_m2_[i];
            index_[kept] = index_[i];
            kept += keep ? 1 : 0;
        }
        size_ = kept;
    }

    /// Puts others in their place.
    void assign(std::span<const Neighbour> neighbours);

  private:
    void grow();

    std::size_t size_ = 0;
    std::vector<double> squaredDistance_m2_;
    std::vector<std::uint32_t> index_;
};

/// Gathers the k nearest points of one query. More than k are gathered before the farther ones are dropped, by counting
/// how many lie how far instead of comparing them with each other: a processor guesses the outcome of comparisons wrong
/// half of the time, and that costs more than all the arithmetic.
class KNearest {
  public:
    /// @param reach_m2 nothing farther is wanted, squared; a guess, see hasEnough()
    void start(std::size_t k, double reach_m2 = kAnywhere_m2);

    /// Nothing farther is wanted any more, squared.
    double reach() const { return reach_m2_; }

    /// Whether k points lie within the reach; else the search was in vain and must start anew with a longer one.
    bool hasEnough() const { return found_.size() >= k_; }

    /// Takes the points of a block that lie within reach().
    /// @return whether the reach became shorter
    bool add(const BlockKernels& kernels, const PointBlock& block, const Eigen::Vector3d& query) {
        found_.take(kernels, block, query, reach_m2_);
        if (found_.size() < fullAt_) return false;
        dropFarther();
        return true;
    }

    /// @return the k nearest, nearest first; valid until the next start(). Where fewer were found although anywhere was
    ///         in reach, the distance to the others is more than the largest double: these follow, infinitely far.
    std::span<const Neighbour> sorted(const BlockKernels& kernels);

  private:
    void dropFarther();
    void dropAllButNearest();
    std::span<const Neighbour> sortedByComparing();
    void placeEqualKeys();
    void mendOrder(std::size_t end);
    void addInfinitelyFar();

    std::size_t k_ = 0;
    std::size_t fullAt_ = 0;
    double reach_m2_ = kAnywhere_m2;
    FoundPoints found_;
    std::vector<Neighbour> inOrder_;
    std::vector<std::int16_t> keys_;
    std::vector<std::uint16_t> smallerOf_;
    std::vector<std::uint16_t> placed_;
};

}  // namespace fodscope
