// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace fodscope {

/// Where a cell of a grid of 2^bits × 2^bits × 2^bits cells comes on a Hilbert curve through it: one that visits every
/// cell once and steps from cell to neighbouring cell. Source: Skilling, Programming the Hilbert curve, 2004.
std::uint32_t hilbertRank(std::array<std::uint32_t, 3> cell, int bits);

/// The ranks of all cells; that of (x, y, z) at (x · side + y) · side + z, with side 2^bits. At most 5 bits.
std::vector<std::uint16_t> hilbertRanks(int bits);

}  // namespace fodscope
