// SPDX-License-Identifier: MIT
#pragma once

#include "ui/commands/Command.h"

namespace fodscope {

class LoadRouteCommand : public Command {
  public:
    explicit LoadRouteCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
};

class SaveRouteCommand : public Command {
  public:
    explicit SaveRouteCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
};

class ConnectMappingRobotCommand : public Command {
  public:
    explicit ConnectMappingRobotCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
};

/// Drives the route, or goes on with it, and then fetches the map.
class DriveRouteCommand : public Command {
  public:
    explicit DriveRouteCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
    QString obstacle() const override;
    void refresh() override;

  private:
    bool isDriven() const;
};

class FetchMapCommand : public Command {
  public:
    explicit FetchMapCommand(CommandContext& context);
    void run() override;
    bool isAvailable() const override;
};

}  // namespace fodscope
