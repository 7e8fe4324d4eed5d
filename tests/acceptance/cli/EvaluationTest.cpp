// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/common/Files.h"
#include "tests/acceptance/cli/Program.h"

namespace fodscope::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

json readJson(const std::filesystem::path& file) {
    return json::parse(readTextFile(file));
}

void expectDone(const Outcome& outcome) {
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
}

void expectRefused(const Outcome& outcome, const std::string& why) {
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr(why));
    EXPECT_EQ(outcome.out, "");
}

/// Quick simulated maps of the built-in tank: a reference, two trials and a nominal map among them. Made once.
class BuiltinTrials {
  public:
    BuiltinTrials() {
        const Outcome maps = runCli({"simulate", "--world", "builtin", "--kind", "nominal", "--count", "4", "--seed",
                                     "10", "--quick", "--out", path("nominal")});
        std::vector<std::string> arguments{"reference", "--maps"};
        std::istringstream lines(maps.out);
        for (std::string line; std::getline(lines, line);)
            arguments.push_back(line);
        arguments.insert(arguments.end(), {"--align-to", path("nominal/tank.ply"), "--out", reference()});
        made_ = maps.exitCode == 0 && runCli(arguments).exitCode == 0 &&
                runCli({"simulate", "--world", "builtin", "--kind", "trial", "--count", "2", "--seed", "8", "--quick",
                        "--out", trials()})
                        .exitCode == 0;
        for (const char* extension : {".pcd", ".json"})
            std::filesystem::copy_file(path("nominal/nominal_00") + extension, trials() + "/nominal_00" + extension);
    }

    bool made() const { return made_; }
    std::string reference() const { return path("reference.ply"); }
    std::string trials() const { return path("trials"); }
    std::string worlds() const { return path("trials/worlds"); }

  private:
    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    TestFolder folder_;
    bool made_ = false;
};

const BuiltinTrials& builtinTrials() {
    static const BuiltinTrials trials;
    return trials;
}

class Evaluate : public ::testing::Test {
  protected:
    void SetUp() override { ASSERT_TRUE(builtinTrials().made()); }

    std::vector<std::string> evaluate(const std::string& out, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments = {
            "evaluate", "--reference",           builtinTrials().reference(), "--trials", builtinTrials().trials(),
            "--out",    (folder_ / out).string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }

    TestFolder folder_;
};

TEST_F(Evaluate, CountsWhatTheDetectionFoundInSimulatedTrialsAndPhotographsIt) {
    const Outcome outcome = runCli(evaluate("e.json", {"--photos", "--worlds", builtinTrials().worlds()}));
    expectDone(outcome);
    const json root = readJson(folder_ / "e.json");
    ASSERT_EQ(root["trials"].size(), 2u);
    EXPECT_EQ(root["nominal_maps"], json({"nominal_00"}));
    std::size_t fods = 0, candidates = 0;
    double cost = 0.0;
    for (const json& trial : root["trials"]) {
        const json truth =
            readJson(std::filesystem::path(builtinTrials().trials()) / (trial["name"].get<std::string>() + ".json"));
        ASSERT_EQ(trial["fods"].size(), truth["fods"].size());
        fods += trial["fods"].size();
        candidates += trial["candidates"].get<std::size_t>();
        cost += trial["cost"].get<double>() / 2.0;
        double distance_m = 0.0;
        for (const json& fod : trial["fods"])
            distance_m += fod["distance_m"].get<double>() / static_cast<double>(trial["fods"].size());
        EXPECT_NEAR(trial["cost"].get<double>(), distance_m + 0.05 * trial["unassociated_candidates"].get<double>(),
                    2e-6);
        EXPECT_TRUE(trial["failure"].is_null());
    }
    const json& summary = root["summary"];
    EXPECT_EQ(summary["fods"], fods);
    EXPECT_EQ(summary["total_candidates"], candidates);
    EXPECT_NEAR(summary["mean_cost"].get<double>(), cost, 2e-6);
    EXPECT_GT(summary["recall"]["0.30"].get<double>(), 0.3);
    const json& photos = summary["photos"];
    EXPECT_GT(photos["recall"].get<double>(), 0.3);
    EXPECT_GT(photos["metres"].get<double>(), 0.0);
    EXPECT_NEAR(photos["precision"].get<double>(),
                photos["photos_with_fod"].get<double>() / photos["photos"].get<double>(), 1e-6);
    EXPECT_NEAR(photos["photos_per_fod"].get<double>(), photos["photos"].get<double>() / static_cast<double>(fods),
                1e-6);
    EXPECT_LE(photos["candidates_without_photo"].get<std::size_t>(), candidates);
    EXPECT_GE(photos["metres_nearest_next"].get<double>(), photos["metres"].get<double>());
    EXPECT_THAT(outcome.out, HasSubstr("How it was counted"));
    EXPECT_THAT(outcome.out, HasSubstr("FOD on at least one photo"));
}

TEST_F(Evaluate, TheSameInputGivesTheSameBytesAndCompareFindsNoDifference) {
    expectDone(runCli(evaluate("a.json")));
    expectDone(runCli(evaluate("b.json")));
    EXPECT_EQ(readTextFile(folder_ / "a.json"), readTextFile(folder_ / "b.json"));
    const Outcome same = runCli({"compare", (folder_ / "a.json").string(), (folder_ / "b.json").string(), "--out",
                                 (folder_ / "c.json").string()});
    expectDone(same);
    const json tests = readJson(folder_ / "c.json")["tests"];
    EXPECT_EQ(tests["unassociated_points"]["n"], 2);
    EXPECT_TRUE(tests["unassociated_points"]["p_a_smaller_than_b"].is_null());
}

TEST_F(Evaluate, ComparesTwoMetrics) {
    expectDone(runCli(evaluate("m.json", {"--stored-transforms"})));
    expectDone(runCli(evaluate("l2.json", {"--metric", "euclidean", "--stored-transforms"})));
    const Outcome outcome = runCli({"compare", (folder_ / "m.json").string(), (folder_ / "l2.json").string()});
    expectDone(outcome);
    EXPECT_THAT(outcome.out, HasSubstr("A smaller than B"));
    EXPECT_THAT(outcome.out, HasSubstr("distance error per FOD"));

    json other = readJson(folder_ / "l2.json");
    other["trials"].erase(0);
    writeFile(folder_ / "fewer.json", other.dump());
    expectRefused(runCli({"compare", (folder_ / "m.json").string(), (folder_ / "fewer.json").string()}),
                  "does not evaluate the same trials");
}

TEST_F(Evaluate, RefusesWhatItCannotWorkWith) {
    const TestFolder empty;
    EXPECT_EQ(runCli(evaluate("e.json", {"--photos"})).exitCode, 2);
    expectRefused(runCli(evaluate("e.json", {"--photos", "--worlds", empty.path().string()})),
                  "the worlds of these trials are missing: trial_00.json, trial_01.json");
    expectRefused(runCli(evaluate("missing/e.json")), "its folder does not exist");
    expectRefused(runCli({"evaluate", "--reference", builtinTrials().reference(), "--trials", empty.path().string(),
                          "--out", (folder_ / "e.json").string()}),
                  "holds no trials");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "e.json"));
}

TEST_F(Evaluate, RefusesAWorldThatIsNotTheTrials) {
    const std::filesystem::path worlds = builtinTrials().worlds();
    const TestFolder swapped;
    std::filesystem::create_symlink(worlds / "trial_01", swapped / "trial_01");
    for (const char* name : {"trial_00.json", "trial_01.json"})
        std::filesystem::copy_file(worlds / "trial_01.json", swapped / name);
    expectRefused(runCli(evaluate("e.json", {"--photos", "--worlds", swapped.path().string()})),
                  "which the trial's ground truth lists");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "e.json"));
}

std::vector<std::string> tunePhotos(const TestFolder& folder, const std::string& recall, const std::string& out) {
    return {"tune",
            "--objective",
            "photos",
            "--recall",
            recall,
            "--reference",
            builtinTrials().reference(),
            "--trials",
            builtinTrials().trials(),
            "--worlds",
            builtinTrials().worlds(),
            "--cutoffs",
            "0.15,0.345,2",
            "--thresholds",
            "2.4,3.4,3",
            "--least-points",
            "0,2",
            "--curve",
            (folder / (out + ".json")).string(),
            "--out",
            (folder / (out + ".yaml")).string()};
}

TEST_F(Evaluate, TheFewestPhotosAtARecallAreThoseThatAnEvaluationTakesThere) {
    const Outcome tuned = runCli(tunePhotos(folder_, "0.3", "a"));
    expectDone(tuned);
    EXPECT_THAT(tuned.out, HasSubstr("Fewest photos at a recall of at least 0.300: threshold "));
    const json curve = readJson(folder_ / "a.json");
    EXPECT_EQ(curve["schema"], "fodscope.photo-search/1");
    EXPECT_EQ(curve["grid_points"], 18);
    const json& best = curve["best"];
    EXPECT_GE(best["recall"].get<double>(), 0.3);
    double recall = -1.0;
    std::size_t photos = 0;
    for (const json& point : curve["curve"]) {
        EXPECT_GT(point["recall"].get<double>(), recall);
        EXPECT_GE(point["photos"].get<std::size_t>(), photos);
        recall = point["recall"];
        photos = point["photos"];
        if (point["recall"].get<double>() >= 0.3) {
            EXPECT_GE(point["photos"], best["photos"]);
        }
    }
    // The parameter file it wrote, in the whole program: driven, photographed and counted.
    expectDone(runCli(evaluate(
        "e.json", {"--photos", "--worlds", builtinTrials().worlds(), "--params", (folder_ / "a.yaml").string()})));
    const json counted = readJson(folder_ / "e.json")["summary"];
    EXPECT_EQ(counted["total_candidates"], best["candidates"]);
    EXPECT_EQ(counted["photos"]["photos"], best["photos"]);
    EXPECT_EQ(counted["photos"]["photos_with_fod"], best["photos_with_fod"]);
    EXPECT_EQ(counted["photos"]["fods_photographed"], best["fods_shown"]);
    EXPECT_EQ(counted["photos"]["candidates_without_photo"], best["candidates_without_photo"]);

    expectDone(runCli(tunePhotos(folder_, "0.3", "b")));
    EXPECT_EQ(readTextFile(folder_ / "a.json"), readTextFile(folder_ / "b.json"));
    EXPECT_EQ(readTextFile(folder_ / "a.yaml"), readTextFile(folder_ / "b.yaml"));
}

TEST_F(Evaluate, ARecallOutOfReachIsToldWithWhatCanBeReached) {
    std::vector<std::string> arguments = tunePhotos(folder_, "1", "a");
    const auto thresholds = std::ranges::find(arguments, "2.4,3.4,3");
    *thresholds = "80,90,2";
    expectRefused(runCli(arguments), "No grid point shows as many FOD as a recall of 1.000 asks for");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.yaml"));
    EXPECT_TRUE(readJson(folder_ / "a.json")["best"].is_null());
}

TEST_F(Evaluate, PhotosAreSearchedForWithAWorldAndARecallOnly) {
    const std::vector<std::string> whole = tunePhotos(folder_, "0.5", "a");
    for (const char* option : {"--recall", "--worlds"}) {
        std::vector<std::string> arguments = whole;
        const auto at = std::ranges::find(arguments, option);
        arguments.erase(at, at + 2);
        EXPECT_EQ(runCli(arguments).exitCode, 2) << option;
    }
    std::vector<std::string> paper = whole;
    *std::ranges::find(paper, "photos") = "cost";
    EXPECT_EQ(runCli(paper).exitCode, 2);
    Program program(whole);
    while (program.isRunning() && !program.hearsInterrupts())
        sched_yield();
    program.interrupt();
    EXPECT_EQ(program.wait().exitCode, 3);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.yaml"));
}

TEST_F(Evaluate, AnInterruptEndsItAndLeavesNothingBehind) {
    Program program(evaluate("e.json"));
    while (program.isRunning() && !program.hearsInterrupts())
        sched_yield();
    program.interrupt();
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.exitCode, 3) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "e.json"));
}

TEST_F(Evaluate, ReadersAreJudgedByTheWorldsOfTheirSessions) {
    const std::string session = (folder_ / "a.fodscope").string();
    const std::string map = builtinTrials().trials() + "/trial_00.pcd";
    expectDone(runCli({"inspect", "--reference", builtinTrials().reference(), "--map", map, "--robot", "simulated",
                       "--world", "builtin", "--session", session}));
    const std::string out = (folder_ / "agreement.json").string();
    const Outcome outcome = runCli({"agreement", session, "--worlds", builtinTrials().worlds(), "--out", out});
    expectDone(outcome);
    const json agreement = readJson(out);
    // Labelled from the same world, so everything is right.
    EXPECT_EQ(agreement["accuracy"], 1.0);
    EXPECT_GT(agreement["total"].get<int>(), 0);
    EXPECT_TRUE(agreement["agreement"]["raw"].is_null());
    EXPECT_THAT(outcome.out, HasSubstr("Confusion matrix"));

    // A reader who answers 'not sure' of everything is never right.
    const std::string unsure = (folder_ / "unsure.fodscope").string();
    expectDone(runCli(
        {"detect", "--reference", builtinTrials().reference(), "--map", map, "--out", (folder_ / "detect").string()}));
    std::string labels = "candidate,label\n";
    const json detected = readJson(folder_ / "detect" / "candidates.json");
    for (const json& candidate : detected["candidates"])
        labels += candidate["id"].get<std::string>() + ",not sure\n";
    writeFile(folder_ / "Ann.csv", labels);
    expectDone(runCli({"inspect", "--reference", builtinTrials().reference(), "--map", map, "--robot", "simulated",
                       "--world", "builtin", "--labels", (folder_ / "Ann.csv").string(), "--session", unsure}));
    expectDone(runCli({"agreement", unsure, "--worlds", builtinTrials().worlds(), "--out", out}));
    EXPECT_EQ(readJson(out)["accuracy"], 0.0);
    expectDone(runCli({"agreement", unsure, "--out", out}));
    EXPECT_TRUE(readJson(out)["accuracy"].is_null());

    const TestFolder empty;
    expectRefused(runCli({"agreement", session, "--worlds", empty.path().string(), "--out", out}), "is not there");
    expectRefused(runCli({"agreement", builtinTrials().reference(), "--out", out}), "reference.ply");
}

}  // namespace
}  // namespace fodscope::test
