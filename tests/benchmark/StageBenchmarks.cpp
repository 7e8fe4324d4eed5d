// SPDX-License-Identifier: MIT
// How the stages' times grow with the number of points, 10 thousand to 10 million.
#include <benchmark/benchmark.h>

#include <vector>

#include "core/cloud/NeighbourIndex.h"
#include "core/cloud/OutlierRemoval.h"
#include "core/cloud/VoxelGrid.h"
#include "core/detection/HierarchicalClustering.h"
#include "tests/benchmark/BoxRoom.h"

namespace fodscope {
namespace {

void nearest(benchmark::State& state) {
    const auto count = static_cast<std::size_t>(state.range(0));
    const std::vector<Eigen::Vector3d> reference = boxRoom(count, 1);
    const std::vector<Eigen::Vector3d> map = boxRoom(count, 2);
    Progress progress;
    for (auto _ : state)
        benchmark::DoNotOptimize(NeighbourIndex(reference).nearestOfEach(map, progress));
    state.SetComplexityN(state.range(0));
}

void outliers(benchmark::State& state) {
    const std::vector<Eigen::Vector3d> map = boxRoom(static_cast<std::size_t>(state.range(0)), 3);
    Progress progress;
    for (auto _ : state)
        benchmark::DoNotOptimize(keptByOutlierRemoval(map, {}, progress));
    state.SetComplexityN(state.range(0));
}

void voxels(benchmark::State& state) {
    const std::vector<Eigen::Vector3d> map = boxRoom(static_cast<std::size_t>(state.range(0)), 4);
    for (auto _ : state)
        benchmark::DoNotOptimize(voxelGrid(map, minimumCorner(map), {0.02}));
    state.SetComplexityN(state.range(0));
}

void clusters(benchmark::State& state) {
    const std::vector<Eigen::Vector3d> points = boxRoom(static_cast<std::size_t>(state.range(0)), 5);
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
