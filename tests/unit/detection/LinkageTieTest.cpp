// SPDX-License-Identifier: MIT
// Points whose distances tie: the documented rule decides, as step by step in a brute-force implementation.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <random>
#include <utility>

#include "core/detection/HierarchicalClustering.h"
#include "tests/unit/cloud/RandomPoints.h"
#include "tests/unit/detection/BruteForceClusters.h"

namespace fodscope {
namespace {

using Points = std::vector<Eigen::Vector3d>;

/// Fisher and Yates; std::shuffle differs between standard libraries.
Points shuffled(Points points, std::uint64_t seed) {
    std::mt19937_64 generator(seed);
    for (std::size_t i = points.size(); i > 1; --i)
        std::swap(points[i - 1], points[generator() % i]);
    return points;
}

Points grid(int nx, int ny, int nz, double spacing_m) {
    Points points;
    for (int x = 0; x < nx; ++x)
        for (int y = 0; y < ny; ++y)
            for (int z = 0; z < nz; ++z)
                points.emplace_back(x * spacing_m, y * spacing_m, z * spacing_m);
    return points;
}

void expectAsBruteForce(const Points& points, std::initializer_list<double> ascendingCutoffs_m) {
    Progress progress;
    for (const Linkage linkage : {Linkage::Centroid, Linkage::Single}) {
        BruteForceClusters expected(points, linkage);
        for (const double cutoff_m : ascendingCutoffs_m) {
            EXPECT_EQ(linkageClusters(points, linkage, cutoff_m, progress), expected.at(cutoff_m))
                << (linkage == Linkage::Single ? "single " : "centroid ") << cutoff_m;
        }
    }
}

TEST(LinkageTies, OnRegularGrids) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        expectAsBruteForce(shuffled(grid(14, 10, 1, 1.0), seed), {0.0, 0.9, 1.0, 1.3, 2.0, 3.0, 5.0});
        expectAsBruteForce(shuffled(grid(5, 5, 5, 0.02), seed), {0.0, 0.019, 0.02, 0.021, 0.03, 0.04, 0.06, 0.1});
        expectAsBruteForce(shuffled(grid(100, 1, 1, 0.25), seed), {0.0, 0.25, 0.5, 1.0, 3.0, 40.0});
    }
}

TEST(LinkageTies, WithCoincidentPoints) {
    for (const std::uint64_t seed : {1u, 2u}) {
        Points points = randomPoints(40, seed);
        for (std::size_t i = 0; i < 40; ++i)
            for (std::size_t copy = 0; copy < i % 4; ++copy)
                points.push_back(points[i]);
        expectAsBruteForce(shuffled(points, seed), {0.0, 0.1, 0.2, 0.3, 0.5, 1.0});
        Points lattice = grid(4, 4, 2, 0.5);
        const Points twice = grid(4, 2, 2, 0.5);
        lattice.insert(lattice.end(), twice.begin(), twice.end());
        expectAsBruteForce(shuffled(lattice, seed), {0.0, 0.4, 0.5, 0.6, 0.75, 1.0});
    }
}

TEST(LinkageTies, OnSymmetricFigures) {
    // Inversions among ties: squares and triangles whose merged centroids come nearer to the rest.
    expectAsBruteForce({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {0.9, 1.0, 1.2});
    expectAsBruteForce({{0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {2, -3, 0}}, {3.0, 3.5, 3.7, 4.0});
    expectAsBruteForce({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, {1.0, 1.42, 2.0});
}

TEST(LinkageTies, GiveTheSameClustersWithOneThreadAndWithTwo) {
    const Points points = shuffled(grid(20, 20, 4, 0.02), 5);
    for (const Linkage linkage : {Linkage::Centroid, Linkage::Single}) {
        std::vector<std::vector<Merge>> merges;
        for (const std::size_t threads : {1u, 2u}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            Progress progress;
            merges.push_back(mergeSequence(points, linkage, 0.2, progress).merges);
        }
        EXPECT_EQ(merges[0], merges[1]);
    }
}

}  // namespace
}  // namespace fodscope
