// SPDX-License-Identifier: MIT
// The way of a map from its file to its discrepancy, 10 thousand to 10 million points. `peak_B` is what the work adds
// at its peak to the memory held before it, in bytes a point.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "core/cloud/PointCloudIo.h"
#include "core/cloud/VoxelGrid.h"
#include "core/detection/Discrepancy.h"
#include "tests/benchmark/BoxRoom.h"
#include "tests/benchmark/ProcessMemory.h"

namespace fodscope {
namespace {

/// Counts from its construction; tells the benchmark when it goes.
class PeakCounter {
  public:
    explicit PeakCounter(benchmark::State& state) : state_(state), before_(restartPeakMemory()) {}
    ~PeakCounter() {
        const auto points = static_cast<double>(state_.range(0));
        state_.counters["peak_B"] = static_cast<double>(peakMemory() - before_) / points;
        state_.SetItemsProcessed(state_.iterations() * state_.range(0));
        state_.SetComplexityN(state_.range(0));
    }
    PeakCounter(const PeakCounter&) = delete;
    PeakCounter& operator=(const PeakCounter&) = delete;

  private:
    benchmark::State& state_;
    std::size_t before_;
};

PointCloud colouredRoom(std::size_t count) {
    PointCloud cloud;
    cloud.points = boxRoom(count, 6);
    for (std::size_t i = 0; i < count; ++i)
        cloud.colours.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i >> 8), 40});
    return cloud;
}

/// A file that is gone afterwards.
class RoomFile {
  public:
    RoomFile(std::size_t count, const std::string& extension, PcdEncoding encoding)
        : path_(std::filesystem::temp_directory_path() / ("fodscope-benchmark-room" + extension)) {
        writePointCloud(path_, colouredRoom(count), encoding);
    }
    ~RoomFile() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    RoomFile(const RoomFile&) = delete;
    RoomFile& operator=(const RoomFile&) = delete;
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

void reading(benchmark::State& state, const std::string& extension, PcdEncoding encoding) {
    const RoomFile file(static_cast<std::size_t>(state.range(0)), extension, encoding);
    const PeakCounter peak(state);
    for (auto _ : state)
        benchmark::DoNotOptimize(readPointCloud(file.path()));
}

void voxelMap(benchmark::State& state) {
    const std::vector<Eigen::Vector3d> map = boxRoom(static_cast<std::size_t>(state.range(0)), 4);
    const PeakCounter peak(state);
    for (auto _ : state)
        benchmark::DoNotOptimize(voxelGrid(MovedPoints{map}, {0.02}));
}

void discrepancy(benchmark::State& state) {
    const std::vector<Eigen::Vector3d> map = boxRoom(static_cast<std::size_t>(state.range(0)), 7);
    ReferenceMap reference;
    reference.points = voxelGrid(boxRoom(map.size(), 8), Eigen::Vector3d::Zero(), {0.05}).points;
    reference.covariance.assign(reference.size(), Eigen::Matrix3d::Identity() * 1e-4);
    Progress progress;
    const PeakCounter peak(state);
    for (auto _ : state)
        benchmark::DoNotOptimize(measureDiscrepancy(map, Transform::Identity(), reference, {}, progress));
}

void sizes(benchmark::internal::Benchmark* run) {
    run->RangeMultiplier(10)->Range(10'000, 10'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK_CAPTURE(reading, pcd_binary, ".pcd", PcdEncoding::Binary)->Apply(sizes);
BENCHMARK_CAPTURE(reading, pcd_compressed, ".pcd", PcdEncoding::BinaryCompressed)->Apply(sizes);
BENCHMARK_CAPTURE(reading, pcd_ascii, ".pcd", PcdEncoding::Ascii)->Apply(sizes);
BENCHMARK_CAPTURE(reading, ply, ".ply", PcdEncoding::Binary)->Apply(sizes);
BENCHMARK(voxelMap)->Apply(sizes);
BENCHMARK(discrepancy)->Apply(sizes);

}  // namespace
}  // namespace fodscope
