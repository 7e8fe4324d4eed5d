// SPDX-License-Identifier: MIT
#pragma once

#include "ui/commands/Command.h"

namespace fodscope {

/// Goes through the candidates in their order, round and round.
class NeighbourCandidateCommand : public Command {
  public:
    /// @param step +1 next, −1 previous
    NeighbourCandidateCommand(CommandContext& context, int step);
    void run() override;
    bool isAvailable() const override;

  private:
    int step_;
};

class FlyToCandidateCommand : public Command {
  public:
    explicit FlyToCandidateCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
};

/// Moves the threshold by a step of its slider.
class StepThresholdCommand : public Command {
  public:
    StepThresholdCommand(CommandContext& context, int step, bool coarse);
    void run() override;
    bool isAvailable() const override;

  private:
    int step_;
    bool coarse_;
};

class UseMetricCommand : public Command {
  public:
    UseMetricCommand(CommandContext& context, Metric metric);
    void run() override;
    bool isAvailable() const override;
    void refresh() override;

  private:
    Metric metric_;
};

/// Candidates back to the paper's values for the metric in use.
class PaperSettingsCommand : public Command {
  public:
    explicit PaperSettingsCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
};

class TuningCommand : public Command {
  public:
    explicit TuningCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
    QString obstacle() const override;
};

}  // namespace fodscope
