// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/common/Progress.h"

namespace fodscope {

/// Points in runs that lie together in space, each run beside the one before it. Work that is done in this order finds
/// its data in the cache.
struct SpatialRuns {
    /// Indices of the points, run by run.
    std::vector<std::uint32_t> order;
    /// Where each run ends in `order`.
    std::vector<std::uint32_t> ends;

    std::size_t count() const { return ends.size(); }
    std::span<const std::uint32_t> run(std::size_t index) const {
        const std::uint32_t first = index == 0 ? 0 : ends[index - 1];
        return std::span(order).subspan(first, ends[index] - first);
    }
};

/// Sorts the points into the cells of a grid and goes through these along a Hilbert curve; cells that hold too many are
/// divided again by a grid of their own, and where a grid divides badly (a stray point far away, lumps within lumps) at
/// the median. So time is n log n at worst, and memory 10 bytes a point while it lasts. In parallel; the
/// result does not depend on the number of threads.
/// @param points finite
/// @param most points in a run
/// @throws Cancelled
SpatialRuns spatialRuns(std::span<const Eigen::Vector3d> points, std::size_t most, const Progress& progress);

}  // namespace fodscope
