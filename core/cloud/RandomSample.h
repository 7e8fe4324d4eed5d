// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace fodscope {

/// Draws ⌊ratio · count⌋ of `count` things without replacement (Open3D's `random_down_sample`), at least one of them,
/// every selection as likely as any other. The same numbers give the same selection on every machine.
/// Source: Knuth, "The Art of Computer Programming" 2, algorithm 3.4.2 S.
/// @param ratio greater than 0, at most 1
/// @return ascending indices
std::vector<std::uint32_t> randomSample(std::size_t count, double ratio, std::uint64_t seed);

}  // namespace fodscope
