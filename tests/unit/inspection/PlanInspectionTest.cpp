// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/common/Error.h"
#include "core/inspection/Inspection.h"

namespace fodscope {
namespace {

/// A room of 4 × 4 m with walls, and a discrepant voxel in its middle, seen in a map that lies 1 m off in x.
InspectionState roomWithOneCandidate() {
    auto field = std::make_shared<DiscrepancyField>();
    field->points = {{1.0, 0.0, 0.1}, {2.5, 1.0, 0.1}};
    field->weights = {1, 1};
    field->nearest = {0, 0};
    field->euclidean_m = {0.2, 0.0};
    field->smoothedEuclidean_m = {0.2, 0.0};
    auto candidates = std::make_shared<CandidateSet>();
    Candidate candidate;
    candidate.id = "C-001";
    candidate.voxels = {0};
    candidate.centroid_reference = {1.0, 0.0, 0.1};
    candidate.centroid_map = {0.0, 0.0, 0.1};
    candidate.size_m = {0.02, 0.02, 0.02};
    candidates->candidates = {candidate};
    candidates->candidateOfVoxel = {0, -1};
    candidates->pointsAboveThreshold = 1;
    DetectionRecord detection;
    detection.parameters.candidates = paperPhysicalCandidateSettings(Metric::Euclidean);
    detection.registration.T_reference_from_map = transformFromPose({1.0, 0.0, 0.0});
    detection.registration.quality = RegistrationQuality::Good;
    detection.field = field;
    detection.candidates = candidates;
    InspectionState state;
    applyDetection(state, detection, 1);
    return state;
}

/// Walls round the room, and an obstacle where the candidate lies.
OccupancyGrid roomGrid() {
    OccupancyGrid grid;
    grid.width = 80;
    grid.height = 80;
    grid.resolution_m = 0.05;
    grid.origin_map = {-2.0, -2.0, 0.0};
    for (int row = 0; row < grid.height; ++row) {
        for (int column = 0; column < grid.width; ++column) {
            const bool wall = row == 0 || column == 0 || row == grid.height - 1 || column == grid.width - 1;
            grid.cells.push_back(wall ? Cell::Occupied : Cell::Free);
        }
    }
    grid.cells[grid.offset({40, 40})] = Cell::Occupied;
    return grid;
}

TEST(PlanInspection, ACandidateThatIsAnObstacleItselfIsStillSeen) {
    Progress progress;
    const VisitPlan plan = planInspection(roomWithOneCandidate(), roomGrid(), {-1.0, -1.0, 0.0}, progress);
    ASSERT_EQ(plan.waypoints.size(), 1u);
    const Waypoint& waypoint = plan.waypoints[0];
    EXPECT_EQ(waypoint.candidateIds, (std::vector<std::string>{"C-001"}));
    ASSERT_TRUE(waypoint.pose_map.has_value()) << toString(waypoint.status);
    const double distance_m = std::hypot(waypoint.pose_map->x_m, waypoint.pose_map->y_m);
    EXPECT_GE(distance_m, 0.5 - 1e-9);
    EXPECT_LE(distance_m, 0.75 + 1e-9);
    const double towards_rad = std::atan2(-waypoint.pose_map->y_m, -waypoint.pose_map->x_m);
    EXPECT_NEAR(wrapAngle(waypoint.pose_map->yaw_rad - towards_rad), 0.0, 1e-6);
}

TEST(PlanInspection, NeedsCandidatesAndCanBeCancelled) {
    Progress progress;
    EXPECT_THROW(planInspection(InspectionState(), roomGrid(), {}, progress), Error);
    progress.cancel();
    EXPECT_THROW(planInspection(roomWithOneCandidate(), roomGrid(), {-1.0, -1.0, 0.0}, progress), Cancelled);
}

TEST(PlanInspection, TargetsAreTheCandidatesInTheMapFrame) {
    const auto targets = planTargets(*roomWithOneCandidate().detection);
    ASSERT_EQ(targets.size(), 1u);
    EXPECT_EQ(targets[0].candidateId, "C-001");
    EXPECT_EQ(targets[0].centroid_map, Eigen::Vector3d(0.0, 0.0, 0.1));
}

}  // namespace
}  // namespace fodscope
