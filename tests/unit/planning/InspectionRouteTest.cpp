// SPDX-License-Identifier: MIT
#include "core/planning/InspectionRoute.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/common/Error.h"

namespace fodscope {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

InspectionRoute sample() {
    InspectionRoute route;
    route.poses = {{"R-01", {1.25, -0.5, radiansFromDegrees(90.0)}, false},
                   {"R-02", {0.0, 2.0, radiansFromDegrees(-135.5)}, true}};
    route.highestNumber = 2;
    return route;
}

std::string problemOf(const std::string& yaml) {
    try {
        parseRoute(yaml, "route.yaml");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(InspectionRoute, YamlIsMetresAndDegreesInTheOrderOfTheDrive) {
    EXPECT_THAT(routeYaml(sample()), HasSubstr("schema: fodscope.route/1\nframe: map\nposes:\n"
                                               "  - {x: 1.25, y: -0.5, yaw_deg: 90, photo: false}\n"
                                               "  - {x: 0, y: 2, yaw_deg: -135.5, photo: true}\n"));
}

TEST(InspectionRoute, WhatWasSavedIsReadBack) {
    const InspectionRoute read = parseRoute(routeYaml(sample()), "route.yaml");
    ASSERT_EQ(read.poses.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(read.poses[i].pose_map.x_m, sample().poses[i].pose_map.x_m, 1e-9);
        EXPECT_NEAR(read.poses[i].pose_map.y_m, sample().poses[i].pose_map.y_m, 1e-9);
        EXPECT_NEAR(read.poses[i].pose_map.yaw_rad, sample().poses[i].pose_map.yaw_rad, 1e-9);
        EXPECT_EQ(read.poses[i].takesPhoto, sample().poses[i].takesPhoto);
        EXPECT_EQ(read.poses[i].id, "") << "ids belong to a session";
    }
    EXPECT_EQ(routeYaml(read), routeYaml(sample()));
}

TEST(InspectionRoute, PhotosAreOptionalAndAnglesAreTakenIntoTheCircle) {
    const InspectionRoute route =
        parseRoute("schema: fodscope.route/1\nframe: map\nposes: [{x: 1, y: 2, yaw_deg: 450}]", "route.yaml");
    EXPECT_FALSE(route.poses[0].takesPhoto);
    EXPECT_NEAR(route.poses[0].pose_map.yaw_rad, radiansFromDegrees(90.0), 1e-12);
}

TEST(InspectionRoute, WhatIsWrongIsToldWithFileAndLine) {
    const std::string head = "schema: fodscope.route/1\nframe: map\n";
    const std::vector<std::pair<std::string, std::string>> cases{
        {"", "line 1: holds no route"},
        {"- 1\n- 2\n", "line 1: holds no route"},
        {"schema: [\n", "line 2: this is no YAML"},
        {"frame: map\nposes: []\n", "line 1: the key 'schema' is missing"},
        {"schema: fodscope.world/1\nframe: map\nposes: []\n", "line 1: 'schema' is 'fodscope.world/1'"},
        {"schema: fodscope.route/1\nframe: odom\nposes: []\n", "line 2: 'frame' is 'odom', not 'map'"},
        {head, "the key 'poses' is missing"},
        {head + "poses: []\n", "line 3: 'poses' lists no pose"},
        {head + "poses: 7\n", "line 3: 'poses' lists no pose"},
        {head + "poses:\n  - 3\n", "line 4: this is no pose"},
        {head + "poses:\n  - {x: 1, y: 2}\n", "line 4: the key 'yaw_deg' is missing"},
        {head + "poses:\n  - {x: 1, y: 2, yaw_deg: 0}\n  - {x: 1, y: two, yaw_deg: 0}\n",
         "line 5: 'y' is 'two', which is no number"},
        {head + "poses:\n  - {x: .nan, y: 2, yaw_deg: 0}\n", "line 4: 'x' is '.nan', which is no number"},
        {head + "poses:\n  - {x: 1e9, y: 2, yaw_deg: 0}\n", "line 4: 'x' is out of range"},
        {head + "poses:\n  - {x: 1, y: 2, yaw: 0}\n", "line 4: the key 'yaw' is unknown"},
        {head + "poses:\n  - {x: 1, x: 2, y: 2, yaw_deg: 0}\n", "line 4: the key 'x' is there twice"},
        {head + "poses:\n  - {x: 1, y: 2, yaw_deg: 0, photo: maybe}\n", "line 4: 'photo' is 'maybe'"},
        {head + "poses:\n  - {x: [1], y: 2, yaw_deg: 0}\n", "line 4: 'x' is no single value"}};
    for (const auto& [yaml, problem] : cases) {
        EXPECT_THAT(problemOf(yaml), StartsWith("route.yaml")) << yaml;
        EXPECT_THAT(problemOf(yaml), HasSubstr(problem)) << yaml;
    }
}

TEST(InspectionRoute, IdsAreGivenOnceAndNeverAgain) {
    InspectionRoute route = sample();
    route.poses.erase(route.poses.begin() + 1);
    route.poses.push_back({});
    route = numbered(route);
    EXPECT_EQ(route.poses[0].id, "R-01");
    EXPECT_EQ(route.poses[1].id, "R-03") << "R-02 was there before";
    EXPECT_TRUE(isRoutePose(route.poses[1].id));
    EXPECT_FALSE(isRoutePose("W-01"));
}

TEST(InspectionRoute, IsAPlanWithoutCandidates) {
    const VisitPlan plan = planOf(sample());
    ASSERT_EQ(plan.waypoints.size(), 2U);
    EXPECT_EQ(plan.waypoints[0].id, "R-01");
    EXPECT_EQ(plan.waypoints[0].pose_map, sample().poses[0].pose_map);
    EXPECT_FALSE(plan.waypoints[0].takesPhoto);
    EXPECT_TRUE(plan.waypoints[1].takesPhoto);
    EXPECT_TRUE(plan.waypoints[1].candidateIds.empty());
}

}  // namespace
}  // namespace fodscope
