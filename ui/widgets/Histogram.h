// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fodscope {

/// Values in equal bins, kept so that "how many are greater than t" is exact and quick.
class Histogram {
  public:
    Histogram() = default;
    /// The last bin ends at the 99.9 % quantile, and takes all that lies beyond, so that a few far outliers do not
    /// squeeze the rest into one bin. NaN and infinities are counted as unknown.
    Histogram(std::span<const double> values, int binCount);

    bool empty() const { return sorted_.empty(); }
    double minimum() const { return minimum_; }
    /// Upper end of the axis; values may lie beyond.
    double maximum() const { return maximum_; }
    double largest() const;
    std::size_t total() const { return sorted_.size(); }
    std::size_t unknown() const { return unknown_; }
    const std::vector<std::size_t>& counts() const { return counts_; }
    std::size_t countAbove(double threshold) const;

  private:
    std::vector<double> sorted_;
    std::vector<std::size_t> counts_;
    double minimum_ = 0.0;
    double maximum_ = 1.0;
    std::size_t unknown_ = 0;
};

}  // namespace fodscope
