// SPDX-License-Identifier: MIT
#include "core/planning/PlannedStops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/common/Error.h"
#include "tests/fakes/PictureGrid.h"

namespace fodscope {
namespace {

class PlannedStops : public testing::Test {
  protected:
    PlannedStops() : collision_(inflate(walledRoom(120, 80), {})), sight_(collision_) {
        floodFill(collision_, robot_);
        for (const auto& [id, x] : {std::pair{"A", 1.5}, {"B", 3.0}, {"C", 4.5}})
            targets_.push_back({id, {x, 2.0, 0.05}, {0.1, 0.1, 0.1}, 0.0, {}, 0.02});
        before_ = planVisits(targets_, collision_, sight_, robot_, {}, {}, progress_);
    }

    VisitPlan changed(const std::vector<PlannedStop>& stops) {
        return planOfStops(stops, targets_, collision_, sight_, before_, {}, {}, progress_);
    }

    Pose2 robot_{0.6, 2.0, 0.0};
    CostMap collision_;
    CostMap sight_;
    std::vector<PlanTarget> targets_;
    Progress progress_;
    VisitPlan before_;
};

TEST_F(PlannedStops, unchangedTheyAreThePlan) {
    const VisitPlan plan = changed(stopsOf(before_));
    ASSERT_EQ(plan.waypoints.size(), before_.waypoints.size());
    EXPECT_NEAR(plan.length_m, before_.length_m, 1e-9);
    EXPECT_EQ(plan.views, before_.views);
    for (std::size_t i = 0; i < plan.waypoints.size(); ++i) {
        EXPECT_EQ(plan.waypoints[i].id, before_.waypoints[i].id);
        EXPECT_EQ(plan.waypoints[i].candidateIds, before_.waypoints[i].candidateIds);
        EXPECT_EQ(plan.waypoints[i].pose_map, before_.waypoints[i].pose_map);
    }
}

TEST_F(PlannedStops, areDrivenInTheOperatorsOrder) {
    std::vector<PlannedStop> stops = stopsOf(before_);
    ASSERT_GE(stops.size(), 2U);
    std::ranges::reverse(stops);
    const VisitPlan plan = changed(stops);
    EXPECT_EQ(plan.waypoints.front().pose_map, before_.waypoints.back().pose_map);
    EXPECT_EQ(plan.waypoints.front().id, "W-01");
    EXPECT_GT(plan.length_m, before_.length_m);
    EXPECT_NEAR(*plan.shortestTourLength_m, *before_.shortestTourLength_m, 1e-9);
}

TEST_F(PlannedStops, whatNoneOfThemShowsIsListedAsLeftOut) {
    std::vector<PlannedStop> stops = stopsOf(before_);
    const std::vector<std::string> lost = stops.back().candidateIds;
    stops.pop_back();
    const VisitPlan plan = changed(stops);
    for (const std::string& id : lost) {
        const auto view = std::ranges::find(plan.views, id, &CandidateView::candidateId);
        EXPECT_EQ(view->share, 0.0);
        EXPECT_EQ(view->rest, WaypointStatus::LeftOut);
        EXPECT_TRUE(std::ranges::any_of(plan.waypoints, [&](const Waypoint& waypoint) {
            return !waypoint.pose_map && waypoint.candidateIds == std::vector<std::string>{id};
        }));
    }
}

TEST_F(PlannedStops, aNewOneIsTakenForWhatItsPictureShows) {
    const VisitPlan plan = changed({{{3.0, 1.2, 1.5707963267948966}, {}}});
    EXPECT_EQ(plan.waypoints[0].candidateIds, std::vector<std::string>{"B"});
    EXPECT_EQ(plan.views[1].share, 1.0);
    EXPECT_EQ(plan.views[0].rest, WaypointStatus::LeftOut);
    const VisitPlan away = changed({{{3.0, 1.2, -1.5707963267948966}, {}}});
    EXPECT_TRUE(away.waypoints[0].candidateIds.empty()) << "it looks the other way";
}

TEST_F(PlannedStops, areRefusedWhereTheRobotCannotStand) {
    EXPECT_THROW(changed({{{-1.0, 2.0, 0.0}, {}}}), Error);
    EXPECT_THROW(changed({{{3.0, 0.1, 0.0}, {}}}), Error);
    progress_.cancel();
    EXPECT_THROW(changed(stopsOf(before_)), Cancelled);
}

}  // namespace
}  // namespace fodscope
