// SPDX-License-Identifier: MIT
#include "core/cloud/SpatialRuns.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/cloud/HilbertCurve.h"
#include "core/cloud/PointBox.h"

namespace fodscope {
namespace {

/// Points that one thread takes at a time.
constexpr std::size_t kSlab = 1 << 15;
constexpr std::size_t kMostSlabs = 16;
constexpr int kMostBits = 5;

struct Range {
    std::size_t first;
    std::size_t last;

    std::size_t size() const { return last - first; }
};

/// Cubes that divide the longest side of a box into 2^bits.
class Grid {
  public:
    Grid(const PointBox& box, int bits) : side_((1 << bits) - 1), bits_(bits), halfLow_(0.5 * box.low) {
        // Halved before subtracting: the extent of points near the largest double would overflow.
        const double halfExtent = (0.5 * box.high - halfLow_).maxCoeff();
        cellsPerHalf_ = static_cast<double>(side_ + 1) / halfExtent;
    }
    /// False when the box is so flat that the reciprocal of its extent is no number.
    bool isUsable() const { return cellsPerHalf_ < 1e300; }

    std::size_t cellOf(const Eigen::Vector3d& point) const {
        const auto along = [&](Eigen::Index axis) {
            const double cells = (0.5 * point[axis] - halfLow_[axis]) * cellsPerHalf_;
            return static_cast<std::size_t>(std::min(static_cast<std::int64_t>(cells), side_));
        };
        return (along(0) << bits_ | along(1)) << bits_ | along(2);
    }

  private:
    std::int64_t side_;
    int bits_;
    Eigen::Vector3d halfLow_;
    double cellsPerHalf_;
};

class Divider {
  public:
    Divider(std::span<const Eigen::Vector3d> points, std::size_t most, std::span<std::uint32_t> order,
            const Progress& progress)
        : points_(points), most_(most), order_(order), progress_(progress) {}

    /// @return where the runs end
    std::vector<std::uint32_t> divide(const Range& range, bool isStubborn = false);

  private:
    PointBox boxOf(const Range& range) const;
    std::vector<std::uint32_t> cutAnywhere(const Range& range) const;
    std::vector<std::uint32_t> divideAtMedian(const Range& range, const PointBox& box);
    std::vector<Range> sortIntoCells(const Range& range, const Grid& grid, int bits);
    std::vector<std::uint32_t> divideCells(const Range& range, std::span<const Range> cells, bool isStubborn);

    std::span<const Eigen::Vector3d> points_;
    std::size_t most_;
    std::span<std::uint32_t> order_;
    const Progress& progress_;
};

std::vector<std::uint32_t> Divider::divide(const Range& range, bool isStubborn) {
    if (range.size() <= most_) return {static_cast<std::uint32_t>(range.last)};
    progress_.throwIfCancelled();
    const PointBox box = boxOf(range);
    if (box.low == box.high) return cutAnywhere(range);
    // A surface meets about 4^bits cells: some cells for a run, so that runs are filled well.
    const double wanted = 8.0 * static_cast<double>(range.size()) / static_cast<double>(most_);
    const int bits = std::clamp(static_cast<int>(std::ceil(0.5 * std::log2(wanted))), 1, kMostBits);
    const Grid grid(box, bits);
    if (!grid.isUsable()) return divideAtMedian(range, box);
    const std::vector<Range> cells = sortIntoCells(range, grid, bits);
    return divideCells(range, cells, isStubborn);
}

PointBox Divider::boxOf(const Range& range) const {
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(range.first, range.last, kSlab), PointBox(),
        [&](const auto& part, PointBox box) {
            for (std::size_t i = part.begin(); i < part.end(); ++i)
                box.add(points_[order_[i]]);
            return box;
        },
        [](PointBox a, const PointBox& b) {
            a.add(b);
            return a;
        });
}

std::vector<std::uint32_t> Divider::cutAnywhere(const Range& range) const {
    std::vector<std::uint32_t> ends;
    for (std::size_t first = range.first; first < range.last; first += most_)
        ends.push_back(static_cast<std::uint32_t>(std::min(first + most_, range.last)));
    return ends;
}

std::vector<std::uint32_t> Divider::divideAtMedian(const Range& range, const PointBox& box) {
    const Eigen::Index axis = box.longestSide();
    const std::size_t middle = range.first + (range.size() / 2 + most_ - 1) / most_ * most_;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(range.first), at(middle), at(range.last),
                     [&](std::uint32_t a, std::uint32_t b) { return points_[a][axis] < points_[b][axis]; });
    std::vector<std::uint32_t> ends = divide({range.first, middle});
    const std::vector<std::uint32_t> right = divide({middle, range.last});
    ends.insert(ends.end(), right.begin(), right.end());
    return ends;
}

/// A counting sort along the curve: how many of each slab fall into each cell, then each to its place.
std::vector<Range> Divider::sortIntoCells(const Range& range, const Grid& grid, int bits) {
    const std::vector<std::uint16_t> rankOf = hilbertRanks(bits);
    const std::size_t slabs = std::clamp<std::size_t>(range.size() / kSlab, 1, kMostSlabs);
    const auto slab = [&](std::size_t s) {
        return Range{range.first + range.size() * s / slabs, range.first + range.size() * (s + 1) / slabs};
    };
    const std::vector<std::uint32_t> from(order_.begin() + static_cast<std::ptrdiff_t>(range.first),
                                          order_.begin() + static_cast<std::ptrdiff_t>(range.last));
    std::vector<std::uint16_t> cells(range.size());
    std::vector<std::vector<std::uint32_t>> places(slabs, std::vector<std::uint32_t>(rankOf.size()));
    tbb::parallel_for(std::size_t{0}, slabs, [&](std::size_t s) {
        progress_.throwIfCancelled();
        for (std::size_t i = slab(s).first; i < slab(s).last; ++i) {
            const std::uint16_t cell = rankOf[grid.cellOf(points_[order_[i]])];
            cells[i - range.first] = cell;
            ++places[s][cell];
        }
    });
    std::vector<Range> filled;
    std::size_t next = range.first;
    for (std::size_t cell = 0; cell < rankOf.size(); ++cell) {
        const std::size_t first = next;
        for (std::vector<std::uint32_t>& of : places)
            next += std::exchange(of[cell], static_cast<std::uint32_t>(next));
        if (next > first) filled.push_back({first, next});
    }
    tbb::parallel_for(std::size_t{0}, slabs, [&](std::size_t s) {
        progress_.throwIfCancelled();
        for (std::size_t i = slab(s).first; i < slab(s).last; ++i)
            order_[places[s][cells[i - range.first]]++] = from[i - range.first];
    });
    return filled;
}

std::vector<std::uint32_t> Divider::divideCells(const Range& range, std::span<const Range> cells, bool isStubborn) {
    // Cells in a row that fit into one run, or one that needs dividing.
    std::vector<Range> pieces;
    for (const Range& cell : cells) {
        if (!pieces.empty() && cell.last - pieces.back().first <= most_) {
            pieces.back().last = cell.last;
        } else {
            pieces.push_back(cell);
        }
    }
    std::vector<std::vector<std::uint32_t>> ends(pieces.size());
    tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
        const bool hardlyDivided = pieces[i].size() > std::max(most_, range.size() / 2);
        ends[i] = hardlyDivided && isStubborn ? divideAtMedian(pieces[i], boxOf(pieces[i]))
                                              : divide(pieces[i], hardlyDivided);
    });
    std::vector<std::uint32_t> all;
    for (const std::vector<std::uint32_t>& some : ends)
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace

SpatialRuns spatialRuns(std::span<const Eigen::Vector3d> points, std::size_t most, const Progress& progress) {
    SpatialRuns runs;
    if (points.empty()) return runs;
    runs.order.resize(points.size());
    std::iota(runs.order.begin(), runs.order.end(), 0U);
    runs.ends = Divider(points, most, runs.order, progress).divide({0, points.size()});
    return runs;
}

}  // namespace fodscope
