// SPDX-License-Identifier: MIT
#include "core/registration/Registration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/common/Error.h"
#include "tests/unit/registration/SyntheticRoom.h"

namespace fodscope {
namespace {

using test::cornerDisplacement_m;
using test::motion;
using test::roomMap;
using test::roomReference;
using ::testing::HasSubstr;
using ::testing::StartsWith;

RegistrationResult registered(const std::vector<Eigen::Vector3d>& map,
                              const std::optional<Transform>& start = std::nullopt) {
    Progress progress;
    return registerMap(map, roomReference(), start, {}, progress);
}

/// Points of a sphere, which fits no room.
std::vector<Eigen::Vector3d> sphere(double radius_m) {
    std::vector<Eigen::Vector3d> points;
    constexpr int kPoints = 20000;
    for (int i = 0; i < kPoints; ++i) {
        const double z = 1.0 - 2.0 * (i + 0.5) / kPoints;
        const double angle_rad = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
        const double ring = std::sqrt(1.0 - z * z);
        points.push_back(radius_m * Eigen::Vector3d(ring * std::cos(angle_rad), ring * std::sin(angle_rad), z));
    }
    return points;
}

TEST(Registration, ASmallOffsetIsRecoveredFromTheIdentity) {
    const Transform T_map_from_room = motion(2.0, {0.08, -0.05, 0.02});
    const RegistrationResult result = registered(roomMap(T_map_from_room));
    EXPECT_EQ(result.quality, RegistrationQuality::Good);
    EXPECT_EQ(result.converged, true);
    EXPECT_LT(cornerDisplacement_m(result.T_reference_from_map * T_map_from_room, Transform::Identity()), 0.01);
    EXPECT_GT(result.overlap, 0.95);
    EXPECT_THAT(result.summary, StartsWith("aligned, "));
    EXPECT_THAT(result.summary, HasSubstr(" % overlap, known to "));
}

TEST(Registration, AStartPoseLeadsToADistantMap) {
    const Transform T_map_from_room = motion(140.0, {12.0, -7.0, 0.3});
    const Transform nearly = motion(2.0, {0.05, 0.0, 0.0}) * T_map_from_room.inverse();
    const RegistrationResult result = registered(roomMap(T_map_from_room), nearly);
    EXPECT_EQ(result.quality, RegistrationQuality::Good);
    EXPECT_LT(cornerDisplacement_m(result.T_reference_from_map * T_map_from_room, Transform::Identity()), 0.01);
}

TEST(Registration, TheSearchFindsAMapThatIsTurnedAndFarAway) {
    for (const double yaw_deg : {90.0, 180.0, -135.0}) {
        const Transform T_map_from_room = motion(yaw_deg, {5.0, -3.0, 0.2});
        const RegistrationResult result = registered(roomMap(T_map_from_room));
        EXPECT_EQ(result.quality, RegistrationQuality::Good) << yaw_deg << ": " << result.summary;
        EXPECT_LT(cornerDisplacement_m(result.T_reference_from_map * T_map_from_room, Transform::Identity()), 0.015)
            << yaw_deg;
    }
}

TEST(Registration, AMapOfAnotherSpaceIsBadAndSaysSo) {
    const RegistrationResult result = registered(sphere(1.2));
    EXPECT_EQ(result.quality, RegistrationQuality::Bad);
    EXPECT_LT(result.overlap, 0.6);
    EXPECT_THAT(result.summary, StartsWith("not aligned: "));
    EXPECT_THAT(result.summary, HasSubstr("at least 60 % is needed"));
}

TEST(Registration, AMapInMillimetresIsBadAndTheUnitIsNamed) {
    std::vector<Eigen::Vector3d> map = roomMap(Transform::Identity());
    for (Eigen::Vector3d& point : map)
        point *= 1000.0;
    const RegistrationResult result = registered(map);
    EXPECT_EQ(result.quality, RegistrationQuality::Bad);
    EXPECT_THAT(result.summary, HasSubstr("in metres"));
}

TEST(Registration, ASearchCutShortIsBadEvenWhereItOverlaps) {
    RegistrationSettings settings;
    settings.maximumIterations = 1;
    Progress progress;
    const RegistrationResult result =
        registerMap(roomMap(motion(1.0, {0.03, 0.0, 0.0})), roomReference(), std::nullopt, settings, progress);
    EXPECT_EQ(result.quality, RegistrationQuality::Bad);
    EXPECT_EQ(result.converged, false);
    EXPECT_THAT(result.summary, HasSubstr("did not settle"));
}

TEST(Registration, NothingToAlignIsAnError) {
    Progress progress;
    const std::vector<Eigen::Vector3d> none;
    const std::vector<Eigen::Vector3d> one{{0, 0, 0}};
    EXPECT_THROW(registerMap(none, one, std::nullopt, {}, progress), Error);
    EXPECT_THROW(registerMap(one, none, std::nullopt, {}, progress), Error);
    EXPECT_THROW(judgeTransform(none, one, Transform::Identity(), {}, progress), Error);
}

TEST(Registration, ASinglePointIsBadNotACrash) {
    EXPECT_EQ(registered({{1.0, 1.0, 0.0}}).quality, RegistrationQuality::Bad);
}

TEST(Registration, TheThreadsDoNotChangeTheResult) {
    const std::vector<Eigen::Vector3d> map = roomMap(motion(75.0, {1.0, 2.0, 0.0}));
    const RegistrationResult parallel = registered(map);
    const tbb::global_control single(tbb::global_control::max_allowed_parallelism, 1);
    const RegistrationResult serial = registered(map);
    EXPECT_EQ(parallel.T_reference_from_map.matrix(), serial.T_reference_from_map.matrix());
    EXPECT_EQ(parallel.rms_m, serial.rms_m);
}

TEST(Registration, CancellingLeavesNoResult) {
    const std::vector<Eigen::Vector3d> map = roomMap(motion(90.0, {5.0, 0.0, 0.0}));
    // The search is stopped in each of its stages in turn.
    for (const std::string stop : {"finding", "searching", "comparing", "aligning"}) {
        Progress* running = nullptr;
        Progress progress([&](const std::string& stage, double) {
            if (stage.starts_with(stop)) running->cancel();
        });
        running = &progress;
        EXPECT_THROW(registerMap(map, roomReference(), std::nullopt, {}, progress), Cancelled) << stop;
    }
}

TEST(JudgeTransform, MeasuresWhatBruteForceMeasures) {
    // Points far enough apart that each is a voxel of its own.
    const std::vector<Eigen::Vector3d> reference{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 2, 0}};
    const std::vector<Eigen::Vector3d> map{{0.01, 0, 0}, {1, 0.03, 0}, {0, 1, 0.2}, {5, 5, 5}};
    const Transform shift = motion(0.0, {0.0, 0.01, 0.0});
    int overlapping = 0;
    double sum_m2 = 0.0;
    for (const Eigen::Vector3d& point : map) {
        double nearest_m = std::numeric_limits<double>::infinity();
        for (const Eigen::Vector3d& other : reference)
            nearest_m = std::min(nearest_m, (shift * point - other).norm());
        if (nearest_m > 0.05) continue;
        ++overlapping;
        sum_m2 += nearest_m * nearest_m;
    }
    Progress progress;
    const RegistrationResult result = judgeTransform(map, reference, shift, {}, progress);
    ASSERT_EQ(overlapping, 2);
    EXPECT_EQ(result.quality, RegistrationQuality::Given);
    EXPECT_FALSE(result.converged.has_value());
    EXPECT_DOUBLE_EQ(result.overlap, 0.5);
    EXPECT_NEAR(result.rms_m, std::sqrt(sum_m2 / overlapping), 1e-12);
    EXPECT_EQ(result.T_reference_from_map.matrix(), shift.matrix());
    EXPECT_EQ(result.summary, "transform given, 30 mm rms, 50 % overlap: check the transform");
}

}  // namespace
}  // namespace fodscope
