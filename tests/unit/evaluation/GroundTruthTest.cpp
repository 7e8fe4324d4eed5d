// SPDX-License-Identifier: MIT
#include "core/evaluation/GroundTruth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/common/Error.h"
#include "core/common/Files.h"

namespace fodscope {
namespace {

using testing::HasSubstr;

class GroundTruth : public testing::Test {
  protected:
    GroundTruth() {
        folder_ = std::filesystem::path(testing::TempDir()) / "fodscope_ground_truth" /
                  testing::UnitTest::GetInstance()->current_test_info()->name();
        std::filesystem::remove_all(folder_);
        makeFolder(folder_);
    }
    ~GroundTruth() override { std::filesystem::remove_all(folder_); }

    void truth(const std::string& name, const std::string& json, bool withMap = true) {
        writeFile(folder_ / (name + ".json"), json);
        if (withMap) writeFile(folder_ / (name + ".pcd"), "");
    }

    std::string problem() {
        try {
            readTrials(folder_);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

    std::filesystem::path folder_;
};

constexpr const char* kDrill = R"({"type": "drill", "gt_centroid_map": [1, 2, 0.05], "observed": false})";

std::string withFods(const std::string& fods, const std::string& more = "") {
    return R"({"fods": [)" + fods + "]" + more + "}";
}

TEST_F(GroundTruth, ReadsTrialsSortedByName) {
    truth("b", withFods(""));
    truth("a", withFods(kDrill, R"(, "T_cad_from_map": [[0,-1,0,1],[1,0,0,2],[0,0,1,3],[0,0,0,1]])"));
    writeFile(folder_ / "a.yaml", "");
    const std::vector<Trial> trials = readTrials(folder_);
    ASSERT_EQ(2u, trials.size());
    EXPECT_EQ("a", trials[0].name);
    EXPECT_EQ(folder_ / "a.pcd", trials[0].map);
    EXPECT_FALSE(trials[0].isNominal());
    EXPECT_EQ("drill", trials[0].fods[0].type);
    EXPECT_FALSE(trials[0].fods[0].observed);
    EXPECT_EQ(Eigen::Vector3d(1, 2, 0.05), trials[0].fods[0].centroid_map);
    ASSERT_TRUE(trials[0].T_cad_from_map.has_value());
    EXPECT_EQ(Eigen::Vector3d(1, 2, 3), trials[0].T_cad_from_map->translation());
    EXPECT_FALSE(trials[0].T_cad_from_map_initial.has_value());
    EXPECT_EQ(folder_ / "a.yaml", trials[0].grid);
    EXPECT_TRUE(trials[1].isNominal());
    EXPECT_FALSE(trials[1].grid.has_value());
}

TEST_F(GroundTruth, TakesAFodAsObservedWhereNothingElseIsSaid) {
    truth("a", withFods(R"({"type": "drill", "gt_centroid_map": [1, 2, 3]})"));
    EXPECT_TRUE(readTrials(folder_)[0].fods[0].observed);
}

TEST_F(GroundTruth, ReadsTransformsInEveryFormOfTheFileContract) {
    const std::string rows = R"([0,-1,0,1, 1,0,0,2, 0,0,1,3, 0,0,0,1])";
    const std::string pose =
        R"({"x": 1, "y": 2, "z": 3, "qx": 0, "qy": 0, "qz": 0.70710678118654752, "qw": 0.70710678118654752})";
    truth("a", withFods("", R"(, "T_cad_from_map": )" + rows + R"(, "T_cad_from_map_initial": )" + pose));
    truth("b", withFods("", R"(, "T_cad_from_map": null)"));
    const std::vector<Trial> trials = readTrials(folder_);
    EXPECT_TRUE(trials[0].T_cad_from_map->isApprox(*trials[0].T_cad_from_map_initial, 1e-12));
    EXPECT_FALSE(trials[1].T_cad_from_map.has_value());
}

TEST_F(GroundTruth, LeavesOtherFilesAlone) {
    truth("a", withFods(kDrill));
    writeFile(folder_ / "evaluation.json", R"({"trials": []})");
    writeFile(folder_ / "notes.txt", "");
    EXPECT_EQ(1u, readTrials(folder_).size());
}

TEST_F(GroundTruth, ListsAllProblemsOfAFolderAtOnce) {
    truth("a", R"({"name": "a"})");
    truth("b", withFods(R"({"gt_centroid_map": [1, 2, 3]}, {"type": "drill"})"));
    truth("c", withFods(kDrill), false);
    writeFile(folder_ / "d.pcd", "");
    const std::string what = problem();
    EXPECT_THAT(what, HasSubstr(folder_.string() + ": "));
    EXPECT_THAT(what, HasSubstr("a.json: \"fods\" is missing"));
    EXPECT_THAT(what, HasSubstr("b.json: \"fods[0].type\" is missing"));
    EXPECT_THAT(what, HasSubstr("b.json: \"fods[1].gt_centroid_map\" is missing"));
    EXPECT_THAT(what, HasSubstr("c.json: its map c.pcd is missing"));
    EXPECT_THAT(what, HasSubstr("d.pcd: its ground truth d.json is missing"));
}

TEST_F(GroundTruth, NamesTheFileWhereOnlyOneIsAtFault) {
    truth("a", withFods("3"));
    truth("b", withFods(kDrill));
    EXPECT_THAT(problem(), HasSubstr((folder_ / "a.json").string() + ": \"fods[0]\" is not an object"));
}

TEST_F(GroundTruth, RefusesWrongTypesAndNumbersThatAreNotFinite) {
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"[]", "this is no JSON object"},
        {R"({"fods": [{"type": "dri)", "this is no JSON object"},
        {"", "this is no JSON object"},
        {R"({"fods": {}})", "\"fods\" is not a list"},
        {withFods(R"({"type": 3, "gt_centroid_map": [1, 2, 3]})"), "\"fods[0].type\" is not a text"},
        {withFods(R"({"type": "", "gt_centroid_map": [1, 2, 3]})"), "\"fods[0].type\" is not a text"},
        {withFods(R"({"type": "drill", "gt_centroid_map": "1 2 3"})"), "gt_centroid_map\" is not a list of 3 numbers"},
        {withFods(R"({"type": "drill", "gt_centroid_map": [1, 2]})"), "gt_centroid_map\" is not a list of 3 numbers"},
        {withFods(R"({"type": "drill", "gt_centroid_map": [1, 2, null]})"), "not a finite number"},
        {withFods(R"({"type": "drill", "gt_centroid_map": [1, 2, 1e400]})"), "no JSON object"},
        {withFods(R"({"type": "drill", "gt_centroid_map": [1, 2, NaN]})"), "this is no JSON object"},
        {withFods(R"({"type": "drill", "gt_centroid_map": [1, 2, 1e300]})"), "lies beyond 1000 km"},
        {withFods(R"({"type": "drill", "gt_centroid_map": [1, 2, 3], "observed": 1})"), "neither true nor false"},
        {withFods("", R"(, "T_cad_from_map": [1, 2, 3])"), "\"T_cad_from_map\" is not 4 rows of 4 numbers"},
        {withFods("", R"(, "T_cad_from_map": "identity")"), "\"T_cad_from_map\" is not 4 rows of 4 numbers"},
        {withFods("", R"(, "T_cad_from_map": [[2,0,0,0],[0,2,0,0],[0,0,2,0],[0,0,0,1]])"), "not rigid"},
        {withFods("", R"(, "T_cad_from_map": [[-1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]])"), "not rigid"},
        {withFods("", R"(, "T_cad_from_map": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,1,1]])"), "last row"},
        {withFods("", R"(, "T_cad_from_map_initial": [[1,0,0,null],[0,1,0,0],[0,0,1,0],[0,0,0,1]])"),
         "\"T_cad_from_map_initial\" holds an entry that is not a finite number"},
        {withFods("", R"(, "T_cad_from_map": {"x": 1})"), "\"T_cad_from_map.y\" is not a finite number"},
        {withFods("", R"(, "T_cad_from_map": {"x":1,"y":0,"z":0,"qx":0,"qy":0,"qz":0,"qw":0})"), "not of length 1"},
    };
    for (const auto& [json, expected] : cases) {
        truth("a", json);
        EXPECT_THAT(problem(), HasSubstr(expected)) << json;
        EXPECT_THAT(problem(), HasSubstr("a.json")) << json;
    }
}

TEST_F(GroundTruth, SaysWhenThereAreNoTrials) {
    EXPECT_THAT(problem(), HasSubstr("holds no trials"));
    EXPECT_THROW(readTrials(folder_ / "missing"), Error);
}

}  // namespace
}  // namespace fodscope
