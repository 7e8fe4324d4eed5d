// SPDX-License-Identifier: MIT
#include "core/inspection/GroundTruthLabeller.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/simulation/PhotoCamera.h"
#include "tests/unit/simulation/SmallWorlds.h"

namespace fodscope {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const LabelSet& tools() {
    static const LabelSet set =
        parseLabelSet("{name: tools, labels: [{name: hammer}, {name: tape measure}, {name: other FOD}]}", "test");
    return set;
}

WorldObject tool(const std::string& type, const Eigen::Vector3d& place, double size_m = 0.1) {
    const Eigen::Vector3d half(size_m / 2, size_m / 2, 0);
    WorldObject object = test::boxObject(place - half, place + half + Eigen::Vector3d(0, 0, size_m));
    object.type = type;
    return object;
}

/// A room whose map frame is turned and shifted, so that a mixed-up frame shows.
World roomWith(std::vector<WorldObject> objects) {
    World world = test::room();
    world.objects = std::move(objects);
    world.T_map_from_world = transformFromPose({5.0, -2.0, 1.0});
    return world;
}

/// What the labeller says to a photo taken from the middle of the room's left end, looking along it.
PhotoAnswer answerIn(const World& world, const LabelSet& labels) {
    const PhotoCameraSettings camera;
    Photo photo;
    photo.intrinsics = intrinsicsOf(camera);
    photo.T_map_from_camera = world.T_map_from_world * cameraPose({0.3, 1.0, 0.0}, camera);
    return GroundTruthLabeller(std::make_shared<World>(world), true).answer(photo, labels);
}

std::vector<std::string> labelsOf(const PhotoAnswer& answer) {
    std::vector<std::string> names;
    for (const PhotoLabel& label : answer.labels)
        names.push_back(label.label);
    return names;
}

TEST(GroundTruthLabeller, NamesEveryFodInThePhotoInTheWordsOfTheLabelSet) {
    const World world = roomWith({tool("hammer", {1.2, 1.1, 0}), tool("tape_measure", {1.2, 0.8, 0})});
    EXPECT_THAT(labelsOf(answerIn(world, tools())), ElementsAre("hammer", "tape measure"));
}

TEST(GroundTruthLabeller, WhatIsNoFodOrHiddenOrTooSmallDoesNotCount) {
    WorldObject cover = tool("hammer", {1.2, 1.0, 0}, 0.4);
    cover.fod = false;
    EXPECT_THAT(labelsOf(answerIn(roomWith({cover}), tools())), ElementsAre(kNoFod));
    const World hidden = roomWith({tool("hammer", {2.0, 1.0, 0}, 0.05), cover});
    EXPECT_THAT(labelsOf(answerIn(hidden, tools())), ElementsAre(kNoFod));
    EXPECT_THAT(labelsOf(answerIn(roomWith({tool("hammer", {2.8, 1.0, 0}, 0.01)}), tools())), ElementsAre(kNoFod));
    EXPECT_THAT(labelsOf(answerIn(roomWith({}), tools())), ElementsAre(kNoFod));
}

TEST(GroundTruthLabeller, ATypeThatTheSetLacksIsOtherFodOrNotSureAndTheCommentNamesIt) {
    const World world = roomWith({tool("sock", {1.2, 1.0, 0})});
    const PhotoAnswer other = answerIn(world, tools());
    EXPECT_THAT(labelsOf(other), ElementsAre("other FOD"));
    EXPECT_THAT(other.comment, HasSubstr("sock"));
    const LabelSet few = parseLabelSet("{name: few, labels: [{name: hammer}]}", "test");
    const PhotoAnswer unsure = answerIn(world, few);
    EXPECT_THAT(labelsOf(unsure), ElementsAre(kNotSure));
    EXPECT_THAT(unsure.comment, HasSubstr("sock"));
    EXPECT_THAT(answerIn(roomWith({}), few).comment, IsEmpty());
}

TEST(GroundTruthLabeller, IsCalledWhatItIs) {
    const auto world = std::make_shared<World>(roomWith({}));
    EXPECT_EQ(GroundTruthLabeller(world, true).name(), "built-in world's ground truth");
    EXPECT_EQ(GroundTruthLabeller(world, false).name(), "world's ground truth");
}

}  // namespace
}  // namespace fodscope
