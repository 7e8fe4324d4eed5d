// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/common/Files.h"
#include "tests/acceptance/cli/RoomFiles.h"

namespace fodscope::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

json readJson(const std::filesystem::path& file) {
    return json::parse(readTextFile(file));
}

double distance(const json& a, const json& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += std::pow(a[i].get<double>() - b[i].get<double>(), 2);
    return std::sqrt(sum);
}

void expectDone(const Outcome& outcome) {
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    // Progress goes to a terminal only.
    EXPECT_EQ(outcome.err, "");
}

TEST(Detect, FindsABoxOnTheFloorAndTheSameInputGivesTheSameBytes) {
    TestFolder folder;
    std::string first;
    for (const char* name : {"a", "b"}) {
        const std::filesystem::path out = folder / name;
        expectDone(runCli(
            {"detect", "--reference", roomFiles().reference(), "--map", roomFiles().map(), "--out", out.string()}));
        const std::string text = readTextFile(out / "candidates.json") + readTextFile(out / "discrepancy.ply");
        if (first.empty()) first = text;
        EXPECT_EQ(text, first);
    }
    const json candidates = readJson(folder / "a" / "candidates.json");
    EXPECT_EQ(candidates["schema"], "fodscope.candidates/1");
    EXPECT_EQ(candidates["registration"]["converged"], true);
    ASSERT_FALSE(candidates["candidates"].empty());
    EXPECT_EQ(candidates["candidates"][0]["id"], "C-001");
    EXPECT_LT(distance(candidates["candidates"][0]["centroid_reference"], json({2.1, 1.3, 0.1})), 0.1);
    const json timing = readJson(folder / "a" / "timing.json");
    EXPECT_GT(timing["total_seconds"].get<double>(), 0.0);
}

TEST(Detect, OptionsGoOverTheParameterFile) {
    TestFolder folder;
    writeFile(folder / "p.yaml", std::string("candidates:\n  threshold: 5\n  minimum_points: 7\n"));
    expectDone(runCli({"detect", "--reference", roomFiles().reference(), "--map", roomFiles().map(), "--params",
                       (folder / "p.yaml").string(), "--threshold", "4", "--crop-height", "0.6", "--out",
                       (folder / "out").string()}));
    const json settings = readJson(folder / "out" / "candidates.json")["settings"];
    EXPECT_EQ(settings["candidates"]["threshold"], 4.0);
    EXPECT_EQ(settings["candidates"]["minimum_points"], 7);
    EXPECT_EQ(settings["discrepancy"]["crop_height_m"], 0.6);
}

TEST(Detect, TheChiSquareMetricComesWithItsOwnThreshold) {
    TestFolder folder;
    expectDone(runCli({"detect", "--reference", roomFiles().bareReference(), "--map", roomFiles().map(), "--metric",
                       "chi-square", "--out", (folder / "out").string()}));
    const json candidates = readJson(folder / "out" / "candidates.json");
    EXPECT_EQ(candidates["settings"]["candidates"]["metric"], "chi-square");
    EXPECT_NEAR(candidates["settings"]["candidates"]["threshold"].get<double>(), 4.2107002, 1e-6);
    EXPECT_EQ(candidates["settings"]["chi_square"]["neighbours"], 16);
    EXPECT_GT(candidates["points_above_threshold"], 0);
    EXPECT_THAT(readTextFile(folder / "out" / "discrepancy.ply"), ::testing::HasSubstr("property float chi_square"));
}

TEST(Detect, AGivenTransformReplacesTheRegistration) {
    TestFolder folder;
    writeFile(folder / "T.csv", std::string("1,0,0,0\n0,1,0,0\n0,0,1,0\n0,0,0,1\n"));
    expectDone(runCli({"detect", "--reference", roomFiles().reference(), "--map", roomFiles().map(), "--transform",
                       (folder / "T.csv").string(), "--out", (folder / "out").string()}));
    const json candidates = readJson(folder / "out" / "candidates.json");
    EXPECT_TRUE(candidates["registration"]["converged"].is_null());
    EXPECT_EQ(candidates["T_reference_from_map"][0], json({1.0, 0.0, 0.0, 0.0}));
}

/// The built-in tank from nothing to a report: every command, in the order in which a newcomer uses them.
TEST(BuiltinTank, IsInspectedFromMapsToReport) {
    TestFolder folder;
    const std::string nominal = (folder / "nominal").string();
    const std::string trial = (folder / "trial").string();
    const std::string reference = (folder / "reference.ply").string();
    const std::string session = (folder / "tank.fodscope").string();

    const Outcome maps = runCli({"simulate", "--world", "builtin", "--kind", "nominal", "--count", "4", "--seed", "10",
                                 "--quick", "--out", nominal});
    expectDone(maps);
    const Outcome trials = runCli({"simulate", "--world", "builtin", "--kind", "trial", "--count", "1", "--seed", "8",
                                   "--quick", "--out", trial});
    expectDone(trials);
    const std::filesystem::path map = trials.out.substr(0, trials.out.find('\n'));
    ASSERT_TRUE(std::filesystem::exists(map)) << trials.out;

    std::vector<std::string> arguments{"reference", "--maps"};
    std::istringstream lines(maps.out);
    for (std::string line; std::getline(lines, line);)
        arguments.push_back(line);
    ASSERT_EQ(arguments.size(), 6U);
    arguments.insert(arguments.end(), {"--align-to", nominal + "/tank.ply", "--out", reference});
    expectDone(runCli(arguments));

    expectDone(
        runCli({"detect", "--reference", reference, "--map", map.string(), "--out", (folder / "detect").string()}));
    const json candidates = readJson(folder / "detect" / "candidates.json");
    ASSERT_FALSE(candidates["candidates"].empty());

    const json truth = readJson(std::filesystem::path(map).replace_extension(".json"));
    const json start = truth["robot_start_pose_map"];
    std::ostringstream robot;
    robot << start["x"].get<double>() << "," << start["y"].get<double>() << "," << start["yaw_deg"].get<double>();
    const std::string grid = std::filesystem::path(map).replace_extension(".yaml").string();
    expectDone(runCli({"plan", "--candidates", (folder / "detect" / "candidates.json").string(), "--grid", grid,
                       "--robot", robot.str(), "--out", (folder / "waypoints.json").string()}));
    EXPECT_EQ(readJson(folder / "waypoints.json")["candidates"].size(), candidates["candidates"].size());

    const Outcome inspected = runCli({"inspect", "--reference", reference, "--map", map.string(), "--robot",
                                      "simulated", "--world", "builtin", "--session", session});
    expectDone(inspected);
    EXPECT_THAT(inspected.out, HasSubstr("photos"));

    const Outcome again = runCli({"inspect", "--reference", reference, "--map", map.string(), "--robot", "simulated",
                                  "--world", "builtin", "--session", session});
    EXPECT_EQ(again.exitCode, 1);
    EXPECT_THAT(again.err, HasSubstr("never overwritten"));

    const Outcome verified = runCli({"verify", session});
    expectDone(verified);
    const std::string head = verified.out.substr(verified.out.find("head ") + 5, 64);
    expectDone(runCli({"verify", session, "--head", head}));
    const Outcome foreign = runCli({"verify", session, "--head", std::string(64, '0')});
    EXPECT_EQ(foreign.exitCode, 1);
    EXPECT_THAT(foreign.err, HasSubstr("not in its chain"));

    for (const char* form : {"report.html", "report.pdf", "report.csv", "report.json"}) {
        const std::filesystem::path file = folder / form;
        expectDone(runCli({"report", session, "--out", file.string()}));
        EXPECT_GT(std::filesystem::file_size(file), 200U) << form;
    }
    const std::string html = readTextFile(folder / "report.html");
    EXPECT_THAT(html, HasSubstr("C-001"));
    EXPECT_THAT(html, HasSubstr("built-in world"));
    expectDone(runCli({"verify", session, "--head", head}));
    EXPECT_THAT(runCli({"report", session, "--out", (folder / "report.docx").string()}).err,
                Not(HasSubstr("internal")));
}

}  // namespace
}  // namespace fodscope::test
