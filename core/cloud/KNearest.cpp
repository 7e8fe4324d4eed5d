// SPDX-License-Identifier: MIT
#include "core/cloud/KNearest.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace fodscope {
namespace {

constexpr std::size_t kBins = 64;
/// Above this many, sorting by comparisons costs less than counting everything against everything.
constexpr std::size_t kMostToCount = 400;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMostKey = std::numeric_limits<std::int16_t>::max();

std::size_t binOf(double squaredDistance, double binsPerUnit) {
    return std::min(kBins - 1, static_cast<std::size_t>(squaredDistance * binsPerUnit));
}

std::int16_t keyOf(double squaredDistance, double keysPerUnit) {
    return static_cast<std::int16_t>(static_cast<std::int32_t>(std::min(squaredDistance * keysPerUnit, kMostKey)));
}

}  // namespace

void FoundPoints::grow() {
    const std::size_t room = 2 * size_ + 8 * kBlockSize;
    squaredDistance_m2_.resize(room);
    index_.resize(room);
}

void FoundPoints::assign(std::span<const Neighbour> neighbours) {
    clear();
    for (const Neighbour& neighbour : neighbours) {
        if (size_ == index_.size()) grow();
        index_[size_] = neighbour.index;
        squaredDistance_m2_[size_++] = neighbour.squaredDistance_m2;
    }
}

void KNearest::start(std::size_t k, double reach_m2) {
    k_ = k;
    reach_m2_ = reach_m2;
    // With no reach yet, the first k points tell one.
    fullAt_ = reach_m2 == kAnywhere_m2 ? k : 2 * k + kBlockSize;
    found_.clear();
}

void KNearest::dropFarther() {
    fullAt_ = 2 * k_ + kBlockSize;
    const double farthest = *std::ranges::max_element(found_.squaredDistances_m2());
    const double binsPerUnit = static_cast<double>(kBins) / farthest;
    // Beside each other or so far apart that counting by distance tells nothing.
    if (!(binsPerUnit > 0.0) || !(binsPerUnit < kAnywhere_m2)) return dropAllButNearest();
    std::array<std::uint32_t, kBins> counts{};
    for (const double distance_m2 : found_.squaredDistances_m2())
        ++counts[binOf(distance_m2, binsPerUnit)];
    std::size_t last = 0;
    for (std::size_t enough = counts[0]; enough < k_; enough += counts[last])
        ++last;
    const std::span<const double> distances_m2 = found_.squaredDistances_m2();
    found_.keepIf([&](std::size_t i) { return binOf(distances_m2[i], binsPerUnit) <= last; });
    reach_m2_ = *std::ranges::max_element(found_.squaredDistances_m2());
    // Many at nearly the same distance fall into one bin.
    if (found_.size() > fullAt_ - kBlockSize) dropAllButNearest();
}

void KNearest::dropAllButNearest() {
    inOrder_.clear();
    for (std::size_t i = 0; i < found_.size(); ++i)
        inOrder_.push_back(found_[i]);
    const auto last = inOrder_.begin() + static_cast<std::ptrdiff_t>(k_) - 1;
    std::nth_element(inOrder_.begin(), last, inOrder_.end(), isNearer);
    reach_m2_ = last->squaredDistance_m2;
    found_.assign(std::span(inOrder_).first(k_));
}

std::span<const Neighbour> KNearest::sorted(const BlockKernels& kernels) {
    if (!hasEnough()) {
        addInfinitelyFar();
        return inOrder_;
    }
    const std::span<const double> distances_m2 = found_.squaredDistances_m2();
    const std::size_t count = distances_m2.size();
    // Nothing was taken from beyond the reach.
    const double keysPerUnit = kMostKey / reach_m2_;
    if (count > kMostToCount || !(keysPerUnit > 0.0) || !(keysPerUnit < kAnywhere_m2)) return sortedByComparing();
    // By the distance as a small whole number, which never puts a nearer point behind a farther one but makes some
    // equal; what remains out of place is then beside its place.
    keys_.assign((count + kRankStep - 1) / kRankStep * kRankStep, std::numeric_limits<std::int16_t>::max());
    for (std::size_t i = 0; i < count; ++i)
        keys_[i] = keyOf(distances_m2[i], keysPerUnit);
    smallerOf_.resize(keys_.size());
    kernels.countSmaller(keys_, smallerOf_);
    inOrder_.resize(count);
    // Every two keys that differ make one of them count the other.
    const std::size_t pairs = count * (count - 1) / 2;
    const std::span<const std::uint16_t> ranks = std::span(smallerOf_).first(count);
    if (std::accumulate(ranks.begin(), ranks.end(), std::uint32_t{0}) == pairs) {
        for (std::size_t i = 0; i < count; ++i)
            inOrder_[ranks[i]] = found_[i];
    } else {
        placeEqualKeys();
        const auto keyAt = [&](std::size_t i) { return keyOf(inOrder_[i].squaredDistance_m2, keysPerUnit); };
        std::size_t end = k_;
        while (end < count && keyAt(end) == keyAt(k_ - 1))
            ++end;
        mendOrder(end);
    }
    return std::span<const Neighbour>(inOrder_).first(k_);
}

void KNearest::placeEqualKeys() {
    placed_.assign(found_.size(), 0);
    for (std::size_t i = 0; i < found_.size(); ++i)
        inOrder_[smallerOf_[i] + placed_[smallerOf_[i]]++] = found_[i];
}

void KNearest::mendOrder(std::size_t end) {
    for (std::size_t i = 1; i < end; ++i) {
        for (std::size_t j = i; j > 0 && isNearer(inOrder_[j], inOrder_[j - 1]); --j)
            std::swap(inOrder_[j], inOrder_[j - 1]);
    }
}

std::span<const Neighbour> KNearest::sortedByComparing() {
    dropAllButNearest();
    inOrder_.resize(k_);
    std::sort(inOrder_.begin(), inOrder_.end(), isNearer);
    return inOrder_;
}

void KNearest::addInfinitelyFar() {
    inOrder_.clear();
    std::vector<std::uint32_t> known;
    for (std::size_t i = 0; i < found_.size(); ++i) {
        inOrder_.push_back(found_[i]);
        known.push_back(found_[i].index);
    }
    std::sort(inOrder_.begin(), inOrder_.end(), isNearer);
    std::ranges::sort(known);
    for (std::uint32_t index = 0; inOrder_.size() < k_; ++index)
        if (!std::ranges::binary_search(known, index)) inOrder_.push_back({index, kInfinity});
}

}  // namespace fodscope
