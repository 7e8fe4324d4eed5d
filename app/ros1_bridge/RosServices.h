// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/bridge/BridgeProtocol.h"

namespace fodscope::bridge {

/// Calls services of the robot, each in a thread of its own: a service that hangs is only one that has not answered.
class ServiceCaller {
  public:
    ServiceCaller();
    ~ServiceCaller();

    /// @param service "publish_map", or one of those without arguments
    /// @param name the robot's name for it
    void call(const std::string& service, const std::string& name);
    std::vector<ServiceAnswered> takeAnswers();

    static std::map<std::string, std::string> usedTypes();

  private:
    struct Answers;
    std::shared_ptr<Answers> answers_;
};

}  // namespace fodscope::bridge
