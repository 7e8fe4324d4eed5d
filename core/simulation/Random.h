// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace fodscope {

/// A small seeded generator (SplitMix64). The standard library's distributions may differ between implementations;
/// these do not, so a seed means the same simulation everywhere.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next();
    /// In [0, 1).
    double uniform();
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    /// Standard normal (Box–Muller).
    double normal();
    /// In [0, count).
    std::uint64_t below(std::uint64_t count) { return next() % count; }

  private:
    std::uint64_t state_;
    double spare_ = 0.0;
    bool hasSpare_ = false;
};

/// Seed of a sub-stream: work done in parallel takes one stream an item, never one a thread.
std::uint64_t streamSeed(std::uint64_t seed, std::uint64_t stream);

}  // namespace fodscope
