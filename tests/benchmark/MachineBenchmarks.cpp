// SPDX-License-Identifier: MIT
// What the machine itself can do, with all its cores: the bounds that the stages' times are held against.
#include <benchmark/benchmark.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <vector>

namespace fodscope {
namespace {

/// Bytes read and written a second, far beyond the caches.
void memoryBandwidth(benchmark::State& state) {
    const std::vector<double> from(1 << 26, 1.0);
    std::vector<double> to(from.size());
    for (auto _ : state) {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, from.size(), 1 << 20), [&](const auto& part) {
            std::copy(from.begin() + static_cast<std::ptrdiff_t>(part.begin()),
                      from.begin() + static_cast<std::ptrdiff_t>(part.end()),
                      to.begin() + static_cast<std::ptrdiff_t>(part.begin()));
        });
        benchmark::DoNotOptimize(to.data());
        benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * 2 * sizeof(double) * from.size()));
}

/// Points in the first cache, coordinates by axis.
struct Near {
    static constexpr std::size_t kCount = 512;
    std::array<std::array<double, kCount>, 3> at{};
    std::array<double, kCount> least{};
};

#if defined(__x86_64__)
__attribute__((target("avx2"), optimize("O3")))
#endif
void meet(Near& points, double x, double y, double z) {
    for (std::size_t i = 0; i < Near::kCount; ++i) {
        const double dx = points.at[0][i] - x;
        const double dy = points.at[1][i] - y;
        const double dz = points.at[2][i] - z;
        const double squared = dx * dx + dy * dy + dz * dz;
        points.least[i] = squared < points.least[i] ? squared : points.least[i];
    }
}

/// Squared distances in double precision a second, with all data in the first cache.
void distanceEvaluations(benchmark::State& state) {
    constexpr std::size_t queries = 1 << 16;
    for (auto _ : state) {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, queries, 1 << 10), [&](const auto& part) {
            Near points;
            points.least.fill(1e9);
            for (std::size_t query = part.begin(); query < part.end(); ++query)
                meet(points, static_cast<double>(query), 1.0, 2.0);
            benchmark::DoNotOptimize(points.least.data());
        });
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * queries * Near::kCount));
}

BENCHMARK(memoryBandwidth)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(distanceEvaluations)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace fodscope
