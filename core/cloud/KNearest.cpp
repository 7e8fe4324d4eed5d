// SPDX-License-Identifier: MIT
#include "core/cloud/KNearest.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/cloud/BlockKernels.h"

namespace fodscope {
namespace {

constexpr std::size_t kBins = 64;
/// Above this many, sorting by comparisons costs less than counting everything against everything.
constexpr std::size_t kMostToCount = 400;

std::size_t binOf(double squaredDistance, double binsPerUnit) {
    return std::min(kBins - 1, static_cast<std::size_t>(squaredDistance * binsPerUnit));
}

}  // namespace

void KNearest::start(std::size_t k) {
    k_ = k;
    fullAt_ = k + k / 2 + kBlockSize;
    reach_m2_ = kAnywhere_m2;
    found_.clear();
    found_.reserve(fullAt_ + kBlockSize);
}

void KNearest::dropFarther() {
    double farthest = 0.0;
    for (const Neighbour& neighbour : found_)
        farthest = std::max(farthest, neighbour.squaredDistance_m2);
    const double binsPerUnit = static_cast<double>(kBins) / farthest;
    // Beside each other or so far apart that counting by distance tells nothing.
    if (!(binsPerUnit > 0.0) || !(binsPerUnit < kAnywhere_m2)) return dropAllButNearest();
    std::array<std::uint32_t, kBins> counts{};
    for (const Neighbour& neighbour : found_)
        ++counts[binOf(neighbour.squaredDistance_m2, binsPerUnit)];
    std::size_t last = 0;
    for (std::size_t enough = counts[0]; enough < k_; enough += counts[last])
        ++last;

    std::size_t kept = 0;
    double reach_m2 = 0.0;
    for (const Neighbour& neighbour : found_) {
        const bool isKept = binOf(neighbour.squaredDistance_m2, binsPerUnit) <= last;
        found_[kept] = neighbour;
        kept += isKept ? 1 : 0;
        reach_m2 = std::max(reach_m2, isKept ? neighbour.squaredDistance_m2 : 0.0);
    }
    found_.resize(kept);
    reach_m2_ = reach_m2;
    // Many at nearly the same distance fall into one bin.
    if (found_.size() > fullAt_ - kBlockSize) dropAllButNearest();
}

void KNearest::dropAllButNearest() {
    if (found_.size() < k_) return;
    const auto last = found_.begin() + static_cast<std::ptrdiff_t>(k_) - 1;
    std::nth_element(found_.begin(), last, found_.end(), isNearer);
    found_.resize(k_);
    reach_m2_ = found_.back().squaredDistance_m2;
}

std::span<const Neighbour> KNearest::sorted() {
    if (found_.size() > kMostToCount) {
        dropAllButNearest();
        std::sort(found_.begin(), found_.end(), isNearer);
        return found_;
    }
    // By the distance as a float, which never puts a nearer point behind a farther one but makes some equal; what
    // remains out of place is beside its place.
    constexpr float infinity = std::numeric_limits<float>::infinity();
    keys_.assign((found_.size() + kRankStep - 1) / kRankStep * kRankStep, infinity);
    std::ranges::transform(found_, keys_.begin(), [](const Neighbour& n) {
        return static_cast<float>(std::min(n.squaredDistance_m2, double{std::numeric_limits<float>::max()}));
    });
    smallerOf_.resize(keys_.size());
    countSmaller(keys_, smallerOf_);
    constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();
    inOrder_.assign(found_.size(), Neighbour{nobody, 0.0});
    for (std::size_t i = 0; i < found_.size(); ++i) {
        std::size_t place = smallerOf_[i];
        while (inOrder_[place].index != nobody)
            ++place;
        inOrder_[place] = found_[i];
    }
    for (std::size_t i = 1; i < inOrder_.size(); ++i) {
        for (std::size_t j = i; j > 0 && isNearer(inOrder_[j], inOrder_[j - 1]); --j)
            std::swap(inOrder_[j], inOrder_[j - 1]);
    }
    return std::span<const Neighbour>(inOrder_).first(std::min(k_, inOrder_.size()));
}

}  // namespace fodscope
