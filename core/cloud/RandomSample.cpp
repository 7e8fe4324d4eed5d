// SPDX-License-Identifier: MIT
#include "core/cloud/RandomSample.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/common/Error.h"

namespace fodscope {

std::vector<std::uint32_t> randomSample(std::size_t count, double ratio, std::uint64_t seed) {
    if (!(ratio > 0.0 && ratio <= 1.0)) {
        throw Error("random ratio", "must be greater than 0 and at most 1", "give a share such as 0.1");
    }
    if (count == 0) return {};
    std::size_t wanted = std::max<std::size_t>(1, static_cast<std::size_t>(ratio * static_cast<double>(count)));
    // std::mt19937_64 gives the same bits everywhere, the standard distributions do not.
    std::mt19937_64 generator(seed);
    std::vector<std::uint32_t> chosen;
    chosen.reserve(wanted);
    for (std::size_t i = 0; i < count && wanted > 0; ++i) {
        const double uniform = static_cast<double>(generator() >> 11) * 0x1.0p-53;
        if (uniform * static_cast<double>(count - i) >= static_cast<double>(wanted)) continue;
        chosen.push_back(static_cast<std::uint32_t>(i));
        --wanted;
    }
    return chosen;
}

}  // namespace fodscope
