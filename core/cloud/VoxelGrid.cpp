// SPDX-License-Identifier: MIT
#include "core/cloud/VoxelGrid.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "core/cloud/Bounds.h"
#include "core/cloud/OccupiedCells.h"
#include "core/common/Error.h"

namespace fodscope {
namespace {

constexpr int kBitsPerAxis = 21;

void check(const VoxelGridSettings& settings) {
    if (!(settings.voxelSize_m > 0.0) || !std::isfinite(settings.voxelSize_m)) {
        throw Error("voxel size", "must be greater than 0", "give a length in metres such as 0.02");
    }
}

/// The cells that the points lie in, from the lowest to the highest on each axis.
struct Lattice {
    Eigen::Vector3d origin;
    double size_m = 0.0;
    /// Of the cells, in cells from the origin.
    Eigen::Vector3d lowest;
    Eigen::Vector3d highest;

    Eigen::Vector3d cellOf(const Eigen::Vector3d& point) const { return ((point - origin).array() / size_m).floor(); }
    /// Exact where it fits 64 bits, else too large; no lattice that large is ever used.
    double cells() const { return (highest - lowest + Eigen::Vector3d::Ones()).prod(); }
};

Lattice latticeOf(const Bounds& bounds, const Eigen::Vector3d& origin, double size_m) {
    Lattice lattice{origin, size_m, {}, {}};
    lattice.lowest = lattice.cellOf(bounds.low);
    lattice.highest = lattice.cellOf(bounds.high);
    const double longest = (lattice.highest - lattice.lowest).maxCoeff() + 1.0;
    if (!(longest <= static_cast<double>(1 << kBitsPerAxis))) {
        throw Error("voxel size", "the cloud is more than 2097152 voxels of " + std::to_string(size_m) + " m long",
                    "choose a larger voxel or check that the cloud is in metres");
    }
    return lattice;
}

/// The cells' numbers in lexicographic order, for lattices whose cells can be numbered and marked one by one.
class CellNumbers {
  public:
    explicit CellNumbers(const Lattice& lattice) : origin_(lattice.origin), size_m_(lattice.size_m) {
        for (int axis = 0; axis < 3; ++axis) {
            lowest_[axis] = static_cast<std::int32_t>(lattice.lowest[axis]);
            extent_[axis] = static_cast<std::uint32_t>(lattice.highest[axis] - lattice.lowest[axis]) + 1;
        }
    }

    static bool fit(const Lattice& lattice, std::size_t points) {
        // A bit for each cell and, where the points are many, no more than a byte for each of them.
        constexpr double fewest = 1 << 26;
        constexpr double most = std::numeric_limits<std::uint32_t>::max();
        constexpr double farthest = 1 << 30;
        return lattice.cells() <= std::clamp(8.0 * static_cast<double>(points), fewest, most) &&
               lattice.lowest.minCoeff() > -farthest && lattice.highest.maxCoeff() < farthest;
    }

    std::uint32_t of(const Eigen::Vector3d& point) const {
        return (along(point, 0) * extent_[1] + along(point, 1)) * extent_[2] + along(point, 2);
    }

    std::uint32_t count() const { return extent_[0] * extent_[1] * extent_[2]; }

  private:
    std::uint32_t along(const Eigen::Vector3d& point, int axis) const {
        // The floor: what is cut off rounds negative numbers up.
        const double exact = (point[axis] - origin_[axis]) / size_m_;
        const auto cut = static_cast<std::int32_t>(exact);
        return static_cast<std::uint32_t>(cut - (exact < static_cast<double>(cut) ? 1 : 0) - lowest_[axis]);
    }

    Eigen::Vector3d origin_;
    double size_m_;
    std::array<std::int32_t, 3> lowest_{};
    std::array<std::uint32_t, 3> extent_{};
};

constexpr std::uint32_t kNoCell = std::numeric_limits<std::uint32_t>::max();

std::size_t partsFor(std::size_t points) {
    constexpr std::size_t fewestPoints = 1 << 14;
    constexpr std::size_t mostParts = 8;
    const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    return std::clamp<std::size_t>(points / fewestPoints, 1, std::min(threads, mostParts));
}

/// Numbers the points' cells and marks those that are taken.
template <class Points>
OccupiedCells markCells(const Points& points, const CellNumbers& numbers, std::vector<std::uint32_t>& cellOf) {
    const std::size_t parts = partsFor(points.size());
    std::vector<OccupiedCells> marked(parts, OccupiedCells(numbers.count()));
    tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
        const std::size_t end = points.size() * (part + 1) / parts;
        for (std::size_t i = points.size() * part / parts; i < end; ++i) {
            Eigen::Vector3d point;
            cellOf[i] = points.get(i, point) ? numbers.of(point) : kNoCell;
            if (cellOf[i] != kNoCell) marked[part].mark(cellOf[i]);
        }
    });
    for (std::size_t part = 1; part < parts; ++part)
        marked.front().merge(marked[part]);
    marked.front().count();
    return std::move(marked.front());
}

/// Adds up the points of the cells from `first` to before `end`, in the points' own order.
template <class Points>
void addUp(const Points& points, std::span<const std::uint32_t> cellOf, const OccupiedCells& cells, std::uint64_t first,
           std::uint64_t end, VoxelCloud& sums) {
    struct Step {
        std::uint32_t point;
        std::uint32_t cell;
    };
    // All points of a block are looked at before any is added, so that the sums are on their way meanwhile. One more
    // than a block holds, as points of other cells are written too and then passed over: no branch to guess wrong.
    constexpr std::size_t block = 256;
    std::array<Step, block + 1> steps;
    for (std::size_t begin = 0; begin < cellOf.size(); begin += block) {
        std::size_t count = 0;
        for (std::size_t i = begin; i < std::min(begin + block, cellOf.size()); ++i) {
            steps[count] = {static_cast<std::uint32_t>(i), cellOf[i]};
            count += cellOf[i] >= first && cellOf[i] < end ? 1 : 0;
        }
        for (Step& step : std::span(steps).first(count)) {
            step.cell = cells.takenBefore(step.cell);
            __builtin_prefetch(&sums.points[step.cell], 1);
            __builtin_prefetch(&sums.weights[step.cell], 1);
        }
        for (const auto& [i, voxel] : std::span(steps).first(count)) {
            Eigen::Vector3d point;
            points.get(i, point);
            sums.points[voxel] += point;
            ++sums.weights[voxel];
        }
    }
}

template <class Points>
VoxelCloud gridOfMarkedCells(const Points& points, const CellNumbers& numbers) {
    std::vector<std::uint32_t> cellOf(points.size());
    const OccupiedCells cells = markCells(points, numbers, cellOf);
    VoxelCloud voxels;
    voxels.points.assign(cells.taken(), Eigen::Vector3d::Zero());
    voxels.weights.assign(cells.taken(), 0);
    const std::size_t parts = partsFor(points.size());
    const auto firstOf = [&](std::size_t part) {
        return part == parts ? numbers.count() : cells.cellWithBefore(cells.taken() * part / parts);
    };
    tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
        addUp(points, cellOf, cells, firstOf(part), firstOf(part + 1), voxels);
    });
    for (std::size_t i = 0; i < voxels.size(); ++i)
        voxels.points[i] /= static_cast<double>(voxels.weights[i]);
    return voxels;
}

using KeyedPoint = std::pair<std::uint64_t, std::uint32_t>;

/// Pairs of voxel key and point, sorted: voxels in lexicographic order and the points of each in their own order, so
/// that sums always add up in the same order.
template <class Points>
std::vector<KeyedPoint> sortedByVoxel(const Points& points, const Lattice& lattice) {
    std::vector<KeyedPoint> keyed;
    keyed.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        Eigen::Vector3d point;
        if (!points.get(i, point)) continue;
        const Eigen::Vector3d cell = lattice.cellOf(point) - lattice.lowest;
        const auto x = static_cast<std::uint64_t>(cell.x());
        const auto y = static_cast<std::uint64_t>(cell.y());
        const auto z = static_cast<std::uint64_t>(cell.z());
        keyed.push_back({x << (2 * kBitsPerAxis) | y << kBitsPerAxis | z, static_cast<std::uint32_t>(i)});
    }
    tbb::parallel_sort(keyed.begin(), keyed.end());
    return keyed;
}

/// For few points far apart, of whose lattice nearly all is empty.
template <class Points>
VoxelCloud gridOfSortedPoints(const Points& points, const Lattice& lattice) {
    const std::vector<KeyedPoint> keyed = sortedByVoxel(points, lattice);
    VoxelCloud voxels;
    for (std::size_t first = 0; first < keyed.size();) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        std::size_t end = first;
        for (; end < keyed.size() && keyed[end].first == keyed[first].first; ++end) {
            Eigen::Vector3d point;
            points.get(keyed[end].second, point);
            sum += point;
        }
        voxels.points.push_back(sum / static_cast<double>(end - first));
        voxels.weights.push_back(static_cast<std::uint32_t>(end - first));
        first = end;
    }
    return voxels;
}

template <class Points>
VoxelCloud gridOn(const Lattice& lattice, const Points& points) {
    if (CellNumbers::fit(lattice, points.size())) return gridOfMarkedCells(points, CellNumbers(lattice));
    return gridOfSortedPoints(points, lattice);
}

}  // namespace

VoxelCloud voxelGrid(std::span<const Eigen::Vector3d> points, const Eigen::Vector3d& origin,
                     const VoxelGridSettings& settings) {
    check(settings);
    if (points.empty()) return {};
    const Bounds bounds = boundsOf(points);
    if (!bounds.areFinite || !origin.allFinite()) {
        throw Error("point cloud", "a coordinate is not finite", "drop such points first");
    }
    return gridOn(latticeOf(bounds, origin, settings.voxelSize_m), UnmovedPoints{points});
}

VoxelCloud voxelGrid(const MovedPoints& points, const VoxelGridSettings& settings) {
    check(settings);
    const Bounds bounds = boundsOf(points);
    if (bounds.points == 0) return {};
    return gridOn(latticeOf(bounds, bounds.low, settings.voxelSize_m), points);
}

}  // namespace fodscope
