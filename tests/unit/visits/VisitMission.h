// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/inspection/Inspection.h"
#include "core/robot/VisitRunner.h"
#include "storage/SessionFile.h"
#include "tests/fakes/MisbehavingRobot.h"
#include "tests/fakes/SampleInspection.h"

namespace fodscope::test {

/// A robot, a session file with a plan of two waypoints, and the program between them, by a clock of its own.
class VisitMission {
  public:
    explicit VisitMission(Misbehaviour misbehaviour);

    void start() { runner_->start(); }
    /// Runs until the runner holds or has finished, at most this long.
    void run(double atMost_s = 1000.0);
    /// Runs until so many visits and photos are on record, and there the program dies: whatever it had not yet
    /// recorded, sent or handed over is gone.
    /// @return whether it came so far
    bool dieAfter(std::size_t acts);
    /// Time passes while no program is there; the robot goes on, and what it says is lost.
    void pass(double duration_s);
    /// Another program opens the session file.
    void reopen();

    VisitRunner& runner() { return *runner_; }
    const InspectionState& state() const { return inspection_->state(); }
    const Visit& visit(const std::string& waypointId) const { return *findVisit(state(), waypointId); }
    const std::vector<std::string>& messages() const { return messages_; }

    /// What the session file says of a visit, read back by SQL after it was closed and found intact: "sent, accepted,
    /// driving, draft (aborted), sent, …".
    std::string stepsOf(const std::string& waypointId);

    MisbehavingRobot robot;

  private:
    void open(InspectionState state);
    /// @return false when the program died in it
    bool step(std::size_t lastAct);

    TemporaryFolder folder_;
    std::unique_ptr<SessionFile> session_;
    std::unique_ptr<Inspection> inspection_;
    std::unique_ptr<VisitRunner> runner_;
    std::vector<std::string> messages_;
    std::size_t acts_ = 0;
    double now_s_ = 0.0;
};

/// W-01 and W-02, three metres apart, for the candidates of the sample.
VisitPlan twoWaypoints();

}  // namespace fodscope::test
