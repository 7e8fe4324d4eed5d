// SPDX-License-Identifier: MIT
#include "core/cloud/BlockOrder.h"

#include <algorithm>
#include <bit>

namespace fodscope {
namespace {

using Points = std::span<PlacedPoint>;

std::size_t longestSide(Points points) {
    std::array<double, 3> low = points.front().at;
    std::array<double, 3> high = low;
    for (const PlacedPoint& point : points) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], point.at[axis]);
            high[axis] = std::max(high[axis], point.at[axis]);
        }
    }
    std::size_t longest = 0;
    // Halved before subtracting: the extent of points near the largest double would overflow.
    const auto length = [&](std::size_t axis) { return 0.5 * high[axis] - 0.5 * low[axis]; };
    for (std::size_t axis = 1; axis < 3; ++axis) {
        if (length(axis) > length(longest)) longest = axis;
    }
    return longest;
}

double medianOf(double a, double b, double c) {
    return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

/// A coordinate of the points near the median, from a few of them.
double pivotOf(Points points, std::size_t axis) {
    const std::size_t last = points.size() - 1;
    const auto at = [&](std::size_t i, std::size_t of) { return points[last * i / of].at[axis]; };
    if (points.size() < 64) return medianOf(at(0, 2), at(1, 2), at(2, 2));
    return medianOf(medianOf(at(0, 8), at(1, 8), at(2, 8)), medianOf(at(3, 8), at(4, 8), at(5, 8)),
                    medianOf(at(6, 8), at(7, 8), at(8, 8)));
}

/// Moves the points for which `isLeft` holds to the front. Every point is swapped, whether it need be or not: a
/// processor guesses the outcome of comparisons wrong half of the time, and that costs more.
/// @return how many there are
template <class IsLeft>
std::size_t partition(Points points, const IsLeft& isLeft) {
    std::size_t left = 0;
    for (PlacedPoint& point : points) {
        const PlacedPoint here = point;
        point = points[left];
        points[left] = here;
        left += isLeft(here) ? 1 : 0;
    }
    return left;
}

/// Puts the points that come first along an axis before `middle`, and the others behind.
void divideAt(Points points, std::size_t middle, std::size_t axis) {
    // Where pivots keep being chosen badly, the standard library's way is never quadratic.
    const int mostRounds = 8 + 2 * std::bit_width(points.size());
    for (int round = 0; round < mostRounds; ++round) {
        if (middle == 0 || middle >= points.size()) return;
        const double pivot = pivotOf(points, axis);
        const std::size_t less = partition(points, [&](const PlacedPoint& p) { return p.at[axis] < pivot; });
        if (middle <= less) {
            points = points.first(less);
            continue;
        }
        points = points.subspan(less);
        middle -= less;
        if (less > 0) continue;
        // The pivot is the least.
        const std::size_t equal = partition(points, [&](const PlacedPoint& p) { return p.at[axis] <= pivot; });
        if (middle <= equal) return;
        points = points.subspan(equal);
        middle -= equal;
    }
    std::nth_element(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(middle), points.end(),
                     [axis](const PlacedPoint& a, const PlacedPoint& b) { return a.at[axis] < b.at[axis]; });
}

/// Divides into parts of `part` points, the last one shorter; `part` is a block, or 8, 64, … of them.
void divideInto(std::size_t part, Points points) {
    if (points.size() <= part) {
        if (part > kBlockSize) divideInto(part / kBlockFan, points);
        return;
    }
    const std::size_t parts = (points.size() + part - 1) / part;
    const std::size_t middle = (parts + 1) / 2 * part;
    divideAt(points, middle, longestSide(points));
    divideInto(part, points.first(middle));
    divideInto(part, points.subspan(middle));
}

}  // namespace

std::vector<PlacedPoint> placedPoints(std::span<const Eigen::Vector3d> points, std::span<const std::uint32_t> indices) {
    std::vector<PlacedPoint> placed(indices.size());
    std::ranges::transform(indices, placed.begin(), [&](std::uint32_t index) {
        const Eigen::Vector3d& point = points[index];
        return PlacedPoint{{point.x(), point.y(), point.z()}, index};
    });
    return placed;
}

void orderInBlocks(std::span<PlacedPoint> points) {
    std::size_t part = kBlockSize;
    while (part < points.size())
        part *= kBlockFan;
    divideInto(part, points);
}

}  // namespace fodscope
