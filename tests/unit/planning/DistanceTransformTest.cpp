// SPDX-License-Identifier: MIT
#include "core/planning/DistanceTransform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace fodscope {
namespace {

std::vector<std::int32_t> bruteForce(const std::vector<std::uint8_t>& sources, int width, int height, int limit) {
    std::vector<std::int32_t> result(sources.size(), kNoSourceNear);
    for (int cell = 0; cell < width * height; ++cell) {
        for (int other = 0; other < width * height; ++other) {
            if (sources[static_cast<std::size_t>(other)] == 0) continue;
            const int dx = cell % width - other % width;
            const int dy = cell / width - other / width;
            const int distance2 = dx * dx + dy * dy;
            auto& nearest = result[static_cast<std::size_t>(cell)];
            if (distance2 <= limit * limit) nearest = std::min(nearest, distance2);
        }
    }
    return result;
}

TEST(DistanceTransform, equalsBruteForceInEveryCell) {
    std::mt19937 random(7);
    for (const double density : {0.002, 0.02, 0.3}) {
        for (const auto& [width, height] : {std::pair{61, 40}, std::pair{1, 50}, std::pair{50, 1}, std::pair{1, 1}}) {
            std::vector<std::uint8_t> sources(static_cast<std::size_t>(width * height));
            std::bernoulli_distribution isSource(density);
            for (auto& source : sources)
                source = isSource(random) ? 1 : 0;
            for (const int limit : {0, 3, 10, 200}) {
                EXPECT_EQ(squaredCellDistances(sources, width, height, limit),
                          bruteForce(sources, width, height, limit))
                    << width << "x" << height << ", limit " << limit;
            }
        }
    }
}

TEST(DistanceTransform, withoutSourcesNothingIsNear) {
    const std::vector<std::uint8_t> none(12, 0);
    EXPECT_EQ(squaredCellDistances(none, 4, 3, 100), std::vector<std::int32_t>(12, kNoSourceNear));
    EXPECT_TRUE(squaredCellDistances({}, 0, 0, 5).empty());
}

}  // namespace
}  // namespace fodscope
