// SPDX-License-Identifier: MIT
#include "tests/ros/bridge/BridgeCase.h"

namespace fodscope {

std::unique_ptr<RosCore> BridgeCase::core_;
std::unique_ptr<Program> BridgeCase::robot_;

}  // namespace fodscope
