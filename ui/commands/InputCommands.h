// SPDX-License-Identifier: MIT
#pragma once

#include "ui/commands/Command.h"

namespace fodscope {

/// Commands that bring a reference or a map into the open inspection; available while candidates may still change.
class InputCommand : public Command {
  public:
    using Command::Command;
    bool isAvailable() const override { return controller().isOpen() && !controller().candidatesAreFrozen(); }
    QString obstacle() const override;
};

class LoadMeshCommand : public InputCommand {
  public:
    explicit LoadMeshCommand(CommandContext& context);
    void run() override;
};

/// A mesh for the points, and nominal maps for their covariances.
class LoadMeshAndMapsCommand : public InputCommand {
  public:
    explicit LoadMeshAndMapsCommand(CommandContext& context);
    void run() override;
};

class RemakeReferenceCommand : public InputCommand {
  public:
    explicit RemakeReferenceCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
    QString obstacle() const override;
};

class LoadReferenceCommand : public InputCommand {
  public:
    explicit LoadReferenceCommand(CommandContext& context);
    void run() override;
};

class LoadNominalMapsCommand : public InputCommand {
  public:
    explicit LoadNominalMapsCommand(CommandContext& context);
    void run() override;
};

class LoadMapCommand : public InputCommand {
  public:
    explicit LoadMapCommand(CommandContext& context);
    void run() override;
};

class LoadTransformCommand : public InputCommand {
  public:
    explicit LoadTransformCommand(CommandContext& context);
    void run() override;
};

class ForgetTransformCommand : public InputCommand {
  public:
    explicit ForgetTransformCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
};

class StartPoseCommand : public InputCommand {
  public:
    explicit StartPoseCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
    QString obstacle() const override;
};

/// Colours the reference by how far off the map has each of its regions.
class ResidualsCommand : public Command {
  public:
    explicit ResidualsCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
    QString obstacle() const override;
    void refresh() override;
};

class DetectCommand : public InputCommand {
  public:
    explicit DetectCommand(CommandContext& context);
    void run() override;
};

class HeatMapCommand : public Command {
  public:
    explicit HeatMapCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
    QString obstacle() const override;
    void refresh() override;
};

}  // namespace fodscope
