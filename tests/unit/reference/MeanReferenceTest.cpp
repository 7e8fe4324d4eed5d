// SPDX-License-Identifier: MIT
#include "core/reference/MeanReference.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "tests/unit/cloud/ExpectError.h"
#include "tests/unit/cloud/RandomPoints.h"

namespace fodscope {
namespace {

/// A noisy 1 × 1 m plate.
PointCloud plate(std::uint64_t seed) {
    PointCloud cloud;
    cloud.points = randomPoints(1500, seed);
    for (Eigen::Vector3d& point : cloud.points)
        point.z() = 0.01 * (point.z() - 0.5);
    return cloud;
}

MeanReferenceSettings settings(double quantile, int neighbours) {
    MeanReferenceSettings result;
    result.denoise.enabled = false;
    result.voxelSize_m = 0.1;
    result.occupancyQuantile = quantile;
    result.covariance.smoothing.neighbours = neighbours;
    return result;
}

std::uint32_t nearestByBruteForce(const ReferenceMap& reference, const Eigen::Vector3d& point) {
    const auto nearer = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        return (a - point).squaredNorm() < (b - point).squaredNorm();
    };
    const auto found = std::min_element(reference.points.begin(), reference.points.end(), nearer);
    return static_cast<std::uint32_t>(found - reference.points.begin());
}

TEST(MeanReference, FollowsThePaper) {
    const PointCloud first = plate(71);
    const PointCloud second = plate(72);
    Transform moved = Transform::Identity();
    moved.linear() = Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    moved.translation() = Eigen::Vector3d(0.1, -0.2, 0.3);
    const std::vector<AlignedNominalMap> maps{{&first, Transform::Identity()}, {&second, moved}};
    Progress progress;
    const ReferenceMap reference = meanReference(maps, settings(0.25, 9), progress);

    std::vector<Eigen::Vector3d> samples = first.points;
    for (const Eigen::Vector3d& point : second.points)
        samples.push_back(moved * point);
    Eigen::Vector3d origin = samples.front();
    for (const Eigen::Vector3d& sample : samples)
        origin = origin.cwiseMin(sample);
    origin.array() -= 0.05;
    std::map<std::array<int, 3>, std::pair<Eigen::Vector3d, int>> voxels;
    for (const Eigen::Vector3d& sample : samples) {
        std::array<int, 3> cell{};
        for (int axis = 0; axis < 3; ++axis)
            cell[static_cast<std::size_t>(axis)] = static_cast<int>(std::floor((sample[axis] - origin[axis]) / 0.1));
        auto& [sum, count] = voxels.try_emplace(cell, Eigen::Vector3d::Zero(), 0).first->second;
        sum += sample;
        ++count;
    }
    std::vector<int> counts;
    for (const auto& [cell, voxel] : voxels)
        counts.push_back(voxel.second);
    std::sort(counts.begin(), counts.end());
    const double position = 0.25 * static_cast<double>(counts.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const double least = counts[below] + (position - static_cast<double>(below)) * (counts[below + 1] - counts[below]);
    std::size_t i = 0;
    for (const auto& [cell, voxel] : voxels) {
        if (voxel.second < least) continue;
        ASSERT_LT(i, reference.size());
        EXPECT_NEAR((reference.points[i] - voxel.first / voxel.second).norm(), 0.0, 1e-12);
        EXPECT_EQ(reference.occupancy[i], voxel.second);
        ++i;
    }
    EXPECT_EQ(i, reference.size());
    EXPECT_LT(reference.size(), voxels.size());

    std::vector<Eigen::Matrix3d> scatter(reference.size(), Eigen::Matrix3d::Zero());
    std::vector<std::int32_t> sampleCount(reference.size());
    for (const Eigen::Vector3d& sample : samples) {
        const std::uint32_t nearest = nearestByBruteForce(reference, sample);
        const Eigen::Vector3d deviation = sample - reference.points[nearest];
        scatter[nearest] += deviation * deviation.transpose();
        ++sampleCount[nearest];
    }
    EXPECT_EQ(reference.sampleCount, sampleCount);
    for (std::size_t point = 0; point < reference.size(); ++point) {
        EXPECT_TRUE(reference.scatter[point].isApprox(scatter[point], 1e-12));
        std::vector<std::size_t> order(reference.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return (reference.points[a] - reference.points[point]).squaredNorm() <
                   (reference.points[b] - reference.points[point]).squaredNorm();
        });
        Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
        int count = 0;
        for (std::size_t j = 0; j < 9; ++j) {
            sum += scatter[order[j]];
            count += sampleCount[order[j]];
        }
        EXPECT_TRUE(reference.covariance[point].isApprox(sum / count, 1e-9));
        EXPECT_EQ(reference.untrained[point], 0);
    }
}

TEST(MeanReference, DenoisesEveryMap) {
    PointCloud map = plate(73);
    map.points.emplace_back(0.5, 0.5, 4.0);
    const std::vector<AlignedNominalMap> maps{{&map, Transform::Identity()}};
    Progress progress;
    MeanReferenceSettings noisy = settings(0.0, 9);
    const auto highest = [](const ReferenceMap& reference) {
        double z = 0.0;
        for (const Eigen::Vector3d& point : reference.points)
            z = std::max(z, point.z());
        return z;
    };
    EXPECT_GT(highest(meanReference(maps, noisy, progress)), 3.9);
    noisy.denoise.enabled = true;
    EXPECT_LT(highest(meanReference(maps, noisy, progress)), 0.1);
}

TEST(MeanReference, TakesTheKeptPointsOfAMapThatIsDenoisedAlready) {
    const PointCloud map = plate(75);
    MeanReferenceSettings denoised = settings(0.0, 9);
    denoised.denoise.enabled = true;
    Progress progress;
    const std::vector<std::uint32_t> kept = keptByOutlierRemoval(map.points, denoised.denoise, progress);
    const std::vector<AlignedNominalMap> raw{{&map, Transform::Identity()}};
    const std::vector<AlignedNominalMap> known{{&map, Transform::Identity(), &kept}};
    const ReferenceMap expected = meanReference(raw, denoised, progress);
    EXPECT_EQ(meanReference(known, denoised, progress).points, expected.points);
    EXPECT_EQ(std::accumulate(expected.occupancy.begin(), expected.occupancy.end(), 0),
              static_cast<std::int32_t>(kept.size()));
    EXPECT_LT(kept.size(), map.size());
}

TEST(MeanReference, RefusesNoMapsAndSettingsOutOfRange) {
    const PointCloud map = plate(74);
    const PointCloud empty;
    const std::vector<AlignedNominalMap> maps{{&map, Transform::Identity()}};
    const std::vector<AlignedNominalMap> nothing{{&empty, Transform::Identity()}};
    Progress progress;
    expectError([&] { meanReference({}, {}, progress); }, "no nominal maps");
    expectError([&] { meanReference(nothing, {}, progress); }, "no points after denoising");
    expectError([&] { meanReference(maps, settings(1.1, 9), progress); }, "quantile");
    expectError([&] { meanReference(maps, settings(-0.1, 9), progress); }, "quantile");
    expectError([&] { meanReference(maps, settings(0.25, 0), progress); },
                "covariance settings: the neighbours must be at least 1");
    MeanReferenceSettings bad = settings(0.25, 9);
    bad.voxelSize_m = 0.0;
    expectError([&] { meanReference(maps, bad, progress); }, "reference voxel");
    PointCloud broken = map;
    broken.points[3].y() = std::nan("");
    const std::vector<AlignedNominalMap> unusable{{&broken, Transform::Identity()}};
    expectError([&] { meanReference(unusable, settings(0.25, 9), progress); }, "not finite");
    progress.cancel();
    EXPECT_THROW(meanReference(maps, settings(0.25, 9), progress), Cancelled);
}

}  // namespace
}  // namespace fodscope
