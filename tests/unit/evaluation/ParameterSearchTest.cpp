// SPDX-License-Identifier: MIT
#include "core/evaluation/ParameterSearch.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <string>
#include <thread>

#include "core/common/Error.h"
#include "core/evaluation/Numpy.h"
#include "tests/unit/cloud/RandomPoints.h"

namespace fodscope {
namespace {

/// Discrepancies that are high in a few clumps and somewhat elevated elsewhere; FOD in some of the clumps.
SearchTrial exampleTrial(std::uint64_t seed) {
    auto field = std::make_shared<DiscrepancyField>();
    const auto random = randomPoints(1200, seed);
    const auto centres = randomPoints(6, seed + 100);
    for (std::size_t i = 0; i < random.size(); ++i) {
        const bool isClump = i % 3 == 0;
        const Eigen::Vector3d spread(3.0, 2.0, 0.3);
        const Eigen::Vector3d& centre = centres[i % centres.size()];
        const Eigen::Vector3d inUnit = isClump ? Eigen::Vector3d(centre + 0.04 * random[i]) : random[i];
        field->points.push_back(inUnit.cwiseProduct(spread));
        const double unit = random[(i + 7) % random.size()].x();
        field->smoothedEuclidean_m.push_back((isClump ? 0.03 : 0.0) + 0.025 * unit);
        field->smoothedMahalanobis.push_back((isClump ? 1.8 : 0.3) + 1.5 * unit);
        if (i % 50 == 1) field->smoothedMahalanobis.back() = std::numeric_limits<double>::quiet_NaN();
    }
    field->weights.assign(field->points.size(), 1);
    field->nearest.assign(field->points.size(), 0);
    field->euclidean_m = field->smoothedEuclidean_m;
    field->mahalanobis = field->smoothedMahalanobis;
    SearchTrial trial;
    trial.name = "trial_" + std::to_string(seed);
    trial.T_reference_from_map =
        Eigen::Translation3d(0.4, -0.2, 0.05) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ());
    for (std::size_t f = 0; f < 2 + seed % 2; ++f) {
        const Eigen::Vector3d fod = centres[f].cwiseProduct(Eigen::Vector3d(3.0, 2.0, 0.3));
        trial.fods_map.push_back(trial.T_reference_from_map.inverse() * fod);
    }
    trial.field = field;
    return trial;
}

std::vector<SearchTrial> exampleTrials() {
    return {exampleTrial(1), exampleTrial(2), exampleTrial(3)};
}

ParameterSearchSettings smallGrid() {
    ParameterSearchSettings settings;
    settings.cutoffCount = 6;
    settings.thresholdCount = 4;
    settings.highestLeastPoints = 3;
    return settings;
}

ParameterSearchResult search(const std::vector<SearchTrial>& trials, const ParameterSearchSettings& settings) {
    Progress progress;
    return searchParameters(trials, settings, progress);
}

/// A grid point by the stages that a detection runs.
SearchCost costByDetection(const std::vector<SearchTrial>& trials, const ParameterSearchResult& result,
                           const GridPoint& point) {
    CandidateSettings settings;
    settings.metric = result.settings.metric;
    settings.linkage = result.settings.linkage;
    settings.centroid = result.settings.centroid;
    settings.clusterCutoff_m = result.cutoffs_m[point.cutoff];
    settings.threshold = result.thresholds[point.threshold];
    settings.minimumPoints = result.leastPoints[point.leastPoints];
    SearchCost sum;
    for (const SearchTrial& trial : trials) {
        Progress progress;
        const CandidateSet set =
            findCandidates(*trial.field, settings, 0.02, 0.0, trial.T_reference_from_map, progress);
        std::vector<Eigen::Vector3d> centroids;
        for (const Candidate& candidate : set.candidates)
            centroids.push_back(candidate.centroid_map);
        const Association association = associate(trial.fods_map, centroids, result.settings.lambda_m);
        sum.cost += association.cost;
        sum.candidates += static_cast<double>(set.candidates.size());
        sum.unassociatedCandidates += static_cast<double>(association.unassociatedCandidates);
    }
    const auto count = static_cast<double>(trials.size());
    return {sum.cost / count, 0.0, sum.unassociatedCandidates / count, sum.candidates / count};
}

TEST(ParameterSearch, CostsEveryGridPointAsDetectionAndAssociationDo) {
    const auto trials = exampleTrials();
    for (const Linkage linkage : {Linkage::Centroid, Linkage::Single}) {
        for (const CentroidKind centroid : {CentroidKind::Plain, CentroidKind::DiscrepancyWeighted}) {
            for (const Metric metric : {Metric::Euclidean, Metric::Mahalanobis}) {
                ParameterSearchSettings settings = smallGrid();
                settings.linkage = linkage;
                settings.centroid = centroid;
                settings.metric = metric;
                settings.lambda_m = 0.07;
                const ParameterSearchResult result = search(trials, settings);
                ASSERT_EQ(result.costs.size(), 6u * 4u * 4u);
                for (std::size_t c = 0; c < 6; ++c) {
                    for (std::size_t t = 0; t < 4; ++t) {
                        for (std::size_t l = 0; l < 4; ++l) {
                            const SearchCost expected = costByDetection(trials, result, {c, t, l});
                            const SearchCost& found = result.at({c, t, l});
                            EXPECT_NEAR(found.cost, expected.cost, 1e-12);
                            EXPECT_NEAR(found.distance_m + 0.07 * found.unassociatedCandidates, found.cost, 1e-12);
                            EXPECT_EQ(found.candidates, expected.candidates);
                            EXPECT_EQ(found.unassociatedCandidates, expected.unassociatedCandidates);
                        }
                    }
                }
            }
        }
    }
}

TEST(ParameterSearch, FindsTheLowestCostAndSettingsThatGiveIt) {
    const auto trials = exampleTrials();
    const ParameterSearchResult result = search(trials, smallGrid());
    for (const SearchCost& cost : result.costs)
        EXPECT_GE(cost.cost, result.at(result.best).cost);
    const CandidateSettings best = bestCandidateSettings(result);
    EXPECT_EQ(best.metric, Metric::Mahalanobis);
    EXPECT_EQ(best.clusterCutoff_m, result.cutoffs_m[result.best.cutoff]);
    EXPECT_EQ(best.threshold, result.thresholds[result.best.threshold]);
    EXPECT_EQ(best.minimumPoints, result.leastPoints[result.best.leastPoints]);
}

TEST(ParameterSearch, GivesATieToTheLowerCutoffThenTheLowerThresholdThenFewerPoints) {
    SearchTrial trial;
    auto field = std::make_shared<DiscrepancyField>();
    field->points.assign(5, {1.0, 0.0, 0.0});
    field->smoothedEuclidean_m.assign(5, 0.9);
    trial.field = field;
    trial.fods_map = {{1.0, 0.5, 0.0}};
    ParameterSearchSettings settings = smallGrid();
    settings.metric = Metric::Euclidean;
    settings.lowestThreshold = 0.1;
    settings.highestThreshold = 0.8;
    const ParameterSearchResult result = search({trial}, settings);
    EXPECT_EQ(result.best, (GridPoint{0, 0, 0}));
    EXPECT_EQ(result.at(result.best).cost, 0.5);
}

TEST(ParameterSearch, HasThePapersGrid) {
    const auto trials = exampleTrials();
    const ParameterSearchResult result = search(trials, {});
    ASSERT_EQ(result.cutoffs_m.size(), 30u);
    EXPECT_EQ(result.cutoffs_m.front(), 0.05);
    EXPECT_EQ(result.cutoffs_m.back(), 1.0);
    ASSERT_EQ(result.thresholds.size(), 20u);
    double lowest = std::numeric_limits<double>::infinity();
    for (const SearchTrial& trial : trials)
        lowest = std::min(lowest, *percentileOfKnown(trial.field->smoothedMahalanobis, 25.0));
    EXPECT_EQ(result.thresholds.front(), lowest);
    EXPECT_EQ(result.thresholds.back(), 3.0);
    EXPECT_EQ(result.leastPoints, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
    EXPECT_EQ(result.settings.lambda_m, 0.05);
    EXPECT_EQ(usualHighestThreshold(Metric::Euclidean), 0.05);
}

TEST(ParameterSearch, GivesTheSameBytesWithOneThreadAndWithTwo) {
    const auto trials = exampleTrials();
    std::vector<ParameterSearchResult> results;
    for (const std::size_t threads : {1u, 2u}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        results.push_back(search(trials, smallGrid()));
    }
    EXPECT_EQ(results[0].costs, results[1].costs);
    EXPECT_EQ(results[0].best, results[1].best);
}

TEST(ParameterSearch, ChargesATrialThatCouldNotBeAlignedAtEveryPoint) {
    auto trials = exampleTrials();
    const ParameterSearchResult without = search(trials, smallGrid());
    SearchTrial failed;
    failed.name = "failed";
    failed.fods_map = {{0.0, 0.0, 0.0}};
    trials.push_back(failed);
    const ParameterSearchResult with = search(trials, smallGrid());
    EXPECT_EQ(with.best, without.best);
    for (std::size_t i = 0; i < with.costs.size(); ++i)
        EXPECT_NEAR(with.costs[i].cost, (3.0 * without.costs[i].cost + kNoCandidateDistance_m) / 4.0, 1e-12);
    EXPECT_THROW(search({failed}, smallGrid()), Error);
}

TEST(ParameterSearch, ChargesWhatNoThresholdLeavesCandidatesIn) {
    ParameterSearchSettings settings = smallGrid();
    settings.lowestThreshold = 100.0;
    settings.highestThreshold = 200.0;
    const ParameterSearchResult result = search(exampleTrials(), settings);
    for (const SearchCost& cost : result.costs) {
        EXPECT_EQ(cost.cost, kNoCandidateDistance_m);
        EXPECT_EQ(cost.candidates, 0.0);
    }
}

TEST(ParameterSearch, NamesAllProblemsOfItsSettingsAtOnce) {
    ParameterSearchSettings settings;
    settings.lowestCutoff_m = -1.0;
    settings.cutoffCount = 0;
    settings.highestThreshold = std::nan("");
    settings.lowestThresholdPercentile = 101.0;
    settings.highestLeastPoints = -1;
    settings.lambda_m = -0.05;
    EXPECT_EQ(parameterSearchProblems(settings).size(), 6u);
    try {
        search(exampleTrials(), settings);
        FAIL();
    } catch (const Error& error) {
        for (const std::string& problem : parameterSearchProblems(settings))
            EXPECT_NE(std::string(error.what()).find(problem), std::string::npos) << error.what();
    }
    EXPECT_TRUE(parameterSearchProblems({}).empty());
}

TEST(ParameterSearch, RefusesGridsAndTrialsThatMeanNothing) {
    const auto problems = [](auto change) {
        ParameterSearchSettings settings;
        change(settings);
        return parameterSearchProblems(settings).size();
    };
    EXPECT_EQ(problems([](auto& s) { s.lowestCutoff_m = 2.0; }), 1u);
    EXPECT_EQ(problems([](auto& s) { s.lowestThreshold = 2.0, s.highestThreshold = 1.0; }), 1u);
    EXPECT_EQ(problems([](auto& s) { s.highestLeastPoints = 5000; }), 1u);
    EXPECT_EQ(problems([](auto& s) { s.cutoffCount = s.thresholdCount = 1000, s.highestLeastPoints = 900; }), 1u);
    EXPECT_THROW(search({}, {}), Error);
    auto trials = exampleTrials();
    trials[1].fods_map.clear();
    EXPECT_THROW(search(trials, {}), Error);
    trials = exampleTrials();
    trials[1].fods_map[0].x() = std::nan("");
    EXPECT_THROW(search(trials, {}), Error);
    // The lowest threshold is found to lie over the highest.
    ParameterSearchSettings settings;
    settings.highestThreshold = 0.01;
    EXPECT_THROW(search(exampleTrials(), settings), Error);
}

TEST(ParameterSearch, StopsWhenCancelled) {
    const auto trials = exampleTrials();
    int reports = 0;
    Progress progress;
    Progress cancelling([&](const std::string& stage, double) {
        if (stage == "searching the parameters" && ++reports == 3) progress.cancel();
        progress.throwIfCancelled();
    });
    EXPECT_THROW(searchParameters(trials, {}, cancelling), Cancelled);
}

TEST(ParameterSearch, ReportsItsProgressFromTheCallingThread) {
    const auto caller = std::this_thread::get_id();
    double last = 0.0;
    Progress progress([&](const std::string&, double fraction) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        EXPECT_GE(fraction, 0.0);
        EXPECT_LE(fraction, 1.0);
        last = fraction;
    });
    searchParameters(exampleTrials(), smallGrid(), progress);
    EXPECT_GT(last, 0.0);
}

TEST(Numpy, SpacesValuesEvenly) {
    const auto cutoffs = linearSpace(0.05, 1.0, 30);
    EXPECT_EQ(cutoffs[1], 0.08275862068965517);
    EXPECT_EQ(cutoffs[9], 0.3448275862068965);
    EXPECT_EQ(cutoffs[21], 0.7379310344827585);
    EXPECT_EQ(cutoffs[29], 1.0);
    EXPECT_EQ(linearSpace(0.3, 0.7, 1), std::vector<double>{0.3});
    EXPECT_EQ(linearSpace(0.3, 0.7, 2), (std::vector<double>{0.3, 0.7}));
}

TEST(Numpy, InterpolatesPercentilesOfWhatIsKnown) {
    const std::vector<double> values{0.3, std::nan(""), 0.1, 0.7, 0.2, 0.55, 0.9};
    EXPECT_EQ(percentileOfKnown(values, 0.0), 0.1);
    EXPECT_EQ(percentileOfKnown(values, 25.0), 0.225);
    EXPECT_EQ(percentileOfKnown(values, 50.0), 0.42500000000000004);
    EXPECT_EQ(percentileOfKnown(values, 90.0), 0.8);
    EXPECT_EQ(percentileOfKnown(values, 100.0), 0.9);
    EXPECT_FALSE(percentileOfKnown(std::vector<double>{std::nan("")}, 25.0));
    EXPECT_FALSE(percentileOfKnown({}, 25.0));
}

}  // namespace
}  // namespace fodscope
