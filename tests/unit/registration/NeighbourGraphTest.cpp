// SPDX-License-Identifier: MIT
#include "core/registration/NeighbourGraph.h"

#include <gtest/gtest.h>

#include <random>

#include "core/common/Error.h"
#include "core/common/Geometry.h"

namespace fodscope {
namespace {

/// A thin layer, as the surfaces of a map are.
std::vector<Eigen::Vector3d> scattered(std::size_t count, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> along(0.0, 3.0);
    std::vector<Eigen::Vector3d> points(count);
    for (Eigen::Vector3d& point : points)
        point = {along(generator), along(generator), 0.02 * along(generator)};
    return points;
}

void expectSame(const std::vector<Neighbour>& walked, const std::vector<Neighbour>& searched) {
    ASSERT_EQ(walked.size(), searched.size());
    for (std::size_t i = 0; i < searched.size(); ++i) {
        ASSERT_EQ(walked[i].index, searched[i].index) << i;
        ASSERT_EQ(walked[i].squaredDistance_m2, searched[i].squaredDistance_m2) << i;
    }
}

TEST(NeighbourGraph, FindsWhatASearchFindsHoweverFarThePointsMove) {
    const std::vector<Eigen::Vector3d> targets = scattered(2000, 1);
    const std::vector<Eigen::Vector3d> points = scattered(9000, 2);
    Progress progress;
    const NeighbourGraph graph(targets, progress);
    std::vector<Neighbour> nearest;
    Transform pose = Transform::Identity();
    for (const double step_m : {0.0, 1e-9, 0.001, 0.004, 0.02, 0.3, 5.0, -4.9, 0.002, 0.0005, 0.0}) {
        pose = transformFromPose({step_m, -0.7 * step_m, 0.5 * step_m}) * pose;
        std::vector<Eigen::Vector3d> moved;
        for (const Eigen::Vector3d& point : points)
            moved.push_back(pose * point);
        graph.update(moved, nearest, progress);
        expectSame(nearest, graph.index().nearestOfEach(moved, progress));
    }
}

TEST(NeighbourGraph, TakesTheFirstOfPointsAtTheSameDistanceOnEveryWay) {
    // Queries walk along the middle between pairs of targets, some of which are there several times.
    std::vector<Eigen::Vector3d> targets;
    for (int i = 0; i < 40; ++i) {
        targets.emplace_back(0.1 * (i % 20), 0.05, 0.0);
        targets.emplace_back(0.1 * (i % 20), -0.05, 0.0);
    }
    for (int i = 0; i < 30; ++i)
        targets.emplace_back(0.5, 0.05, 0.0);
    Progress progress;
    const NeighbourGraph graph(targets, progress);
    for (std::uint32_t hint = 0; hint < targets.size(); ++hint) {
        for (int step = 0; step < 40; ++step) {
            const Eigen::Vector3d query(0.05 * step, 0.0, 0.0);
            const Neighbour searched = graph.index().nearest(query);
            const Neighbour walked = graph.nearest(query, hint);
            ASSERT_EQ(walked.index, searched.index) << hint << " " << step;
            ASSERT_EQ(walked.squaredDistance_m2, searched.squaredDistance_m2) << hint << " " << step;
        }
    }
}

TEST(NeighbourGraph, FewPointsAreAllLinked) {
    Progress progress;
    for (const std::size_t count : {1u, 2u, 12u, 13u, 14u}) {
        const std::vector<Eigen::Vector3d> targets = scattered(count, 3);
        const NeighbourGraph graph(targets, progress);
        EXPECT_EQ(graph.linksOf(0).size(), std::min(count - 1, NeighbourGraph::kLinks));
        std::vector<Neighbour> nearest;
        const std::vector<Eigen::Vector3d> queries = scattered(200, 4);
        graph.update(queries, nearest, progress);
        expectSame(nearest, graph.index().nearestOfEach(queries, progress));
    }
}

TEST(NeighbourGraph, NoPointsAreAnErrorAndCancellingIsNone) {
    Progress progress;
    EXPECT_THROW(NeighbourGraph({}, progress), Error);
    const std::vector<Eigen::Vector3d> targets = scattered(100, 5);
    const NeighbourGraph graph(targets, progress);
    progress.cancel();
    std::vector<Neighbour> nearest;
    EXPECT_THROW(graph.update(targets, nearest, progress), Cancelled);
}

}  // namespace
}  // namespace fodscope
