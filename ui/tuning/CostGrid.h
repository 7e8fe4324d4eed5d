// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <cstddef>
#include <optional>
#include <vector>

namespace fodscope {

struct Theme;

/// The cost of every cutoff with every threshold, at one count of least points. NaN: not known.
struct CostGrid {
    std::vector<double> cutoffs_m;
    std::vector<double> thresholds;
    /// One row of cutoffs for each threshold.
    std::vector<double> cost_m;

    bool empty() const { return cost_m.empty(); }
    std::size_t index(std::size_t cutoff, std::size_t threshold) const { return threshold * cutoffs_m.size() + cutoff; }
    double at(std::size_t cutoff, std::size_t threshold) const { return cost_m[index(cutoff, threshold)]; }
};

struct CostCell {
    std::size_t cutoff = 0;
    std::size_t threshold = 0;

    bool operator==(const CostCell&) const = default;
};

/// @return the cell of least cost; of several the one with the lower threshold, then the lower cutoff; empty when no
///         cost is known
std::optional<CostCell> cheapestCell(const CostGrid& grid);

/// From the least cost to one that nine in ten stay under: a few settings that find nothing must not take all colours.
struct CostRange {
    double least_m = 0.0;
    double most_m = 1.0;
};
CostRange costRange(const CostGrid& grid);

/// @return one pixel a cell, cutoffs to the right and thresholds upwards, viridis over the range; unknown is
/// transparent
QImage costImage(const CostGrid& grid, const CostRange& range);

}  // namespace fodscope
