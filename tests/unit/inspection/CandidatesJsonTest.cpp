// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/inspection/Inspection.h"
#include "tests/fakes/SampleInspection.h"

namespace fodscope {
namespace {

using Json = nlohmann::json;

DetectionRecord sampleRecord() {
    const DetectionResult result = test::sampleDetection();
    DetectionRecord record;
    record.parameters = presetParameters("paper-physical");
    record.registration = result.registration;
    record.field = result.field;
    record.candidates = result.candidates;
    return record;
}

const SourceFile kReference{"/data/reference.ply", std::string(64, 'a'), 3};
const SourceFile kMap{"maps/map.pcd", std::string(64, 'b'), 99};

TEST(CandidatesJson, HoldsWhatTheFileContractNames) {
    const Json json = Json::parse(candidatesJson(kReference, kMap, sampleRecord()));
    EXPECT_EQ(json.at("schema"), "fodscope.candidates/1");
    EXPECT_EQ(json.at("reference").at("file"), "reference.ply");
    EXPECT_EQ(json.at("map"), Json({{"file", "map.pcd"}, {"points", 99}, {"sha256", std::string(64, 'b')}}));
    EXPECT_EQ(json.at("settings").at("candidates").at("metric"), "mahalanobis");
    EXPECT_EQ(json.at("settings").at("discrepancy").at("voxel_size_m"), 0.02);
    EXPECT_EQ(json.at("T_reference_from_map").size(), 4u);
    EXPECT_EQ(json.at("T_reference_from_map").at(0).at(3), 0.125);
    EXPECT_EQ(json.at("registration").at("converged"), true);
    EXPECT_EQ(json.at("registration").at("rms_m"), 0.0081);
    EXPECT_EQ(json.at("registration").at("overlap"), 0.94);
    EXPECT_EQ(json.at("points_above_threshold"), 4);
    const Json& first = json.at("candidates").at(0);
    EXPECT_EQ(first.at("id"), "C-001");
    EXPECT_EQ(first.at("points"), 2);
    EXPECT_EQ(first.at("centroid_reference"), Json::array({0.01, 0.142857, 0.05}));
    EXPECT_EQ(first.at("centroid_map"), Json::array({0.02, -0.3, 0.04}));
    EXPECT_EQ(first.at("size"), Json::array({0.25, 0.1, 0.0625}));
    EXPECT_EQ(first.at("height_above_floor"), 0.0375);
    EXPECT_EQ(first.at("discrepancy_max"), 3.1);
    EXPECT_EQ(first.at("discrepancy_mean"), 3.05);
}

TEST(CandidatesJson, EqualInputGivesAnEqualTextWhereverItLies) {
    SourceFile moved = kMap;
    moved.path = "/elsewhere/map.pcd";
    EXPECT_EQ(candidatesJson(kReference, kMap, sampleRecord()), candidatesJson(kReference, moved, sampleRecord()));
}

TEST(CandidatesJson, GivenTransformsDidNotConvergeAndBadAlignmentsClaimNothing) {
    DetectionRecord record = sampleRecord();
    record.registration.converged.reset();
    EXPECT_TRUE(Json::parse(candidatesJson(kReference, kMap, record)).at("registration").at("converged").is_null());
    record.candidates.reset();
    record.registration.rms_m = std::nan("");
    const Json json = Json::parse(candidatesJson(kReference, kMap, record));
    EXPECT_EQ(json.at("candidates"), Json::array());
    EXPECT_TRUE(json.at("registration").at("rms_m").is_null());
}

TEST(CandidatesJson, AnAmbiguousAlignmentListsAllPosesAndClaimsNone) {
    DetectionRecord record = sampleRecord();
    record.registration.quality = RegistrationQuality::Ambiguous;
    record.registration.alternatives.push_back({transformFromPose({4.0, 3.0, -2.4}), 0.009, 0.93, 0.86});
    record.candidates.reset();
    const Json json = Json::parse(candidatesJson(kReference, kMap, record));
    EXPECT_TRUE(json.at("T_reference_from_map").is_null());
    EXPECT_EQ(json.at("registration").at("quality"), "ambiguous");
    const Json& poses = json.at("registration").at("alternatives");
    ASSERT_EQ(poses.size(), 2u);
    EXPECT_EQ(poses.at(0).at("T_reference_from_map").at(0).at(3), 0.125);
    EXPECT_EQ(poses.at(1).at("T_reference_from_map").at(0).at(3), 4.0);
    EXPECT_EQ(poses.at(1).at("explained"), 0.86);
    EXPECT_EQ(json.at("registration").at("uncertainty").at("position_std_m"), Json::array({0.002, 0.002236, 0.001}));
}

TEST(CandidatesJson, LastDigitsOfTheComputerDoNotShow) {
    DetectionRecord record = sampleRecord();
    CandidateSet candidates = *record.candidates;
    candidates.candidates[0].centroid_map = {0.1 + 0.2, -1e-12, 1.0 - 1e-15};
    record.candidates = std::make_shared<const CandidateSet>(candidates);
    const std::string text = candidatesJson(kReference, kMap, record);
    EXPECT_EQ(Json::parse(text).at("candidates").at(0).at("centroid_map"), Json::array({0.3, 0.0, 1.0}));
    EXPECT_EQ(text.find("-0.0"), std::string::npos);
}

}  // namespace
}  // namespace fodscope
