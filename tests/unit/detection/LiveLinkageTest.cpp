// SPDX-License-Identifier: MIT
// Merges of a set that changes are those of the set alone, in the same order.
#include "core/detection/LiveLinkage.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <tuple>

#include "core/common/Error.h"
#include "core/detection/HierarchicalClustering.h"
#include "tests/unit/cloud/RandomPoints.h"

namespace fodscope {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Points lattice(int nx, int ny, int nz) {
    Points points;
    for (int x = 0; x < nx; ++x)
        for (int y = 0; y < ny; ++y)
            for (int z = 0; z < nz; ++z)
                points.emplace_back(0.1 * x, 0.1 * y, 0.1 * z);
    return points;
}

/// Points on a thin floor, as dense as a map there.
Points floorOf(std::size_t count, std::uint64_t seed) {
    Points points = randomPoints(count, seed);
    for (Eigen::Vector3d& point : points)
        point = {3.0 * point.x(), 2.0 * point.y(), 0.02 * point.z()};
    return points;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> fromNothing(const Points& all, const std::set<std::uint32_t>& ids,
                                                                 double cutoff_m) {
    const std::vector<std::uint32_t> idOf(ids.begin(), ids.end());
    Points points;
    for (const std::uint32_t id : ids)
        points.push_back(all[id]);
    Progress progress;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> merges;
    for (const Merge& merge : mergeSequence(points, Linkage::Centroid, cutoff_m, progress).merges)
        merges.emplace_back(idOf[merge.kept], idOf[merge.removed]);
    return merges;
}

/// Takes points in and out: mostly a few, now and then nearly all.
void change(std::set<std::uint32_t>& ids, std::size_t all, std::mt19937_64& generator) {
    const std::size_t most = generator() % 8 == 0 ? all : 1 + all / 50;
    const std::size_t count = generator() % most;
    for (std::size_t i = 0; i <= count; ++i) {
        const auto id = static_cast<std::uint32_t>(generator() % all);
        if (!ids.erase(id)) ids.insert(id);
    }
}

void expectAsFromNothing(const Points& all, int changes, std::uint64_t seed) {
    std::mt19937_64 generator(seed);
    LiveLinkage live(all);
    std::set<std::uint32_t> ids;
    Progress progress;
    for (int i = 0; i < changes; ++i) {
        change(ids, all.size(), generator);
        std::vector<LivingCluster> clusters;
        for (const std::uint32_t id : ids)
            clusters.push_back({all[id], id, 1});
        live.restart(clusters);
        for (int cutoffs = 0; cutoffs < 3; ++cutoffs) {
            const double cutoff_m = 0.1 * static_cast<double>(generator() % 60) / 10.0;
            live.advance(cutoff_m, progress);
            std::vector<std::pair<std::uint32_t, std::uint32_t>> merges;
            live.forEachMerge(cutoff_m, [&](auto kept, auto removed) { merges.emplace_back(kept, removed); });
            ASSERT_EQ(merges, fromNothing(all, ids, cutoff_m)) << "change " << i << ", cutoff " << cutoff_m;
        }
    }
}

TEST(LiveLinkage, RepeatsWhatStaysAndNothingElse) {
    for (const std::uint64_t seed : {1u, 2u, 3u})
        expectAsFromNothing(randomPoints(300, seed), 300, seed);
}

TEST(LiveLinkage, KeepsTheOrderOfTies) {
    expectAsFromNothing(lattice(10, 10, 3), 300, 4);
    expectAsFromNothing(lattice(25, 20, 1), 200, 5);
    expectAsFromNothing(lattice(200, 1, 1), 200, 6);
}

TEST(LiveLinkage, RepeatsOnALargeFloor) {
    expectAsFromNothing(floorOf(8000, 7), 30, 7);
}

TEST(LiveLinkage, HandlesSetsOfOneAndNone) {
    const Points all = randomPoints(5, 8);
    LiveLinkage live(all);
    Progress progress;
    for (const std::size_t count : {0u, 1u, 2u, 0u, 5u, 1u}) {
        std::vector<LivingCluster> clusters;
        for (std::uint32_t id = 0; id < count; ++id)
            clusters.push_back({all[id], id, 1});
        live.restart(clusters);
        live.advance(10.0, progress);
        std::size_t merges = 0;
        live.forEachMerge(10.0, [&](auto, auto) { ++merges; });
        EXPECT_EQ(merges, count == 0 ? 0 : count - 1);
    }
}

TEST(LiveLinkage, StopsWhenCancelled) {
    const Points all = randomPoints(50, 9);
    LiveLinkage live(all);
    live.restart({{all[0], 0, 1}, {all[1], 1, 1}});
    Progress progress;
    progress.cancel();
    EXPECT_THROW(live.advance(1.0, progress), Cancelled);
}

}  // namespace
}  // namespace fodscope
