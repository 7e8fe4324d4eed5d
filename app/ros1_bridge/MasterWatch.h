// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/bridge/BridgeProtocol.h"

namespace fodscope::bridge {

struct MasterSighting {
    bool answers = false;
    /// Another process id means that the master was restarted and has forgotten everybody.
    int processId = 0;
    /// Those that somebody publishes.
    std::vector<Topic> topics;
};

/// Asks for the master once a second, in a thread of its own: a call to a master that is gone can block for minutes.
class MasterWatch {
  public:
    MasterWatch();
    /// Does not wait for a call under way.
    ~MasterWatch();

    /// @return the newest sighting since the last call
    std::optional<MasterSighting> take();

  private:
    struct Shared;
    std::shared_ptr<Shared> shared_;
};

}  // namespace fodscope::bridge
