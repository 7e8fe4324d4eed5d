// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/common/Files.h"
#include "tests/acceptance/SharedData.h"
#include "tests/acceptance/cli/Program.h"

namespace fodscope::test {
namespace {

using nlohmann::json;

/// The figures of an independent implementation of the paper's method on the same maps (BASELINE.md and golden/).
class Baseline : public ::testing::Test {
  protected:
    void SetUp() override {
        if (!std::filesystem::exists(data_ / "golden" / "train_transforms.csv")) {
            GTEST_SKIP() << data_ << " is not there; set FODSCOPE_SHARED_DATA to the folder with the real tanks' data";
        }
        makeFolder(folder_ / "trials");
    }

    /// With the baseline's own transforms of the nominal maps, so that the reference is the baseline's.
    void makeReference() {
        std::vector<std::string> arguments{"reference", "--maps"};
        for (int i = 0; i < 15; ++i)
            arguments.push_back((data_ / numbered("train_", i, ".pcd")).string());
        arguments.insert(arguments.end(), {"--transforms", (data_ / "golden" / "train_transforms.csv").string(),
                                           "--out", (folder_ / "reference.ply").string()});
        const Outcome made = runCli(arguments);
        ASSERT_EQ(made.exitCode, 0) << made.err;
    }

    static std::string numbered(const std::string& prefix, int i, const std::string& extension) {
        return prefix + (i < 10 ? "0" : "") + std::to_string(i) + extension;
    }

    void addTrial(int i) {
        for (const char* extension : {".pcd", ".json"})
            std::filesystem::create_symlink(data_ / numbered("val_", i, extension),
                                            folder_ / "trials" / numbered("val_", i, extension));
    }

    json evaluate(const std::vector<std::string>& metric) {
        const std::filesystem::path out = folder_ / "evaluation.json";
        std::vector<std::string> arguments = {"evaluate",
                                              "--reference",
                                              (folder_ / "reference.ply").string(),
                                              "--trials",
                                              (folder_ / "trials").string(),
                                              "--cluster-cutoff",
                                              "0.738",
                                              "--min-points",
                                              "3",
                                              "--crop-height",
                                              "0.60",
                                              "--out",
                                              out.string()};
        arguments.insert(arguments.end(), metric.begin(), metric.end());
        const Outcome outcome = runCli(arguments);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.exitCode == 0 ? json::parse(readTextFile(out)) : json();
    }

    std::filesystem::path data_ = sharedData() / "nuwc-tank";
    TestFolder folder_;
};

/// With the baseline's own transforms of the nominal maps and of val_03 every choice is the same, so that the figures
/// are, up to voxels that change sides with the last digits.
TEST_F(Baseline, Val03CostsWhatItCostsTheIndependentImplementation) {
    makeReference();
    std::filesystem::create_symlink(data_ / "val_03.pcd", folder_ / "trials" / "val_03.pcd");
    json truth = json::parse(readTextFile(data_ / "val_03.json"));
    std::istringstream numbers(readTextFile(data_ / "golden" / "query_val_03_T.csv"));
    truth["T_cad_from_map"] = json::array();
    for (std::string number; std::getline(numbers, number, truth["T_cad_from_map"].size() % 4 == 3 ? '\n' : ',');)
        truth["T_cad_from_map"].push_back(std::stod(number));
    writeFile(folder_ / "trials" / "val_03.json", truth.dump());
    const json evaluation =
        evaluate({"--metric", "mahalanobis", "--threshold", "2.4301239604802167", "--stored-transforms"});
    const json trial = evaluation.at("trials").at(0);
    const json golden = json::parse(readTextFile(data_ / "golden" / "params.json"));
    EXPECT_NEAR(trial["cost"].get<double>(), golden["cost_M"].get<double>(), 0.01);
    EXPECT_EQ(trial["candidates"], 7);
    // Distances of the golden candidates: drill 0.021, sander 0.012, screwdriver 0.667, crimper 0.454 m.
    const std::map<std::string, double> expected_m = {
        {"drill", 0.021}, {"sander", 0.012}, {"screwdriver", 0.667}, {"crimper", 0.454}};
    for (const json& fod : trial["fods"])
        EXPECT_NEAR(fod["distance_m"].get<double>(), expected_m.at(fod["type"].get<std::string>()), 0.01) << fod;
}

/// All 15 maps take minutes, so they are run on demand. Counts may differ by a tenth, costs by 0.04 m, and recalls by
/// two of 48 FOD, which then lie some 1.5 m from the next candidate, so that the mean distance may differ by 0.06 m:
/// maps with a bad loop closure have thousands of points just about the threshold.
TEST_F(Baseline, TheFifteenValidationMapsGiveItsTable) {
    if (std::getenv("FODSCOPE_FULL_BASELINE") == nullptr)
        GTEST_SKIP() << "takes minutes; set FODSCOPE_FULL_BASELINE to run it";
    makeReference();
    for (int i = 0; i < 15; ++i)
        addTrial(i);
    struct Row {
        std::vector<std::string> metric;
        double candidates, points, unassociated, falseCandidates, distance_m, recall30, recall15, cost;
    };
    const std::vector<Row> table = {
        {{"--metric", "mahalanobis", "--threshold", "2.4301"}, 112, 910.20, 4.67, 5.07, 0.264, 0.812, 0.771, 0.508},
        {{"--metric", "euclidean", "--threshold", "0.0250"}, 162, 2359.07, 7.93, 8.87, 0.388, 0.667, 0.625, 0.842}};
    for (const Row& row : table) {
        SCOPED_TRACE(row.metric[1]);
        const json summary = evaluate(row.metric).at("summary");
        const auto mean = [&](const char* key) { return summary[key]["mean"].get<double>(); };
        EXPECT_NEAR(summary["total_candidates"].get<double>(), row.candidates, 0.1 * row.candidates);
        EXPECT_NEAR(mean("unassociated_points_per_trial"), row.points, 0.1 * row.points);
        EXPECT_NEAR(mean("unassociated_candidates_per_trial"), row.unassociated, 0.1 * row.unassociated);
        EXPECT_NEAR(mean("false_candidates_per_trial"), row.falseCandidates, 0.1 * row.falseCandidates);
        EXPECT_NEAR(mean("distance_error_m"), row.distance_m, 0.06);
        EXPECT_NEAR(summary["recall"]["0.30"].get<double>(), row.recall30, 2.1 / 48);
        EXPECT_NEAR(summary["recall"]["0.15"].get<double>(), row.recall15, 2.1 / 48);
        EXPECT_NEAR(summary["mean_cost"].get<double>(), row.cost, 0.04);
    }
}

}  // namespace
}  // namespace fodscope::test
