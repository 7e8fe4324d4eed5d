// SPDX-License-Identifier: MIT
#include "ui/tuning/CostGrid.h"

#include <algorithm>
#include <cmath>

#include "ui/theme/Colours.h"

namespace fodscope {
namespace {

constexpr double kShownShare = 0.9;

}  // namespace

std::optional<CostCell> cheapestCell(const CostGrid& grid) {
    std::optional<CostCell> best;
    for (std::size_t threshold = 0; threshold < grid.thresholds.size(); ++threshold) {
        for (std::size_t cutoff = 0; cutoff < grid.cutoffs_m.size(); ++cutoff) {
            const double cost = grid.at(cutoff, threshold);
            if (!std::isfinite(cost)) continue;
            if (!best || cost < grid.at(best->cutoff, best->threshold)) best = CostCell{cutoff, threshold};
        }
    }
    return best;
}

CostRange costRange(const CostGrid& grid) {
    std::vector<double> known;
    std::ranges::copy_if(grid.cost_m, std::back_inserter(known), [](double cost) { return std::isfinite(cost); });
    if (known.empty()) return {};
    std::ranges::sort(known);
    const auto upper = static_cast<std::size_t>(kShownShare * static_cast<double>(known.size() - 1));
    return {known.front(), known[upper]};
}

QImage costImage(const CostGrid& grid, const CostRange& range) {
    const int width = static_cast<int>(grid.cutoffs_m.size());
    const int height = static_cast<int>(grid.thresholds.size());
    QImage image(width, height, QImage::Format_ARGB32);
    image.fill(Qt::transparent);
    const double span = range.most_m - range.least_m;
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const double cost = grid.at(static_cast<std::size_t>(column), static_cast<std::size_t>(row));
            if (!std::isfinite(cost)) continue;
            const double t = span > 0.0 ? std::clamp((cost - range.least_m) / span, 0.0, 1.0) : 0.0;
            image.setPixel(column, height - 1 - row, viridis(t).rgba());
        }
    }
    return image;
}

}  // namespace fodscope
