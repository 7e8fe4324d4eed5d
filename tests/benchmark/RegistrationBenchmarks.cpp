// SPDX-License-Identifier: MIT
// How the time of an alignment grows with the map, 10 thousand to 1 million points: a room with a block and a column,
// about a point a square centimetre whatever their number, against 5 cm voxels of another mapping of it. Small rooms
// show too little to tell their pose from anywhere: the counter "aligned" is 0 there, and all proposals are looked at.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "core/cloud/VoxelGrid.h"
#include "core/registration/RegionResiduals.h"
#include "core/registration/Registration.h"

namespace fodscope {
namespace {

struct Box {
    Eigen::Vector3d low;
    Eigen::Vector3d high;
};

/// Its own walls and what stands in it, so that no turn maps it onto itself.
const std::array<Box, 3>& roomOfAMetre() {
    static const std::array<Box, 3> room{Box{{0.0, 0.0, 0.0}, {1.0, 0.8, 0.3}}, Box{{0.1, 0.1, 0.0}, {0.35, 0.2, 0.15}},
                                         Box{{0.7, 0.2, 0.0}, {0.76, 0.26, 0.3}}};
    return room;
}

double area(const Box& box) {
    const Eigen::Vector3d size = box.high - box.low;
    return 2.0 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x());
}

/// Uniform by area, with a centimetre of noise.
std::vector<Eigen::Vector3d> mappedRoom(std::size_t count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::normal_distribution<double> noise_m(0.0, 0.01);
    double whole = 0.0;
    for (const Box& box : roomOfAMetre())
        whole += area(box);
    const double length_m = std::sqrt(static_cast<double>(count) * 1e-4 / whole);
    std::vector<Eigen::Vector3d> points;
    for (const Box& box : roomOfAMetre()) {
        const Eigen::Vector3d size = box.high - box.low;
        const auto share = static_cast<std::size_t>(static_cast<double>(count) * area(box) / whole);
        for (std::size_t i = 0; i < share; ++i) {
            const std::array<double, 3> faces{size.y() * size.z(), size.z() * size.x(), size.x() * size.y()};
            double chosen = uniform(random) * (faces[0] + faces[1] + faces[2]);
            Eigen::Index across = 0;
            while (across < 2 && chosen > faces[static_cast<std::size_t>(across)])
                chosen -= faces[static_cast<std::size_t>(across++)];
            Eigen::Vector3d point(uniform(random), uniform(random), uniform(random));
            point[across] = uniform(random) < 0.5 ? 0.0 : 1.0;
            const Eigen::Vector3d place = length_m * (box.low + point.cwiseProduct(size));
            points.emplace_back(place.x() + noise_m(random), place.y() + noise_m(random), place.z() + noise_m(random));
        }
    }
    return points;
}

struct Rooms {
    explicit Rooms(benchmark::State& state) {
        const auto count = static_cast<std::size_t>(state.range(0));
        const std::vector<Eigen::Vector3d> other = mappedRoom(count, 1);
        reference = voxelGrid(other, minimumCorner(other), {0.05}).points;
        const Transform moved = transformFromPose({3.0, -4.0, 2.2});
        T_reference_from_map = moved.inverse();
        map = mappedRoom(count, 2);
        for (Eigen::Vector3d& point : map)
            point = moved * point;
    }
    std::vector<Eigen::Vector3d> map;
    std::vector<Eigen::Vector3d> reference;
    Transform T_reference_from_map = Transform::Identity();
};

void registerFrom(benchmark::State& state, const Rooms& rooms, const std::optional<Transform>& start) {
    Progress progress;
    bool isGood = true;
    for (auto _ : state) {
        const RegistrationResult result = registerMap(rooms.map, rooms.reference, start, {}, progress);
        isGood = isGood && result.quality == RegistrationQuality::Good;
    }
    state.counters["aligned"] = isGood ? 1.0 : 0.0;
    state.SetComplexityN(state.range(0));
}

void registrationFromAnywhere(benchmark::State& state) {
    registerFrom(state, Rooms(state), std::nullopt);
}

void registrationFromAStart(benchmark::State& state) {
    const Rooms rooms(state);
    registerFrom(state, rooms, transformFromPose({0.05, -0.05, 0.02}) * rooms.T_reference_from_map);
}

void residuals(benchmark::State& state) {
    const Rooms rooms(state);
    Progress progress;
    for (auto _ : state)
        benchmark::DoNotOptimize(
            measureRegionResiduals(rooms.map, rooms.T_reference_from_map, rooms.reference, {}, progress));
    state.SetComplexityN(state.range(0));
}

void sizes(benchmark::internal::Benchmark* benchmark) {
    benchmark->RangeMultiplier(10)->Range(10'000, 1'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK(registrationFromAnywhere)->Apply(sizes);
BENCHMARK(registrationFromAStart)->Apply(sizes);
BENCHMARK(residuals)->Apply(sizes);

}  // namespace
}  // namespace fodscope
