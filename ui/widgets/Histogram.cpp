// SPDX-License-Identifier: MIT
#include "ui/widgets/Histogram.h"

#include <algorithm>
#include <cmath>

namespace fodscope {

Histogram::Histogram(std::span<const double> values, int binCount) {
    sorted_.reserve(values.size());
    for (const double value : values) {
        if (std::isfinite(value)) sorted_.push_back(value);
    }
    unknown_ = values.size() - sorted_.size();
    std::sort(sorted_.begin(), sorted_.end());
    counts_.assign(static_cast<std::size_t>(std::max(1, binCount)), 0);
    if (sorted_.empty()) return;

    minimum_ = std::min(0.0, sorted_.front());
    const auto quantile = static_cast<std::size_t>(0.999 * static_cast<double>(sorted_.size() - 1));
    maximum_ = sorted_[quantile];
    if (!(maximum_ > minimum_)) maximum_ = std::max(sorted_.back(), minimum_ + 1.0);
    const double scale = static_cast<double>(counts_.size()) / (maximum_ - minimum_);
    for (const double value : sorted_) {
        const auto bin = static_cast<std::size_t>(std::max(0.0, (value - minimum_) * scale));
        ++counts_[std::min(bin, counts_.size() - 1)];
    }
}

double Histogram::largest() const {
    return sorted_.empty() ? maximum_ : sorted_.back();
}

std::size_t Histogram::countAbove(double threshold) const {
    return static_cast<std::size_t>(sorted_.end() - std::upper_bound(sorted_.begin(), sorted_.end(), threshold));
}

}  // namespace fodscope
