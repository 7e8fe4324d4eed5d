// SPDX-License-Identifier: MIT
#include "core/planning/DistanceTransform.h"

#include <algorithm>

namespace fodscope {
namespace {

// Squares of distances up to this stay well inside 32 bits.
constexpr int kGreatestLimit_cells = 30'000;

std::int64_t square(std::int64_t value) {
    return value * value;
}

std::int64_t floorDivide(std::int64_t numerator, std::int64_t positiveDenominator) {
    const std::int64_t quotient = numerator / positiveDenominator;
    return numerator % positiveDenominator < 0 ? quotient - 1 : quotient;
}

/// Distance to the nearest source in the same column.
std::vector<std::int32_t> columnDistances(std::span<const std::uint8_t> isSource, int width, int height, int limit) {
    const auto columns = static_cast<std::size_t>(width);
    std::vector<std::int32_t> distance(isSource.size(), kNoSourceNear);
    const auto relax = [&](std::size_t cell, std::size_t neighbour) {
        if (distance[neighbour] < limit) distance[cell] = std::min(distance[cell], distance[neighbour] + 1);
    };
    for (std::size_t cell = 0; cell < isSource.size(); ++cell) {
        if (isSource[cell] != 0) {
            distance[cell] = 0;
        } else if (cell >= columns) {
            relax(cell, cell - columns);
        }
    }
    for (std::size_t row = static_cast<std::size_t>(height) - 1; row-- > 0;) {
        for (std::size_t column = 0; column < columns; ++column) {
            relax(row * columns + column, (row + 1) * columns + column);
        }
    }
    return distance;
}

/// A column whose source is the nearest one from `start` on, until the next parabola's start.
struct Parabola {
    std::int64_t column;
    std::int64_t start;
};

}  // namespace

std::vector<std::int32_t> squaredCellDistances(std::span<const std::uint8_t> isSource, int width, int height,
                                               int limit_cells) {
    if (isSource.empty()) return {};
    const int limit = std::clamp(limit_cells, 0, kGreatestLimit_cells);
    std::vector<std::int32_t> result = columnDistances(isSource, width, height, limit);
    std::vector<std::int32_t> vertical(static_cast<std::size_t>(width));
    std::vector<Parabola> envelope;
    for (int row = 0; row < height; ++row) {
        const auto first = static_cast<std::size_t>(row) * static_cast<std::size_t>(width);
        std::copy_n(result.begin() + static_cast<std::ptrdiff_t>(first), width, vertical.begin());
        const auto height2 = [&](std::int64_t column) { return square(vertical[static_cast<std::size_t>(column)]); };
        envelope.clear();
        for (std::int64_t column = 0; column < width; ++column) {
            if (vertical[static_cast<std::size_t>(column)] == kNoSourceNear) continue;
            std::int64_t start = 0;
            while (!envelope.empty()) {
                const std::int64_t other = envelope.back().column;
                start = 1 + floorDivide(square(column) - square(other) + height2(column) - height2(other),
                                        2 * (column - other));
                if (start > envelope.back().start) break;
                envelope.pop_back();
                start = 0;
            }
            if (start < width) envelope.push_back({column, std::max<std::int64_t>(start, 0)});
        }
        std::size_t nearest = 0;
        for (std::int64_t column = 0; column < width; ++column) {
            while (nearest + 1 < envelope.size() && envelope[nearest + 1].start <= column)
                ++nearest;
            std::int64_t distance2 = kNoSourceNear;
            if (!envelope.empty()) {
                distance2 = square(column - envelope[nearest].column) + height2(envelope[nearest].column);
                if (distance2 > square(limit)) distance2 = kNoSourceNear;
            }
            result[first + static_cast<std::size_t>(column)] = static_cast<std::int32_t>(distance2);
        }
    }
    return result;
}

}  // namespace fodscope
