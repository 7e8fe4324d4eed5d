// SPDX-License-Identifier: MIT
#pragma once

#include "ui/commands/Command.h"

namespace fodscope {

/// @return the step's name, "Reference"
QString stepName(Step step);

class GoToStepCommand : public Command {
  public:
    GoToStepCommand(CommandContext& context, Step step);
    void run() override;
    bool isAvailable() const override;

  private:
    Step step_;
};

class FitViewsCommand : public Command {
  public:
    explicit FitViewsCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
};

class ToggleThemeCommand : public Command {
  public:
    explicit ToggleThemeCommand(CommandContext& context);
    void run() override;
};

class SettingsCommand : public Command {
  public:
    explicit SettingsCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
    QString obstacle() const override;
};

class ShortcutsCommand : public Command {
  public:
    explicit ShortcutsCommand(CommandContext& context);
    void run() override;
};

class ManualCommand : public Command {
  public:
    explicit ManualCommand(CommandContext& context);
    void run() override;
};

class PaletteCommand : public Command {
  public:
    explicit PaletteCommand(CommandContext& context);
    void run() override;
};

class LeaveCommand : public Command {
  public:
    explicit LeaveCommand(CommandContext& context);
    void run() override;
};

class NextUndecidedCommand : public Command {
  public:
    explicit NextUndecidedCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
};

class LoadLabelSetCommand : public Command {
  public:
    explicit LoadLabelSetCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
};

class IssueReportCommand : public Command {
  public:
    explicit IssueReportCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
};

}  // namespace fodscope
