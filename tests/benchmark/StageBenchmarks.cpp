// SPDX-License-Identifier: MIT
// How the stages' times grow with the number of points, 10 thousand to 10 million: points on the walls of a box room
// with a centimetre of noise, as dense as a map of a tank.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/cloud/NeighbourIndex.h"
#include "core/cloud/OutlierRemoval.h"
#include "core/cloud/VoxelGrid.h"
#include "core/detection/HierarchicalClustering.h"

namespace fodscope {
namespace {

/// About a point a square centimetre, whatever their number: the room grows with it.
std::vector<Eigen::Vector3d> room(std::size_t count, std::uint64_t seed) {
    std::mt19937_64 generator(seed);
    const double edge_m = std::sqrt(static_cast<double>(count) / 6.0 * 1e-4);
    std::uniform_real_distribution<double> along(0.0, edge_m);
    std::normal_distribution<double> noise(0.0, 0.01);
    std::vector<Eigen::Vector3d> points(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto axis = static_cast<Eigen::Index>(i % 3);
        Eigen::Vector3d& point = points[i];
        for (Eigen::Index other = 0; other < 3; ++other)
            point[other] = along(generator);
        point[axis] = (i / 3) % 2 == 0 ? 0.0 : edge_m;
        for (Eigen::Index other = 0; other < 3; ++other)
            point[other] += noise(generator);
    }
    return points;
}

void nearest(benchmark::State& state) {
    const auto count = static_cast<std::size_t>(state.range(0));
    const std::vector<Eigen::Vector3d> reference = room(count, 1);
    const std::vector<Eigen::Vector3d> map = room(count, 2);
    Progress progress;
    for (auto _ : state)
        benchmark::DoNotOptimize(NeighbourIndex(reference).nearestOfEach(map, progress));
    state.SetComplexityN(state.range(0));
}

void outliers(benchmark::State& state) {
    const std::vector<Eigen::Vector3d> map = room(static_cast<std::size_t>(state.range(0)), 3);
    Progress progress;
    for (auto _ : state)
        benchmark::DoNotOptimize(keptByOutlierRemoval(map, {}, progress));
    state.SetComplexityN(state.range(0));
}

void voxels(benchmark::State& state) {
    const std::vector<Eigen::Vector3d> map = room(static_cast<std::size_t>(state.range(0)), 4);
    for (auto _ : state)
        benchmark::DoNotOptimize(voxelGrid(map, minimumCorner(map), {0.02}));
    state.SetComplexityN(state.range(0));
}

void clusters(benchmark::State& state) {
    const std::vector<Eigen::Vector3d> points = room(static_cast<std::size_t>(state.range(0)), 5);
    Progress progress;
    for (auto _ : state)
        benchmark::DoNotOptimize(mergeSequence(points, Linkage::Centroid, 0.345, progress));
    state.SetComplexityN(state.range(0));
}

BENCHMARK(nearest)->RangeMultiplier(10)->Range(10'000, 10'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(outliers)->RangeMultiplier(10)->Range(10'000, 10'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(voxels)->RangeMultiplier(10)->Range(10'000, 10'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(clusters)->RangeMultiplier(10)->Range(1'000, 100'000)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace fodscope

BENCHMARK_MAIN();
