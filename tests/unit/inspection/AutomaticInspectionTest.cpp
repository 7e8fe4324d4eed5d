// SPDX-License-Identifier: MIT
#include "core/inspection/AutomaticInspection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/simulation/SimulatedRobot.h"
#include "tests/fakes/MemoryJournal.h"
#include "tests/fakes/ScriptedRobotLink.h"
#include "tests/unit/simulation/SmallWorlds.h"

namespace fodscope {
namespace {

constexpr double kResolution_m = 0.05;

/// The floor of the room of 3 × 2 m with its walls.
OccupancyGrid roomGrid() {
    OccupancyGrid grid;
    grid.width = 62;
    grid.height = 42;
    grid.resolution_m = kResolution_m;
    grid.origin_map = {-kResolution_m, -kResolution_m, 0.0};
    for (int row = 0; row < grid.height; ++row) {
        for (int column = 0; column < grid.width; ++column) {
            const bool wall = row == 0 || column == 0 || row == grid.height - 1 || column == grid.width - 1;
            grid.cells.push_back(wall ? Cell::Occupied : Cell::Free);
        }
    }
    return grid;
}

/// Candidates at two places; only the first has something there.
DetectionResult detectionAt(const std::vector<Eigen::Vector3d>& places) {
    auto field = std::make_shared<DiscrepancyField>();
    auto set = std::make_shared<CandidateSet>();
    for (const Eigen::Vector3d& place : places) {
        Candidate candidate;
        candidate.voxels = {static_cast<std::uint32_t>(field->points.size())};
        candidate.centroid_reference = candidate.centroid_map = place;
        candidate.size_m = Eigen::Vector3d::Constant(0.1);
        set->candidateOfVoxel.push_back(static_cast<std::int32_t>(set->candidates.size()));
        set->candidates.push_back(candidate);
        field->points.push_back(place);
        field->weights.push_back(1);
        field->nearest.push_back(0);
        field->euclidean_m.push_back(0.1);
        field->smoothedEuclidean_m.push_back(0.1);
    }
    set->pointsAboveThreshold = places.size();
    DetectionResult result;
    result.registration.quality = RegistrationQuality::Given;
    result.field = field;
    result.candidates = set;
    result.coverage = std::make_shared<Coverage>();
    return result;
}

class Automatic : public ::testing::Test {
  protected:
    Automatic() {
        World room = test::room();
        room.robotStart_world = {1.5, 1.0, 0.0};
        room.objects = {test::boxObject({0.45, 0.45, 0.0}, {0.55, 0.55, 0.1})};
        room.objects[0].type = "hammer";
        world_ = std::make_shared<const World>(room);
        auto reference = std::make_shared<ReferenceMap>();
        reference->points = {{0, 0, 0}, {1, 1, 0}};
        input_.referenceSource = {"reference.ply", "aa", 2};
        input_.reference = reference;
        input_.mapSource = {"map.pcd", "bb", 2};
        input_.parameters.candidates = paperPhysicalCandidateSettings(Metric::Euclidean);
        input_.detection = detectionAt({{0.5, 0.5, 0.05}, {2.5, 1.5, 0.05}});
        input_.grid_map = roomGrid();
        input_.robotStart_map = {1.5, 1.0, 0.0};
        input_.labelSet = parseLabelSet("{name: tools, labels: [{name: hammer}]}", "test");
        truth_ = std::make_shared<GroundTruthLabeller>(world_, false);
        labeller_ = {truth_->name(), [this](const Photo& photo) { return truth_->answer(photo, input_.labelSet); }};
    }

    std::unique_ptr<RobotLink> simulatedRobot() const {
        SimulatedRobotSettings settings;
        settings.waitForRendering = true;
        settings.camera.width_px = 320;
        settings.camera.height_px = 180;
        return makeSimulatedRobot(world_, input_.grid_map, nullptr, input_.parameters.costMap, settings);
    }

    std::shared_ptr<const World> world_;
    AutomaticInspectionInput input_;
    std::shared_ptr<GroundTruthLabeller> truth_;
    AutomaticLabeller labeller_;
    test::MemoryJournal journal_;
    Progress progress_;
};

TEST_F(Automatic, EveryCandidateIsVisitedPhotographedAndLabelled) {
    Inspection inspection({}, journal_);
    inspectAutomatically(input_, *simulatedRobot(), labeller_, inspection, progress_);
    const InspectionState& state = inspection.state();
    EXPECT_EQ(state.photos.size(), 2U);
    for (const Visit& visit : state.visits)
        EXPECT_EQ(visit.state, VisitState::Done) << reasonText(visit);
    const std::vector<CandidateVerdict> verdicts = verdictsOf(state);
    ASSERT_EQ(verdicts.size(), 2U);
    EXPECT_EQ(verdicts[0].verdict, Verdict::Finding);
    EXPECT_EQ(verdicts[0].fodLabels, std::vector<std::string>{"hammer"});
    EXPECT_EQ(verdicts[1].verdict, Verdict::NoFod);
    for (const Decision& decision : state.decisions)
        EXPECT_EQ(decision.labeller, "world's ground truth");
}

TEST_F(Automatic, WithoutCandidatesNothingIsDriven) {
    input_.detection = detectionAt({});
    Inspection inspection({}, journal_);
    ScriptedRobotLink robot;
    inspectAutomatically(input_, robot, labeller_, inspection, progress_);
    EXPECT_TRUE(robot.goals.empty());
    EXPECT_TRUE(inspection.state().detection.has_value());
}

TEST_F(Automatic, PhotosWithoutAnAnswerStayUndecided) {
    labeller_.answer = [](const Photo&) { return PhotoAnswer(); };
    Inspection inspection({}, journal_);
    inspectAutomatically(input_, *simulatedRobot(), labeller_, inspection, progress_);
    EXPECT_TRUE(inspection.state().decisions.empty());
    EXPECT_EQ(verdictsOf(inspection.state())[0].verdict, Verdict::Undecided);
}

TEST_F(Automatic, ARobotThatNeverAnswersEndsInFailedVisitsNotInAnEndlessWait) {
    Inspection inspection({}, journal_);
    ScriptedRobotLink robot;
    robot.report(LinkState::Connected);
    inspectAutomatically(input_, robot, labeller_, inspection, progress_);
    EXPECT_TRUE(inspection.state().photos.empty());
    for (const Visit& visit : inspection.state().visits)
        EXPECT_EQ(visit.state, VisitState::Failed);
}

TEST_F(Automatic, CancellingStopsTheRobot) {
    Inspection inspection({}, journal_);
    ScriptedRobotLink robot;
    Progress* running = nullptr;
    Progress progress([&](const std::string& stage, double) {
        if (stage == "photographing the candidates") running->cancel();
    });
    running = &progress;
    EXPECT_THROW(inspectAutomatically(input_, robot, labeller_, inspection, progress), Cancelled);
    EXPECT_GE(robot.cancels, 1);
}

TEST_F(Automatic, CancellingDoesNotWaitForThePhotoUnderWay) {
    Inspection inspection({}, journal_);
    SimulatedRobotSettings settings;
    settings.waitForRendering = true;
    settings.isWaitOver = [this] {
        progress_.cancel();
        return true;
    };
    const auto robot = makeSimulatedRobot(world_, input_.grid_map, nullptr, input_.parameters.costMap, settings);
    EXPECT_THROW(inspectAutomatically(input_, *robot, labeller_, inspection, progress_), Cancelled);
    EXPECT_TRUE(inspection.state().photos.empty());
    for (const Visit& visit : inspection.state().visits)
        EXPECT_NE(visit.state, VisitState::Done);
}

TEST_F(Automatic, AFullDiskEndsTheInspectionWithItsReason) {
    Inspection inspection({}, journal_);
    journal_.diskIsFull = true;
    EXPECT_THROW(inspectAutomatically(input_, *simulatedRobot(), labeller_, inspection, progress_), Error);
}

}  // namespace
}  // namespace fodscope
