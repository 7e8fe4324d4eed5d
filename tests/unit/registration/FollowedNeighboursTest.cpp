// SPDX-License-Identifier: MIT
#include "core/registration/FollowedNeighbours.h"

#include <gtest/gtest.h>

#include <random>

#include "core/common/Geometry.h"

namespace fodscope {
namespace {

std::vector<Eigen::Vector3d> scattered(std::size_t count, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> along(0.0, 3.0);
    std::vector<Eigen::Vector3d> points(count);
    for (Eigen::Vector3d& point : points)
        point = {along(generator), along(generator), 0.02 * along(generator)};
    return points;
}

void expectSame(std::span<const Neighbour> followed, const std::vector<Neighbour>& searched) {
    ASSERT_EQ(followed.size(), searched.size());
    for (std::size_t i = 0; i < searched.size(); ++i) {
        ASSERT_EQ(followed[i].index, searched[i].index) << i;
        ASSERT_EQ(followed[i].squaredDistance_m2, searched[i].squaredDistance_m2) << i;
    }
}

TEST(FollowedNeighbours, AreThoseOfASearchHoweverFarThePointsMove) {
    const std::vector<Eigen::Vector3d> targets = scattered(2000, 1);
    const NeighbourIndex index(targets);
    // Few points and many are searched in different ways.
    for (const std::size_t count : {500u, 30'000u}) {
        const std::vector<Eigen::Vector3d> points = scattered(count, 2);
        FollowedNeighbours neighbours(index, targets);
        Progress progress;
        Transform pose = Transform::Identity();
        for (const double step_m : {0.0, 1e-9, 0.001, 0.004, 0.01, 0.3, 0.002, 0.0005, 0.0}) {
            pose = transformFromPose({step_m, -0.7 * step_m, 0.5 * step_m}) * pose;
            std::vector<Eigen::Vector3d> moved;
            for (const Eigen::Vector3d& point : points)
                moved.push_back(pose * point);
            expectSame(neighbours.nearestOf(moved, progress), index.nearestOfEach(moved, progress));
        }
    }
}

TEST(FollowedNeighbours, OfTargetsAtTheSameDistanceTheFirstIsFoundOnEveryWay) {
    // Queries walk along the line in the middle between pairs of targets.
    std::vector<Eigen::Vector3d> targets;
    for (int i = 0; i < 20; ++i) {
        targets.emplace_back(0.1 * i, 0.05, 0.0);
        targets.emplace_back(0.1 * i, -0.05, 0.0);
    }
    const NeighbourIndex index(targets);
    FollowedNeighbours neighbours(index, targets);
    Progress progress;
    for (int step = 0; step < 40; ++step) {
        const std::vector<Eigen::Vector3d> queries{{0.05 * step, 0.0, 0.0}, {0.05 * step, 0.001 * step, 0.0}};
        expectSame(neighbours.nearestOf(queries, progress), index.nearestOfEach(queries, progress));
    }
}

TEST(FollowedNeighbours, ASingleTargetIsAlwaysTheNearest) {
    const std::vector<Eigen::Vector3d> targets{{1.0, 2.0, 3.0}};
    const NeighbourIndex index(targets);
    FollowedNeighbours neighbours(index, targets);
    Progress progress;
    for (const double x : {0.0, 5.0, -1e6}) {
        const std::vector<Eigen::Vector3d> queries{{x, 0.0, 0.0}};
        expectSame(neighbours.nearestOf(queries, progress), index.nearestOfEach(queries, progress));
    }
}

}  // namespace
}  // namespace fodscope
