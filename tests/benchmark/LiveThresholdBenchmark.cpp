// SPDX-License-Identifier: MIT
// A threshold or a cutoff is dragged over a field of 200 thousand voxels: milliseconds until the candidates follow, as
// median and 95th percentile over the moves. And the clusters of a threshold from nothing, 10 thousand to a million.
#include <benchmark/benchmark.h>

#include <chrono>

#include "core/detection/HierarchicalClustering.h"
#include "core/detection/LiveCandidates.h"
#include "tests/benchmark/BoxRoom.h"
#include "tests/benchmark/DragPath.h"

namespace fodscope {
namespace {

constexpr std::size_t kVoxels = 200'000;
constexpr std::size_t kMoves = 300;

double millisecondsSince(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

/// From `fewest` to `most` voxels are above the threshold.
void drag(benchmark::State& state) {
    const auto field = drawnField(boxRoom(kVoxels, 6), 7);
    const auto fewest = static_cast<std::size_t>(state.range(0));
    const auto most = static_cast<std::size_t>(state.range(1));
    const std::vector<CandidateSettings> path = dragPath(*field, kMoves, fewest, most, 8);
    std::vector<double> milliseconds;
    for (auto _ : state) {
        LiveCandidates live(field, 0.02, 0.0, Transform::Identity());
        Progress progress;
        for (const CandidateSettings& settings : path) {
            const auto begin = std::chrono::steady_clock::now();
            benchmark::DoNotOptimize(live.find(settings, progress));
            milliseconds.push_back(millisecondsSince(begin));
        }
    }
    state.counters["median_ms"] = quantileOf(milliseconds, 0.5);
    state.counters["p95_ms"] = quantileOf(milliseconds, 0.95);
    state.counters["worst_ms"] = quantileOf(milliseconds, 1.0);
}

void clustersFromNothing(benchmark::State& state) {
    const std::vector<Eigen::Vector3d> points = boxRoom(static_cast<std::size_t>(state.range(0)), 5);
    Progress progress;
    for (auto _ : state)
        benchmark::DoNotOptimize(mergeSequence(points, Linkage::Centroid, 0.345, progress));
    state.SetComplexityN(state.range(0));
}

BENCHMARK(drag)
    ->Args({100, 20'000})
    ->Args({1'000, 2'000})
    ->Args({10'000, 20'000})
    ->Args({50'000, 100'000})
    ->Args({190'000, 200'000})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(clustersFromNothing)
    ->Arg(10'000)
    ->Arg(20'000)
    ->Arg(50'000)
    ->Arg(100'000)
    ->Arg(200'000)
    ->Arg(500'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Complexity(benchmark::oNLogN);

}  // namespace
}  // namespace fodscope
