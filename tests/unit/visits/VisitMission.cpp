// SPDX-License-Identifier: MIT
#include "tests/unit/visits/VisitMission.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <limits>

namespace fodscope::test {
namespace {

constexpr double kTick_s = 0.1;
constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();

}  // namespace

VisitPlan twoWaypoints() {
    VisitPlan plan;
    for (int i = 1; i <= 2; ++i) {
        Waypoint waypoint;
        waypoint.id = "W-0" + std::to_string(i);
        waypoint.candidateIds = {"C-00" + std::to_string(i)};
        waypoint.pose_map = Pose2{3.0 * i, 1.0, 0.5 * i};
        waypoint.status = WaypointStatus::Ok;
        plan.waypoints.push_back(waypoint);
    }
    return plan;
}

VisitMission::VisitMission(Misbehaviour misbehaviour) : robot(misbehaviour) {
    session_ = SessionFile::create(folder_.file("mission.fodscope"), sampleHeader());
    inspection_ = std::make_unique<Inspection>(session_->load(), *session_);
    inspection_->setReference({"reference.ply", std::string(64, 'a'), 3},
                              std::make_shared<const ReferenceMap>(sampleReference()));
    inspection_->setMap({"map.pcd", std::string(64, 'b'), 5});
    inspection_->adoptDetection(presetParameters("paper-physical"), sampleDetection());
    inspection_->adoptPlan(sampleGrid(), twoWaypoints());
    open(inspection_->state());
}

void VisitMission::open(InspectionState state) {
    inspection_ = std::make_unique<Inspection>(std::move(state), *session_);
    inspection_->resumeVisits();
    const InspectionState& opened = inspection_->state();
    runner_ =
        std::make_unique<VisitRunner>(robot, *opened.plan, opened.visits, opened.parameters.visits, photoMarks(opened));
}

bool VisitMission::step(std::size_t lastAct) {
    now_s_ += kTick_s;
    VisitProgress progress = runner_->advance(now_s_, robot.utcAt(now_s_));
    for (Photo& photo : progress.photos) {
        inspection_->addPhoto(std::move(photo));
        if (++acts_ == lastAct) return false;
    }
    for (const Visit& visit : progress.changedVisits) {
        inspection_->updateVisit(visit);
        if (++acts_ == lastAct) return false;
    }
    messages_.insert(messages_.end(), progress.messages.begin(), progress.messages.end());
    return true;
}

void VisitMission::run(double atMost_s) {
    for (const double end_s = now_s_ + atMost_s; now_s_ < end_s;) {
        step(kNever);
        if (runner_->state() == RunnerState::Paused || runner_->state() == RunnerState::Finished) return;
    }
}

bool VisitMission::dieAfter(std::size_t acts) {
    bool died = false;
    while (!died && runner_->state() == RunnerState::Running)
        died = !step(acts);
    runner_.reset();
    inspection_.reset();
    session_.reset();
    return died;
}

void VisitMission::pass(double duration_s) {
    for (const double end_s = now_s_ + duration_s; now_s_ < end_s; now_s_ += kTick_s)
        robot.poll(now_s_);
}

void VisitMission::reopen() {
    session_ = SessionFile::open(folder_.file("mission.fodscope"));
    open(session_->load());
}

std::string VisitMission::stepsOf(const std::string& waypointId) {
    runner_.reset();
    const InspectionState expected = inspection_->state();
    inspection_.reset();
    const SessionVerification verification = session_->verify();
    EXPECT_TRUE(verification.intact) << verification.problem;
    session_.reset();
    std::string steps;
    {
        SQLite::Database database(folder_.file("mission.fodscope").string());
        SQLite::Statement query(database,
                                "SELECT state, reason, time_utc FROM visits JOIN acts ON sequence = act "
                                "WHERE kind = 'visit' AND waypoint_id = ? ORDER BY sequence");
        query.bind(1, waypointId);
        while (query.executeStep()) {
            const std::string reason = query.getColumn(1).getString();
            steps += (steps.empty() ? "" : ", ") + query.getColumn(0).getString();
            if (!reason.empty()) steps += " (" + reason + ")";
            EXPECT_EQ(query.getColumn(2).getString().size(), 24U) << "each step has its time";
        }
    }
    session_ = SessionFile::open(folder_.file("mission.fodscope"));
    InspectionState state = session_->load();
    EXPECT_EQ(state.visits, expected.visits);
    EXPECT_EQ(state.photos.size(), expected.photos.size());
    inspection_ = std::make_unique<Inspection>(std::move(state), *session_);
    return steps;
}

}  // namespace fodscope::test
