// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <QTemporaryDir>

#include "core/inspection/ParameterTable.h"
#include "ui/panels/CovarianceCard.h"
#include "ui/session/InspectionController.h"
#include "ui/session/ReferenceSources.h"
#include "ui/settings/ParameterEditor.h"
#include "ui/settings/ParameterForm.h"

namespace fodscope::test {
namespace {

TEST(CovarianceCard, NamesThePresetWhoseValuesAreSet) {
    for (const std::string& name : presetNames())
        EXPECT_EQ(referencePresetOf(presetParameters(name)), name);
    Parameters own = presetParameters(presetNames().front());
    own.reference.covariance.smoothing.neighbours += 1;
    EXPECT_EQ(referencePresetOf(own), "");
}

TEST(ParameterForm, ShowsWhatMattersAndKeepsWhatIsEntered) {
    QTemporaryDir folder;
    InspectionController controller;
    controller.createSession(folder.filePath("inspection.fodscope"), newInspectionHeader());
    const auto matters = [](const ParameterField& field, const Parameters& parameters) {
        return field.key != "covariance_radius_m" ||
               parameters.reference.covariance.smoothing.neighbourhood == SmoothingNeighbourhood::Ball;
    };
    ParameterForm form(controller, kReferenceSection, {"covariance_neighbourhood", "covariance_radius_m"}, matters);
    form.show();
    const auto editor = [&](const char* name) { return form.findChild<ParameterEditor*>(QString::fromLatin1(name)); };
    auto* neighbourhood = editor("parameter.reference.covariance_neighbourhood");
    auto* radius = editor("parameter.reference.covariance_radius_m");
    ASSERT_TRUE(neighbourhood && radius);
    EXPECT_TRUE(radius->isHidden());
    emit neighbourhood->committed("ball");
    EXPECT_FALSE(radius->isHidden());
    emit radius->committed("0.15");
    EXPECT_EQ(controller.state().parameters.reference.covariance.smoothing.radius_m, 0.15);
    emit radius->committed("-3");
    EXPECT_EQ(controller.state().parameters.reference.covariance.smoothing.radius_m, 0.15);
    controller.undo();
    controller.undo();
    EXPECT_TRUE(radius->isHidden());
}

}  // namespace
}  // namespace fodscope::test
