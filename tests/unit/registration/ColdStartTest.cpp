// SPDX-License-Identifier: MIT
// Registration without a start pose: maps of any yaw and place, rooms that fit in two ways, and maps that cannot be
// aligned at all.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/registration/Registration.h"
#include "tests/unit/registration/SyntheticRoom.h"

namespace fodscope {
namespace {

using test::cornerDisplacement_m;
using test::leaningMotion;
using test::mapOf;
using test::mirrorRoomPanels;
using test::motion;
using test::Panel;
using test::referenceOf;
using test::roomMap;
using test::roomReference;

using ::testing::HasSubstr;

RegistrationResult registered(const std::vector<Eigen::Vector3d>& map, const std::vector<Eigen::Vector3d>& reference,
                              const std::optional<Transform>& start = std::nullopt) {
    Progress progress;
    return registerMap(map, reference, start, {}, progress);
}

double error_m(const Transform& found, const Transform& T_map_from_room) {
    return cornerDisplacement_m(found * T_map_from_room, Transform::Identity());
}

/// A floor between two walls that go on beyond what is mapped.
std::vector<Panel> corridorPanels(double from_m, double to_m) {
    std::vector<Panel> panels = test::boxPanels({from_m, 0, 0}, {to_m, 1.5, 1.2});
    return {panels[0], panels[2], panels[3]};
}

TEST(ColdStart, AnyYawPlaceAndLeanIsFoundToACentimetre) {
    const std::vector<Eigen::Vector3d> reference = roomReference();
    for (const Transform& T_map_from_room :
         {leaningMotion(17.0, 3.0, 40.0, {-6.0, 2.0, 0.4}), leaningMotion(-101.0, 2.0, -75.0, {30.0, -8.0, -1.0}),
          leaningMotion(163.5, 3.0, 160.0, {0.0, 0.0, 2.0})}) {
        const RegistrationResult result = registered(roomMap(T_map_from_room), reference);
        EXPECT_EQ(result.quality, RegistrationQuality::Good) << result.summary;
        EXPECT_LT(error_m(result.T_reference_from_map, T_map_from_room), 0.01);
        EXPECT_TRUE(result.alternatives.empty());
        EXPECT_GT(result.explained, 0.8);
    }
}

TEST(ColdStart, APartOfTheRoomIsFoundInTheWhole) {
    const Transform T_map_from_room = motion(-60.0, {2.0, 2.0, 0.0});
    std::vector<Eigen::Vector3d> part;
    for (const Eigen::Vector3d& point : roomMap(T_map_from_room)) {
        if ((T_map_from_room.inverse() * point).x() < 2.4) part.push_back(point);
    }
    const RegistrationResult result = registered(part, roomReference());
    EXPECT_EQ(result.quality, RegistrationQuality::Good) << result.summary;
    EXPECT_LT(error_m(result.T_reference_from_map, T_map_from_room), 0.02);
}

TEST(ColdStart, ARoomThatFitsInTwoWaysIsNotDecided) {
    // With a small block only one of the two poses is true, but nearly all of the map fits either way.
    for (const bool withBlock : {false, true}) {
        const std::vector<Panel> panels = mirrorRoomPanels(withBlock);
        const std::vector<Eigen::Vector3d> reference = referenceOf(panels);
        const Transform T_map_from_room = motion(35.0, {4.0, 1.0, 0.1});
        const std::vector<Eigen::Vector3d> map = mapOf(panels, T_map_from_room);
        const RegistrationResult result = registered(map, reference);
        EXPECT_EQ(result.quality, RegistrationQuality::Ambiguous) << result.summary;
        ASSERT_EQ(result.alternatives.size(), 1U);
        EXPECT_THAT(result.summary, HasSubstr("two poses fit nearly as well: "));
        EXPECT_THAT(result.summary, HasSubstr("; choose one or give a start pose"));
        const Transform& first = result.T_reference_from_map;
        const Transform& second = result.alternatives[0].T_reference_from_map;
        const double nearest_m = std::min(error_m(first, T_map_from_room), error_m(second, T_map_from_room));
        EXPECT_LT(nearest_m, 0.01);
        if (withBlock) {
            EXPECT_LT(error_m(first, T_map_from_room), 0.01);
        }
        EXPECT_GT((first.translation() - second.translation()).norm(), 0.5);
        EXPECT_GT(result.alternatives[0].overlap, 0.9);

        // Either can be chosen, and nothing is doubted then (it is refined by some millimetres only); so can a start
        // pose that is known roughly.
        for (const Transform& chosen : {first, second}) {
            const RegistrationResult decided = registered(map, reference, chosen);
            EXPECT_EQ(decided.quality, RegistrationQuality::Good) << decided.summary;
            EXPECT_LT(cornerDisplacement_m(decided.T_reference_from_map * T_map_from_room, chosen * T_map_from_room),
                      0.010);
            ASSERT_TRUE(decided.start_T_reference_from_map.has_value());
            EXPECT_EQ(decided.start_T_reference_from_map->matrix(), chosen.matrix());
        }
        const Transform roughly = motion(4.0, {0.1, -0.1, 0.0}) * T_map_from_room.inverse();
        EXPECT_LT(error_m(registered(map, reference, roughly).T_reference_from_map, T_map_from_room), 0.01);
    }
}

TEST(ColdStart, AWrongStartPoseIsNotOverruledInSilence) {
    const Transform T_map_from_room = motion(20.0, {1.0, 0.0, 0.0});
    const Transform wrong = motion(90.0, {1.5, 0.5, 0.0}) * T_map_from_room.inverse();
    const RegistrationResult result = registered(roomMap(T_map_from_room), roomReference(), wrong);
    EXPECT_EQ(result.quality, RegistrationQuality::Ambiguous) << result.summary;
    EXPECT_THAT(result.summary, HasSubstr("does not fit at the start pose, but elsewhere"));
    EXPECT_LT(error_m(result.T_reference_from_map, T_map_from_room), 0.01);
}

TEST(ColdStart, ACorridorIsNotHeldAlongItself) {
    const std::vector<Eigen::Vector3d> reference = referenceOf(corridorPanels(0.0, 8.0));
    const std::vector<Eigen::Vector3d> map = mapOf(corridorPanels(3.0, 5.0), Transform::Identity());
    const RegistrationResult unknown = registered(map, reference);
    EXPECT_FALSE(isTrusted(unknown.quality)) << unknown.summary;

    const Transform start = motion(2.0, {0.2, 0.05, 0.0});
    const RegistrationResult started = registered(map, reference, start);
    EXPECT_EQ(started.quality, RegistrationQuality::Good) << started.summary;
    EXPECT_THAT(started.summary, HasSubstr("the map does not hold the position along x, which the start pose tells"));
    ASSERT_TRUE(started.uncertainty.has_value());
    ASSERT_EQ(started.uncertainty->looseDirections.size(), 1U);
    EXPECT_GT(std::abs(started.uncertainty->looseDirections[0].x()), 0.99);
    EXPECT_NEAR(started.T_reference_from_map.translation().y(), 0.0, 0.01);
    const double slid_m =
        (started.T_reference_from_map * Eigen::Vector3d(4.0, 0.75, 0.0) - start * Eigen::Vector3d(4.0, 0.75, 0.0)).x();
    EXPECT_LT(std::abs(slid_m), 0.05);
}

TEST(ColdStart, MapsThatCannotBeAlignedAreBad) {
    const std::vector<Panel> floor{{{0, 0, 0}, {4.0, 0, 0}, {0, 3.0, 0}}};
    const std::vector<Eigen::Vector3d> flat = mapOf(floor, Transform::Identity());
    const RegistrationResult planar = registered(flat, roomReference());
    EXPECT_EQ(planar.quality, RegistrationQuality::Bad) << planar.summary;
    EXPECT_THAT(planar.summary, HasSubstr("does not hold"));
    EXPECT_EQ(registered(roomMap(Transform::Identity()), flat).quality, RegistrationQuality::Bad);

    std::vector<Eigen::Vector3d> few = roomMap(Transform::Identity());
    few.resize(5);
    EXPECT_EQ(registered(few, roomReference()).quality, RegistrationQuality::Bad);

    // A hall with other measures: floor on floor overlaps wherever it lies.
    std::vector<Panel> hall = test::boxPanels({0, 0, 0}, {9.0, 7.0, 1.2});
    hall.erase(hall.begin() + 1);
    const RegistrationResult other = registered(mapOf(hall, motion(30.0, {1.0, 1.0, 0.0})), roomReference());
    EXPECT_EQ(other.quality, RegistrationQuality::Bad) << other.summary;
    EXPECT_TRUE(other.alternatives.empty());
}

}  // namespace
}  // namespace fodscope
