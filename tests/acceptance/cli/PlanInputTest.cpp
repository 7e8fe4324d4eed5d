// SPDX-License-Identifier: MIT
// What `plan` makes of grids, robots and candidates that are out of the ordinary: handled, or refused in words.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "core/common/Files.h"
#include "core/planning/OccupancyGrid.h"
#include "tests/acceptance/cli/Program.h"
#include "tests/fakes/PictureGrid.h"

namespace fodscope::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class PlanInput : public ::testing::Test {
  protected:
    /// One candidate of 10 cm for each place.
    void writeCandidates(const std::vector<std::array<double, 3>>& places_map) {
        json root = {{"schema", "fodscope.candidates/1"},
                     {"settings", {{"candidates", {{"threshold", 2.75}}}}},
                     {"T_reference_from_map", {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}},
                     {"candidates", json::array()}};
        for (const auto& place : places_map) {
            root["candidates"].push_back({{"id", "C-00" + std::to_string(root["candidates"].size() + 1)},
                                          {"centroid_map", place},
                                          {"centroid_reference", place},
                                          {"size", {0.1, 0.1, 0.1}},
                                          {"height_above_floor", place[2]}});
        }
        writeFile(folder_ / "candidates.json", root.dump());
    }

    void writeGrid(const OccupancyGrid& grid) { writeMapServerGrid(folder_ / "grid.yaml", grid); }

    void writeHeader(const std::string& image, const std::string& more = "") {
        writeFile(folder_ / "grid.yaml", "image: " + image +
                                             "\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                                             "occupied_thresh: 0.65\nfree_thresh: 0.196\n" +
                                             more);
    }

    Outcome plan(const std::string& robot = "1,1,0") {
        return runCli({"plan", "--candidates", (folder_ / "candidates.json").string(), "--grid",
                       (folder_ / "grid.yaml").string(), "--robot", robot, "--out", (folder_ / "w.json").string()});
    }

    json planned(const std::string& robot = "1,1,0") {
        const Outcome outcome = plan(robot);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return json::parse(readTextFile(folder_ / "w.json"));
    }

    void expectRefused(const Outcome& outcome, const std::string& about) {
        EXPECT_EQ(outcome.exitCode, 1);
        EXPECT_THAT(outcome.err, StartsWith("error: "));
        EXPECT_THAT(outcome.err, HasSubstr(about));
        EXPECT_THAT(outcome.err, HasSubstr("; ")) << "says what to do";
        EXPECT_FALSE(std::filesystem::exists(folder_ / "w.json"));
    }

    TestFolder folder_;
};

TEST_F(PlanInput, AnEmptyImageIsRefused) {
    writeCandidates({{2.0, 2.0, 0.05}});
    writeHeader("grid.pgm");
    writeFile(folder_ / "grid.pgm", std::string());
    expectRefused(plan(), "grid.pgm");
    writeFile(folder_ / "grid.pgm", std::string("P5\n0 0\n255\n"));
    expectRefused(plan(), "no pixels");
}

TEST_F(PlanInput, AGridThatIsAllUnknownIsRefused) {
    writeCandidates({{2.0, 2.0, 0.05}});
    OccupancyGrid grid = walledRoom(80, 80);
    std::ranges::fill(grid.cells, Cell::Unknown);
    writeGrid(grid);
    expectRefused(plan(), "no passable floor");
}

TEST_F(PlanInput, AGridOfOneCellIsHandled) {
    writeCandidates({{2.0, 2.0, 0.05}});
    writeGrid(pictureGrid({"."}));
    const json root = planned("0.02,0.02,0");
    EXPECT_EQ(root["waypoints"][0]["status"], "outside the grid");
    expectRefused((std::filesystem::remove(folder_ / "w.json"), plan("1,1,0")), "outside the grid");
}

TEST_F(PlanInput, AHundredMillionCellsAreRefusedBeforeTheyAreRead) {
    writeCandidates({{2.0, 2.0, 0.05}});
    writeHeader("grid.pgm");
    writeFile(folder_ / "grid.pgm", std::string("P5\n10000 10000\n255\n") + std::string(100, '\xfe'));
    expectRefused(plan(), "25 million pixels");
    writeFile(folder_ / "grid.pgm", std::string("P5\n999999999 999999999\n255\n"));
    expectRefused(plan(), "25 million pixels");
}

TEST_F(PlanInput, ATurnedOriginIsTheSameFloor) {
    writeCandidates({{2.0, 2.0, 0.05}});
    writeGrid(walledRoom(80, 80));
    const json straight = planned();
    // The same square room from another corner: a quarter turn about its middle.
    OccupancyGrid turned = walledRoom(80, 80);
    turned.origin_map = {4.0, 0.0, 1.5707963267948966};
    writeGrid(turned);
    const json root = planned();
    ASSERT_EQ(root["waypoints"][0]["status"], "ok");
    EXPECT_NEAR(root["waypoints"][0]["pose_map"]["x"].get<double>(),
                straight["waypoints"][0]["pose_map"]["x"].get<double>(), 1e-6);
    EXPECT_NEAR(root["length_m"].get<double>(), straight["length_m"].get<double>(), 0.05);
}

TEST_F(PlanInput, ARobotThatCannotBeThereIsRefused) {
    writeCandidates({{2.0, 2.0, 0.05}});
    OccupancyGrid grid = walledRoom(80, 80);
    for (int row = 0; row < 30; ++row)
        for (int column = 50; column < 80; ++column)
            grid.cells[grid.offset({column, row})] = Cell::Occupied;
    writeGrid(grid);
    expectRefused(plan("-3,1,0"), "outside the grid");
    expectRefused(plan("3.3,0.7,0"), "no passable floor");
    EXPECT_EQ(plan("here").exitCode, 2);
    EXPECT_EQ(plan("1,nan,0").exitCode, 2);
}

TEST_F(PlanInput, CandidatesAnywhereAreListedWithTheirReasons) {
    // Outside, in a wall's cells, at the robot's place, no place at all, high up, and behind a bulkhead.
    OccupancyGrid grid = walledRoom(200, 80);
    for (int row = 0; row < 80; ++row)
        grid.cells[grid.offset({120, row})] = Cell::Occupied;
    writeGrid(grid);
    writeCandidates(
        {{-5.0, 2.0, 0.05}, {2.0, 0.02, 0.1}, {1.0, 1.0, 0.05}, {1e200, 0.0, 0.05}, {2.0, 3.9, 1.5}, {8.5, 2.0, 0.05}});
    const json root = planned();
    std::map<std::string, std::string> rest;
    for (const json& candidate : root["candidates"])
        rest[candidate["id"]] = candidate["rest"];
    EXPECT_EQ(rest["C-001"], "outside the grid");
    EXPECT_EQ(rest["C-002"], "ok");
    EXPECT_EQ(rest["C-003"], "ok");
    EXPECT_EQ(rest["C-004"], "outside the grid");
    EXPECT_EQ(rest["C-005"], "too high for the camera");
    EXPECT_EQ(rest["C-006"], "unreachable");
    EXPECT_THAT(plan().out, HasSubstr("C-006: no waypoint: unreachable"));
    for (const json& waypoint : root["waypoints"]) {
        EXPECT_EQ(waypoint["pose_map"].is_null(), waypoint["status"] != "ok");
        if (waypoint["candidates"].size() != 1 || waypoint["candidates"][0] != "C-003") continue;
        EXPECT_GT(
            std::hypot(waypoint["pose_map"]["x"].get<double>() - 1.0, waypoint["pose_map"]["y"].get<double>() - 1.0),
            0.3);
    }
}

TEST_F(PlanInput, AHeaderThatIsNoneIsRefusedAndTheModesAreRead) {
    writeCandidates({{2.0, 2.0, 0.05}});
    writeHeader("missing.pgm");
    expectRefused(plan(), "missing.pgm");
    writeFile(folder_ / "grid.yaml", std::string("image: grid.pgm\n"));
    expectRefused(plan(), "'resolution' is missing");
    writeHeader("grid.pgm", "mode: rainbow\n");
    expectRefused(plan(), "mode");

    writeGrid(walledRoom(80, 80));
    const json expected = planned();
    for (const char* mode : {"mode: trinary\n", "mode: scale\n"}) {
        writeHeader("grid.pgm", mode);
        EXPECT_EQ(planned(), expected) << mode;
    }
    // The same room in negative.
    std::string pgm = readTextFile(folder_ / "grid.pgm");
    for (std::size_t i = pgm.size() - 80 * 80; i < pgm.size(); ++i)
        pgm[i] = static_cast<char>(255 - static_cast<unsigned char>(pgm[i]));
    writeFile(folder_ / "grid.pgm", pgm);
    std::string yaml = readTextFile(folder_ / "grid.yaml");
    yaml.replace(yaml.find("negate: 0"), 9, "negate: 1");
    writeFile(folder_ / "grid.yaml", yaml);
    EXPECT_EQ(planned(), expected);
}

TEST_F(PlanInput, BothLengthsAndTheOrderThatIsAskedForAreWritten) {
    writeGrid(walledRoom(200, 60));
    writeCandidates({{1.0, 1.5, 0.05}, {3.2, 1.5, 0.05}, {5.2, 1.5, 0.05}, {6.9, 1.5, 0.05}, {8.9, 1.5, 0.05}});
    const json shortest = planned("4,1.5,0");
    EXPECT_EQ(shortest["length_m"], shortest["shortest_tour_m"]);
    EXPECT_LE(shortest["shortest_tour_m"], shortest["nearest_next_m"]);
    writeFile(folder_ / "paper.yaml", std::string("waypoints:\n  order: nearest-next\n"));
    const Outcome outcome = runCli({"plan", "--candidates", (folder_ / "candidates.json").string(), "--grid",
                                    (folder_ / "grid.yaml").string(), "--robot", "4,1.5,0", "--params",
                                    (folder_ / "paper.yaml").string(), "--out", (folder_ / "n.json").string()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("nearest next: "));
    EXPECT_THAT(outcome.out, HasSubstr("shortest tour: "));
    const json nearest = json::parse(readTextFile(folder_ / "n.json"));
    EXPECT_EQ(nearest["length_m"], nearest["nearest_next_m"]);
    EXPECT_EQ(nearest["shortest_tour_m"], shortest["shortest_tour_m"]);
}

}  // namespace
}  // namespace fodscope::test
