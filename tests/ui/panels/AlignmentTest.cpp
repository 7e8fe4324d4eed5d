// SPDX-License-Identifier: MIT
// What the step of the map offers when an alignment is not the only one.
#include <gtest/gtest.h>

#include <QListWidget>
#include <QPushButton>
#include <QTemporaryDir>

#include "core/registration/Registration.h"
#include "ui/panels/PoseList.h"
#include "ui/panels/StartPoseDialog.h"
#include "ui/session/InspectionController.h"

namespace fodscope::test {
namespace {

RegistrationResult twoPoses() {
    RegistrationResult result;
    result.quality = RegistrationQuality::Ambiguous;
    result.T_reference_from_map = transformFromPose({1.0, 2.0, 0.0});
    result.overlap = 0.94;
    result.rms_m = 0.008;
    PoseAlternative other;
    other.T_reference_from_map = transformFromPose({3.0, 2.0, 3.0});
    other.overlap = 0.93;
    other.rms_m = 0.009;
    result.alternatives = {other};
    return result;
}

TEST(PoseChoices, AreTheBestPoseAndItsAlternatives) {
    const auto choices = poseChoices(twoPoses());
    ASSERT_EQ(choices.size(), 2u);
    EXPECT_DOUBLE_EQ(choices[0].overlap, 0.94);
    EXPECT_DOUBLE_EQ(poseFromTransform(choices[1].T_reference_from_map).x_m, 3.0);
    EXPECT_TRUE(poseChoices(RegistrationResult{}).empty());
}

TEST(PoseList, ClickShowsTheMapThereAndAButtonSettlesForIt) {
    QTemporaryDir folder;
    InspectionController controller;
    controller.createSession(folder.filePath("inspection.fodscope"), newInspectionHeader());
    PoseList poses(controller);
    poses.setChoices(poseChoices(twoPoses()));
    auto* list = poses.findChild<QListWidget*>(QStringLiteral("map.poses.list"));
    auto* use = poses.findChild<QPushButton*>(QStringLiteral("map.poses.use"));
    EXPECT_FALSE(use->isEnabled());
    EXPECT_FALSE(controller.previewedPose());
    list->setCurrentRow(1);
    ASSERT_TRUE(controller.previewedPose());
    EXPECT_DOUBLE_EQ(poseFromTransform(*controller.previewedPose()).x_m, 3.0);
    EXPECT_FALSE(controller.hasStartPose());
    use->click();
    EXPECT_TRUE(controller.hasStartPose());
    EXPECT_FALSE(controller.previewedPose());
    controller.alignBySearch();
    EXPECT_FALSE(controller.hasStartPose());
}

TEST(StartPose, IsTypedInMetresAndDegrees) {
    const auto pose = typedPose(" 1,5 ", "-2", "270");
    ASSERT_TRUE(pose);
    EXPECT_DOUBLE_EQ(pose->x_m, 1.5);
    EXPECT_DOUBLE_EQ(pose->y_m, -2.0);
    EXPECT_NEAR(pose->yaw_rad, radiansFromDegrees(-90.0), 1e-12);
    EXPECT_FALSE(typedPose("1", "", "0"));
    EXPECT_FALSE(typedPose("1", "nan", "0"));
}

}  // namespace
}  // namespace fodscope::test
