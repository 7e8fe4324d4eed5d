// SPDX-License-Identifier: MIT
#pragma once

#include "ui/commands/Command.h"

namespace fodscope {

class NewInspectionCommand : public Command {
  public:
    explicit NewInspectionCommand(CommandContext& context);
    void run() override;
};

class OpenSessionCommand : public Command {
  public:
    explicit OpenSessionCommand(CommandContext& context);
    void run() override;
};

class BuiltinTankCommand : public Command {
  public:
    explicit BuiltinTankCommand(CommandContext& context);
    void run() override;
};

class CloseInspectionCommand : public Command {
  public:
    explicit CloseInspectionCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
};

class QuitCommand : public Command {
  public:
    explicit QuitCommand(CommandContext& context);
    void run() override;
};

class UndoCommand : public Command {
  public:
    explicit UndoCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
    void refresh() override;
};

class RedoCommand : public Command {
  public:
    explicit RedoCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
    void refresh() override;
};

class CancelTaskCommand : public Command {
  public:
    explicit CancelTaskCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
};

}  // namespace fodscope
