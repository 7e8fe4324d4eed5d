// SPDX-License-Identifier: MIT
#include "core/inspection/Parameters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/common/Error.h"
#include "core/inspection/ParameterTable.h"

namespace fodscope {
namespace {

using ::testing::HasSubstr;

Parameters paper() {
    return presetParameters("paper-physical");
}

Parameters parsed(const std::string& yaml) {
    return parseParameters(yaml, "test.yaml", paper());
}

std::string problemWith(const std::string& yaml) {
    try {
        parsed(yaml);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

/// Another allowed value for a field.
ParameterValue otherValue(const ParameterField& field, const Parameters& parameters) {
    const ParameterValue now = field.get(parameters);
    switch (field.kind) {
        case ParameterKind::Switch:
            return !std::get<bool>(now);
        case ParameterKind::Whole:
            return std::get<int>(now) + 1;
        case ParameterKind::Choice:
            return field.choices[std::get<std::string>(now) == field.choices[0] ? 1 : 0];
        case ParameterKind::OptionalNumber:
            return 0.6;
        case ParameterKind::Number:
            break;
    }
    const double number = std::get<double>(now);
    return number * 1.01 <= field.maximum ? number * 1.01 + 0.001 : number * 0.99;
}

TEST(Parameters, ThePresetHoldsThePapersValues) {
    const Parameters parameters = paper();
    EXPECT_EQ(parameters.candidates.metric, Metric::Mahalanobis);
    EXPECT_EQ(parameters.candidates.threshold, 2.75);
    EXPECT_EQ(parameters.candidates.clusterCutoff_m, 0.345);
    EXPECT_EQ(parameters.candidates.minimumPoints, 0);
    EXPECT_EQ(parameters.discrepancy.voxelSize_m, 0.02);
    EXPECT_EQ(parameters.denoise.neighbours, 50);
    EXPECT_EQ(parameters.waypoints.costThresholdPercent, 85.0);
    EXPECT_TRUE(parameterProblems(parameters).empty());
}

TEST(Parameters, ThePresetOfTheSimulatedTrialsSmoothsInABallWithGaussianWeights) {
    const Parameters parameters = presetParameters("paper-simulation");
    EXPECT_FALSE(parameters.denoise.enabled);
    EXPECT_EQ(parameters.candidates.metric, Metric::Mahalanobis);
    EXPECT_EQ(parameters.candidates.threshold, 1.75);
    EXPECT_EQ(parameters.candidates.clusterCutoff_m, 0.275);
    EXPECT_EQ(parameters.discrepancy.downSampling, DownSampling::Random);
    EXPECT_EQ(parameters.discrepancy.randomRatio, 0.1);
    for (const SmoothingSettings& smoothing :
         {parameters.discrepancy.smoothing, parameters.reference.covariance.smoothing}) {
        EXPECT_EQ(smoothing.neighbourhood, SmoothingNeighbourhood::Ball);
        EXPECT_EQ(smoothing.weights, SmoothingWeights::Gaussian);
        EXPECT_EQ(smoothing.sigma_m, 0.05);
        EXPECT_DOUBLE_EQ(smoothing.radius_m, 4.0 * smoothing.sigma_m);
    }
    EXPECT_TRUE(parameterProblems(parameters).empty());
    EXPECT_EQ(parseParameters(parametersYaml(parameters), "test.yaml", paper()), parameters);
}

TEST(Parameters, ThePapersSmoothingIsTheMeanOverTheNearest) {
    EXPECT_EQ(paper().discrepancy.smoothing.neighbours, 50);
    EXPECT_EQ(paper().discrepancy.smoothingPasses, 1);
    EXPECT_EQ(meanReferenceSettings(paper()), MeanReferenceSettings());
    EXPECT_EQ(meanReferenceSettings(paper()).covariance.smoothing.neighbours, 250);
    EXPECT_EQ(meanReferenceSettings(paper()).covariance.smoothing.weights, SmoothingWeights::Mean);
}

TEST(Parameters, AFileOfBeforeTheOtherFormsOfSmoothingStillMeansTheSame) {
    EXPECT_EQ(parsed("discrepancy: {smoothing_neighbours: 20}").discrepancy.smoothing.neighbours, 20);
}

TEST(Parameters, AnUnknownPresetNamesTheKnownOnes) {
    try {
        presetParameters("papper");
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("paper-physical"));
    }
}

TEST(Parameters, WhatIsWrittenIsReadBackEqual) {
    EXPECT_EQ(parsed(parametersYaml(paper())), paper());
}

TEST(Parameters, EveryFieldSurvivesTheFile) {
    for (const ParameterField& field : parameterTable()) {
        Parameters changed = paper();
        field.set(changed, otherValue(field, changed));
        EXPECT_NE(changed, paper()) << field.section << "." << field.key;
        const Parameters back = parsed(parametersYaml(changed));
        EXPECT_EQ(toString(field.get(back)), toString(field.get(changed))) << field.section << "." << field.key;
        EXPECT_EQ(parametersYaml(back), parametersYaml(changed)) << field.section << "." << field.key;
    }
}

TEST(Parameters, NoKeyIsThereTwiceAndEachSaysWhatItDoes) {
    std::set<std::string> keys;
    for (const ParameterField& field : parameterTable()) {
        EXPECT_TRUE(keys.insert(field.section + "." + field.key).second) << field.key;
        EXPECT_FALSE(field.help.empty()) << field.key;
    }
}

std::size_t keysIn(const std::string& section) {
    return static_cast<std::size_t>(
        std::ranges::count(parameterTable(), section, [](const ParameterField& field) { return field.section; }));
}

// When this does not compile, a setting was added: give it a row in the table, so that files and reports know it.
TEST(Parameters, TheTableKnowsEveryField) {
    const Parameters all = paper();
    const auto& [reference, denoise, registration, discrepancy, chiSquare, candidates, coverage, occupancy, costMap,
                 camera, waypoints, visits] = all;
    {
        [[maybe_unused]] const auto& [a, b, c, covariance] = reference;
        [[maybe_unused]] const auto& [smoothing, d, e] = covariance;
        [[maybe_unused]] const auto& [f, g, h, i, j] = smoothing;
        EXPECT_EQ(keysIn("reference"), 3U + 2U + 5U);
    }
    {
        [[maybe_unused]] const auto& [a, b, c] = denoise;
        EXPECT_EQ(keysIn("denoise"), 3U);
    }
    {
        [[maybe_unused]] const auto& [a, b, c, d, e, f, g, h, i] = registration;
        EXPECT_EQ(keysIn("registration"), 9U);
    }
    {
        [[maybe_unused]] const auto& [a, b, c, d, e, f, smoothing, g] = discrepancy;
        [[maybe_unused]] const auto& [h, i, j, k, l] = smoothing;
        EXPECT_EQ(keysIn("discrepancy"), 7U + 5U);
    }
    {
        [[maybe_unused]] const auto& [a, b, c] = chiSquare;
        EXPECT_EQ(keysIn("chi_square"), 3U);
    }
    {
        [[maybe_unused]] const auto& [a, b, c, d, e, f] = candidates;
        EXPECT_EQ(keysIn("candidates"), 6U);
    }
    {
        [[maybe_unused]] const auto& [a] = coverage;
        EXPECT_EQ(keysIn("coverage"), 1U);
    }
    {
        [[maybe_unused]] const auto& [a, b, c, d, e] = occupancy;
        EXPECT_EQ(keysIn("occupancy"), 5U);
    }
    {
        [[maybe_unused]] const auto& [a, b, c] = costMap;
        EXPECT_EQ(keysIn("cost_map"), 3U);
    }
    {
        [[maybe_unused]] const auto& [a, b, c, d, e, f] = camera;
        EXPECT_EQ(keysIn("camera"), 6U);
    }
    {
        [[maybe_unused]] const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = waypoints;
        EXPECT_EQ(keysIn("waypoints"), 13U);
    }
    {
        [[maybe_unused]] const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p] = visits;
        EXPECT_EQ(keysIn("visits"), 16U);
    }
}

TEST(Parameters, AnglesAreDegreesInFiles) {
    EXPECT_THAT(parametersYaml(paper()), HasSubstr("angle_step_deg: 5 "));
    EXPECT_DOUBLE_EQ(parsed("waypoints: {angle_step_deg: 10}").waypoints.angleStep_rad, radiansFromDegrees(10.0));
}

TEST(Parameters, AFileChangesOnlyWhatItNames) {
    Parameters expected = paper();
    expected.candidates.threshold = 3.5;
    expected.discrepancy.cropHeight_m = 0.6;
    EXPECT_EQ(parsed("candidates:\n  threshold: 3.5\ndiscrepancy:\n  crop_height_m: 0.6\n"), expected);
    EXPECT_EQ(parsed(""), paper());
    EXPECT_EQ(parsed("# nothing\n"), paper());
    EXPECT_EQ(parsed("denoise:\n"), paper());
}

TEST(Parameters, AnotherMetricBringsItsUsualValuesAndTheFilesOwnGoOverThem) {
    const Parameters euclidean = parsed("candidates: {threshold: 0.05, metric: euclidean}");
    EXPECT_EQ(euclidean.candidates.metric, Metric::Euclidean);
    EXPECT_EQ(euclidean.candidates.threshold, 0.05);
    EXPECT_EQ(euclidean.candidates.clusterCutoff_m, 0.279);
    EXPECT_EQ(euclidean.candidates.minimumPoints, 4);
}

TEST(Parameters, TheLinkageIsCentroidUnlessChosenAndOutlivesAnotherMetric) {
    EXPECT_EQ(paper().candidates.linkage, Linkage::Centroid);
    const Parameters single = parsed("candidates: {linkage: single, metric: euclidean}");
    EXPECT_EQ(single.candidates.linkage, Linkage::Single);
    EXPECT_EQ(parseParameters("candidates: {metric: mahalanobis}", "test.yaml", single).candidates.linkage,
              Linkage::Single);
    EXPECT_THAT(problemWith("candidates: {linkage: complete}"), HasSubstr("centroid or single"));
}

TEST(Parameters, TheChiSquareThresholdComesFromThePValueAndTheNeighbours) {
    // Roots of scipy's chi2.isf(p, ceil(sqrt(k)) - 1).
    EXPECT_NEAR(parsed("candidates: {metric: chi-square}").candidates.threshold, 4.21070020649, 1e-9);
    const std::string test = "chi_square: {neighbours: 50, p_value: 0.01}\n";
    const Parameters other = parsed("candidates: {metric: chi-square}\n" + test);
    EXPECT_EQ(other, parsed(test + "candidates: {metric: chi-square}\n"));
    EXPECT_NEAR(other.candidates.threshold, 4.29829116122, 1e-9);
    EXPECT_NEAR(usualCandidateSettings(Metric::ChiSquare, other).threshold, 4.29829116122, 1e-9);
    EXPECT_EQ(parsed("candidates: {metric: chi-square, threshold: 7}\n" + test).candidates.threshold, 7.0);
    EXPECT_EQ(parsed(test).candidates, paper().candidates);
}

TEST(Parameters, AnUnknownKeyNamesTheNearestKnownOne) {
    EXPECT_THAT(problemWith("candidates:\n  treshold: 3\n"),
                HasSubstr("line 2: unknown key 'candidates.treshold' (nearest known: 'candidates.threshold')"));
    EXPECT_THAT(problemWith("candidate:\n  threshold: 3\n"), HasSubstr("nearest known: 'candidates'"));
    EXPECT_THAT(problemWith("denoise:\n  threshold: 3\n"), HasSubstr("nearest known: 'candidates.threshold'"));
}

TEST(Parameters, AllProblemsAreListedAtOnce) {
    const std::string problem =
        problemWith("denoise:\n  neighbours: many\n  enabled: maybe\ncandidates:\n  threshold: -1\n  metric: l3\n");
    EXPECT_THAT(problem, HasSubstr("denoise.neighbours"));
    EXPECT_THAT(problem, HasSubstr("denoise.enabled"));
    EXPECT_THAT(problem, HasSubstr("candidates.threshold"));
    EXPECT_THAT(problem, HasSubstr("euclidean or mahalanobis or chi-square"));
}

TEST(Parameters, ValuesThatAreNoneAreRefused) {
    for (const char* yaml :
         {"denoise: {neighbours: 2.5}", "candidates: {threshold: nan}", "candidates: {threshold: inf}",
          "candidates: {threshold: }", "candidates: {threshold: [1]}", "candidates: {minimum_points: 99999999999}",
          "candidates: 3", "- 1", "candidates: {threshold: 1, threshold: 2}", "candidates: {threshold: 3 m}",
          "occupancy: {obstacle_minimum_height_m: 0.5, obstacle_maximum_height_m: 0.4}", "a: [", "\t- x: y\n  - ["}) {
        EXPECT_THAT(problemWith(yaml), HasSubstr("test.yaml: ")) << yaml;
    }
}

TEST(Parameters, AMissingFileIsAnError) {
    EXPECT_THROW(readParameters("/nonexistent/p.yaml", paper()), Error);
}

}  // namespace
}  // namespace fodscope
