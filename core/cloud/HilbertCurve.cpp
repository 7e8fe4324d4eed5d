// SPDX-License-Identifier: MIT
#include "core/cloud/HilbertCurve.h"

namespace fodscope {

std::uint32_t hilbertRank(std::array<std::uint32_t, 3> cell, int bits) {
    auto& [x, y, z] = cell;
    const std::uint32_t top = 1U << (bits - 1);
    // Undoes the turns and mirrorings of the curve in each octant, from the largest to the smallest.
    for (std::uint32_t bit = top; bit > 1; bit >>= 1) {
        const std::uint32_t below = bit - 1;
        for (std::uint32_t& axis : cell) {
            if ((axis & bit) != 0) {
                x ^= below;
            } else {
                const std::uint32_t different = (x ^ axis) & below;
                x ^= different;
                axis ^= different;
            }
        }
    }
    y ^= x;
    z ^= y;
    std::uint32_t gray = 0;
    for (std::uint32_t bit = top; bit > 1; bit >>= 1)
        if ((z & bit) != 0) gray ^= bit - 1;
    std::uint32_t rank = 0;
    for (int bit = bits - 1; bit >= 0; --bit)
        for (const std::uint32_t axis : cell)
            rank = rank << 1 | (((axis ^ gray) >> bit) & 1U);
    return rank;
}

std::vector<std::uint16_t> hilbertRanks(int bits) {
    const std::uint32_t side = 1U << bits;
    std::vector<std::uint16_t> ranks;
    ranks.reserve(std::size_t{side} * side * side);
    for (std::uint32_t x = 0; x < side; ++x)
        for (std::uint32_t y = 0; y < side; ++y)
            for (std::uint32_t z = 0; z < side; ++z)
                ranks.push_back(static_cast<std::uint16_t>(hilbertRank({x, y, z}, bits)));
    return ranks;
}

}  // namespace fodscope
