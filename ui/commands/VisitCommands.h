// SPDX-License-Identifier: MIT
#pragma once

#include "ui/commands/Command.h"

namespace fodscope {

class LoadGridCommand : public Command {
  public:
    explicit LoadGridCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
};

class ConnectWorldRobotCommand : public Command {
  public:
    explicit ConnectWorldRobotCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
};

class ConnectBuiltinRobotCommand : public Command {
  public:
    explicit ConnectBuiltinRobotCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
};

class PlanVisitsCommand : public Command {
  public:
    explicit PlanVisitsCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
};

/// Visits the selected waypoint one place earlier or later.
class ShiftWaypointCommand : public Command {
  public:
    ShiftWaypointCommand(CommandContext& context, int step);
    void run() override;
    bool isAvailable() const override;

  private:
    int step_;
};

/// Takes the selected waypoint out of the plan.
class RemoveWaypointCommand : public Command {
  public:
    explicit RemoveWaypointCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
};

/// Starts the visits, or goes on with the next one after a pause or a stop.
class StartVisitsCommand : public Command {
  public:
    explicit StartVisitsCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
    void refresh() override;
};

class PauseVisitsCommand : public Command {
  public:
    explicit PauseVisitsCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
};

/// One key for both: pause while it runs, else go on.
class TogglePauseCommand : public Command {
  public:
    explicit TogglePauseCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
};

class SkipVisitCommand : public Command {
  public:
    explicit SkipVisitCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
};

/// Drives again to the waypoint that photographs the selected candidate.
class RetryVisitCommand : public Command {
  public:
    explicit RetryVisitCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;

  private:
    const Visit* chosenVisit() const;
};

class StopCommand : public Command {
  public:
    explicit StopCommand(CommandContext& context);
    void run() override;
};

}  // namespace fodscope
