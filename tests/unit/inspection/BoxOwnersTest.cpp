// SPDX-License-Identifier: MIT
#include "core/inspection/BoxOwners.h"

#include <gtest/gtest.h>

namespace fodscope {
namespace {

/// A photo from the origin along z (map and reference are the same here), taken for C-001, which lies 1 m ahead and
/// shows at (320, 240). C-002 lies behind and beside it at (420, 240), C-003 right behind C-002.
class BoxOwners : public testing::Test {
  protected:
    BoxOwners() {
        state_.labelSet = parseLabelSet("{name: tools, labels: [{name: drill}, {name: sander}]}", "test");
        auto field = std::make_shared<DiscrepancyField>();
        field->points = {{0.0, 0.0, 1.0}, {0.6, 0.0, 3.0}, {0.8, 0.0, 4.0}};
        auto set = std::make_shared<CandidateSet>();
        for (std::uint32_t i = 0; i < 3; ++i) {
            Candidate candidate;
            candidate.id = "C-00" + std::to_string(i + 1);
            candidate.voxels = {i};
            set->candidates.push_back(candidate);
        }
        DetectionRecord detection;
        detection.field = field;
        detection.candidates = set;
        state_.detection = detection;
        Photo photo;
        photo.id = "P-001";
        photo.candidateIds = {"C-001"};
        photo.intrinsics = {640, 480, 500.0, 500.0, 320.0, 240.0};
        state_.photos = {photo};
    }

    void decide(const std::string& label, std::optional<PixelBox> box, const std::string& reader = "Anna") {
        Decision decision;
        decision.photoId = "P-001";
        decision.labeller = reader;
        decision.labels = {{label, box}};
        state_.decisions.push_back(decision);
    }

    Verdict verdict(int number) const { return verdictsOf(state_)[static_cast<std::size_t>(number - 1)].verdict; }

    static constexpr PixelBox kOnFirst{300, 220, 40, 40};
    static constexpr PixelBox kOnSecond{410, 230, 20, 20};
    static constexpr PixelBox kOnAll{300, 220, 150, 40};
    static constexpr PixelBox kOnNone{10, 10, 40, 40};
    InspectionState state_;
};

TEST_F(BoxOwners, AToolInTheBackgroundIsAFindingThereAndNotWhereThePhotoWasAimed) {
    decide("drill", kOnSecond);
    EXPECT_EQ(verdict(1), Verdict::NoFod);
    EXPECT_EQ(verdict(2), Verdict::Finding);
    EXPECT_EQ(verdictsOf(state_)[1].fodLabels, std::vector<std::string>{"drill"});
    EXPECT_EQ(verdict(3), Verdict::NotPhotographed) << "it lies behind the nearest candidate that the box meets";
}

TEST_F(BoxOwners, ABoxOnTheCandidateOfThePhotoIsAboutItAlone) {
    decide("sander", kOnAll);
    EXPECT_EQ(verdict(1), Verdict::Finding);
    EXPECT_EQ(verdict(2), Verdict::NotPhotographed);
}

TEST_F(BoxOwners, ABoxThatMeetsNothingStaysWithThePhotosCandidate) {
    decide("sander", kOnNone);
    EXPECT_EQ(verdict(1), Verdict::Finding);
}

TEST_F(BoxOwners, ALabelWithoutABoxIsAboutThePhotosCandidate) {
    decide("sander", std::nullopt);
    EXPECT_EQ(verdict(1), Verdict::Finding);
    EXPECT_EQ(verdict(2), Verdict::NotPhotographed);
}

TEST_F(BoxOwners, ACorrectionTakesTheEarlierWordOnABackgroundToolBack) {
    decide("drill", kOnSecond);
    decide(kNoFod, std::nullopt);
    EXPECT_EQ(verdict(1), Verdict::NoFod);
    EXPECT_EQ(verdict(2), Verdict::NotPhotographed);
}

TEST_F(BoxOwners, ReadersWhoSeeDifferentToolsAtTheSamePlaceLeaveItOpen) {
    decide("drill", kOnFirst, "Anna");
    decide("sander", kOnFirst, "Ben");
    EXPECT_EQ(verdict(1), Verdict::Open);
}

TEST_F(BoxOwners, ABoxRoundOneOfTwoNeighboursIsNotAboutTheOther) {
    // Squares of 100 pixels side by side, both subjects of the photo.
    auto field = std::make_shared<DiscrepancyField>();
    field->points = {{0.0, 0.0, 1.0}, {0.22, 0.0, 1.0}};
    state_.detection->field = field;
    state_.detection->parameters.discrepancy.voxelSize_m = 0.2;
    auto set = std::make_shared<CandidateSet>(*state_.detection->candidates);
    set->candidates.resize(2);
    state_.detection->candidates = set;
    state_.photos[0].candidateIds = {"C-001", "C-002"};
    decide("drill", PixelBox{260, 180, 125, 120});
    EXPECT_EQ(verdict(1), Verdict::Finding);
    EXPECT_EQ(verdict(2), Verdict::NoFod);
    decide("drill", PixelBox{260, 180, 240, 120});
    EXPECT_EQ(verdict(2), Verdict::Finding) << "it is about both when it goes round both";
}

TEST_F(BoxOwners, ACandidateShownInPartsIsClearedOnAllOfThemAndNotOnOne) {
    auto field = std::make_shared<DiscrepancyField>();
    for (int i = 0; i < 20; ++i)
        field->points.push_back({0.1 * i, 0.0, 1.0});
    state_.detection->field = field;
    auto set = std::make_shared<CandidateSet>();
    set->candidates.resize(1);
    set->candidates[0].id = "C-001";
    for (std::uint32_t i = 0; i < 20; ++i)
        set->candidates[0].voxels.push_back(i);
    state_.detection->candidates = set;
    VisitPlan plan;
    for (const char* id : {"W-01", "W-02"})
        plan.waypoints.push_back({id, {"C-001"}, Pose2{}, 0.0, WaypointStatus::Ok, {}});
    plan.views = {{"C-001", 1.0, WaypointStatus::Ok}};
    state_.plan = plan;
    // The photo of the first shows 13 of the 20; that of the second, 1.3 m to the right, the others.
    state_.photos[0].intrinsics.cx_px = 5.0;
    decide(kNoFod, std::nullopt);
    EXPECT_EQ(verdict(1), Verdict::NotPhotographed) << "a third of it was never looked at";
    Photo second = state_.photos[0];
    second.id = "P-002";
    second.T_map_from_camera.translation().x() = 1.3;
    state_.photos.push_back(second);
    EXPECT_EQ(verdict(1), Verdict::Undecided);
    decide(kNoFod, std::nullopt);
    state_.decisions.back().photoId = "P-002";
    EXPECT_EQ(verdict(1), Verdict::NoFod);
    decide("drill", std::nullopt);
    EXPECT_EQ(verdict(1), Verdict::Finding);
}

TEST_F(BoxOwners, ACameraThatLookedPastTheCandidateDoesNotClearIt) {
    auto field = std::make_shared<DiscrepancyField>(*state_.detection->field);
    field->points[0] = {0.0, -0.9, 1.0};  // 450 pixels above the middle of a picture that ends at 240
    state_.detection->field = field;
    decide(kNoFod, std::nullopt);
    EXPECT_EQ(verdict(1), Verdict::NotPhotographed);
    decide("drill", std::nullopt);
    EXPECT_EQ(verdict(1), Verdict::Finding) << "what a reader named is never dropped";
}

}  // namespace
}  // namespace fodscope
