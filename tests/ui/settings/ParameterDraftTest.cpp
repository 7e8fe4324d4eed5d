// SPDX-License-Identifier: MIT
#include "ui/settings/ParameterDraft.h"

#include <gtest/gtest.h>

#include "ui/session/ParameterUse.h"
#include "ui/settings/ParameterWords.h"

namespace fodscope::test {
namespace {

const ParameterField& field(const char* section, const char* key) {
    const ParameterField* found = findParameter(section, key);
    EXPECT_NE(found, nullptr) << section << '.' << key;
    return *found;
}

Parameters preset() {
    return presetParameters("paper-physical");
}

TEST(ParameterDraft, TakesWhatWasTypedInEitherDecimalMark) {
    ParameterDraft draft(preset(), preset());
    EXPECT_FALSE(draft.hasChanges());
    draft.setText(field("discrepancy", "voxel_size_m"), "0,03");
    EXPECT_DOUBLE_EQ(draft.edited().discrepancy.voxelSize_m, 0.03);
    EXPECT_EQ(draft.text(field("discrepancy", "voxel_size_m")), "0.03");
    EXPECT_TRUE(draft.differsFromPreset(field("discrepancy", "voxel_size_m")));
    EXPECT_EQ(draft.presetText(field("discrepancy", "voxel_size_m")), "0.02");
    EXPECT_TRUE(draft.obstacle().isEmpty());
}

TEST(ParameterDraft, TellsAllProblemsAtOnceAndCannotBeAppliedWithThem) {
    ParameterDraft draft(preset(), preset());
    draft.setText(field("discrepancy", "voxel_size_m"), "0");
    draft.setText(field("denoise", "neighbours"), "2.5");
    draft.setText(field("waypoints", "minimum_distance_m"), "3");
    draft.setText(field("coverage", "observed_within_m"), "far");
    const QString all = draft.problems().join('\n');
    for (const char* name : {"discrepancy.voxel_size_m", "denoise.neighbours", "waypoints.minimum_distance_m",
                             "coverage.observed_within_m"})
        EXPECT_TRUE(all.contains(name)) << name << " in " << qPrintable(all);
    EXPECT_FALSE(draft.obstacle().isEmpty());
    EXPECT_EQ(draft.text(field("coverage", "observed_within_m")), "far");
    draft.usePreset();
    EXPECT_TRUE(draft.problems().isEmpty());
    EXPECT_FALSE(draft.hasChanges());
}

TEST(ParameterDraft, ResetsOneParameterAndLeavesTheOthers) {
    ParameterDraft draft(preset(), preset());
    draft.setText(field("denoise", "neighbours"), "20");
    draft.setText(field("denoise", "enabled"), "false");
    draft.reset(field("denoise", "neighbours"));
    EXPECT_EQ(draft.edited().denoise.neighbours, preset().denoise.neighbours);
    EXPECT_FALSE(draft.edited().denoise.enabled);
}

TEST(ParameterDraft, AnotherMetricBringsItsOwnUsualValuesAndIsComparedWithThem) {
    ParameterDraft draft(preset(), preset());
    draft.setText(field("candidates", "metric"), "euclidean");
    EXPECT_EQ(draft.edited().candidates.threshold, paperPhysicalCandidateSettings(Metric::Euclidean).threshold);
    EXPECT_TRUE(draft.differsFromPreset(field("candidates", "metric")));
    EXPECT_FALSE(draft.differsFromPreset(field("candidates", "threshold")));
    EXPECT_EQ(parameterUnit(field("candidates", "threshold"), draft.edited()), "m");
    EXPECT_EQ(parameterUnit(field("candidates", "threshold"), preset()), "");
}

TEST(ParameterDraft, OptionalNumberMayBeEmptied) {
    ParameterDraft draft(preset(), preset());
    draft.setText(field("discrepancy", "crop_height_m"), "1.5");
    EXPECT_EQ(draft.edited().discrepancy.cropHeight_m, 1.5);
    draft.setText(field("discrepancy", "crop_height_m"), "");
    EXPECT_FALSE(draft.edited().discrepancy.cropHeight_m.has_value());
    EXPECT_TRUE(draft.problems().isEmpty());
}

TEST(ParameterDraft, OnlyTheVisitsCanBeSteeredOnceTheyHaveBegun) {
    ParameterDraft draft(preset(), preset());
    draft.setText(field("denoise", "neighbours"), "20");
    draft.setFrozen(true);
    EXPECT_FALSE(draft.hasChanges());
    draft.setText(field("candidates", "threshold"), "4");
    draft.setText(field("visits", "drive_timeout_s"), "77");
    Parameters other = preset();
    other.denoise.neighbours = 9;
    other.visits.driveTimeout_s = 77;
    draft.setEdited(other);
    EXPECT_EQ(draft.edited().candidates, preset().candidates);
    EXPECT_EQ(draft.edited().denoise, preset().denoise);
    EXPECT_EQ(draft.edited().visits.driveTimeout_s, 77);
}

TEST(ParameterDraft, EveryParameterKeepsItsValueThroughItsText) {
    const ParameterDraft before(preset(), preset());
    ParameterDraft draft(preset(), preset());
    for (const ParameterField& each : parameterTable())
        draft.setText(each, before.text(each));
    EXPECT_EQ(draft.edited(), preset());
    EXPECT_TRUE(draft.problems().isEmpty());
}

TEST(ParameterWords, NamesHaveNoUnitsAndSearchFindsByMeaning) {
    EXPECT_EQ(parameterName(field("registration", "map_voxel_size_m")), "Map voxel size");
    EXPECT_EQ(sectionTitle("cost_map"), "Cost map");
    EXPECT_TRUE(matchesSearch(field("cost_map", "inflation_radius_m"), "obstacles nothing"));
    EXPECT_TRUE(matchesSearch(field("cost_map", "inflation_radius_m"), " "));
    EXPECT_FALSE(matchesSearch(field("cost_map", "inflation_radius_m"), "obstacles unicorn"));
    for (const ParameterField& each : parameterTable()) {
        EXPECT_FALSE(parameterName(each).isEmpty());
        EXPECT_FALSE(parameterHelp(each).isEmpty());
    }
}

TEST(ParameterUse, SaysWhatHasToBeMadeAnew) {
    Parameters other = preset();
    other.visits.driveTimeout_s += 1;
    EXPECT_TRUE(sameFor(ParameterUse::Detection, preset(), other));
    EXPECT_FALSE(sameFor(ParameterUse::Visits, preset(), other));
    other.denoise.enabled = false;
    EXPECT_FALSE(sameFor(ParameterUse::Detection, preset(), other));
    EXPECT_TRUE(sameFor(ParameterUse::Plan, preset(), other));
}

TEST(DetectionPreset, IsNamedWhateverTheMetricAndLeavesTheRestAlone) {
    for (const std::string& name : presetNames()) {
        Parameters parameters = preset();
        parameters.visits.driveTimeout_s += 1;
        const Parameters trained = withDetectionPreset(parameters, name, true);
        EXPECT_EQ(detectionPresetOf(trained), name);
        EXPECT_EQ(trained.visits, parameters.visits);
        const Parameters plain = withDetectionPreset(parameters, name, false);
        EXPECT_EQ(plain.candidates.metric, Metric::Euclidean);
        EXPECT_EQ(detectionPresetOf(plain), name);
    }
    Parameters own = preset();
    own.discrepancy.voxelSize_m = 0.033;
    EXPECT_EQ(detectionPresetOf(own), "");
}

TEST(NearestPreset, IsTheOneThatTheRecordWasMadeFrom) {
    for (const std::string& name : presetNames()) {
        Parameters parameters = presetParameters(name);
        parameters.visits.driveTimeout_s += 1;
        EXPECT_EQ(nearestPreset(parameters), name);
    }
}

}  // namespace
}  // namespace fodscope::test
