// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/bridge/BridgeProtocol.h"

namespace fodscope::bridge {

struct SupervisorSettings {
    std::filesystem::path program;
    Configure configuration;
    /// A bridge that says nothing for this long hangs and is replaced.
    double silentAfter_s = 5.0;
    /// Before a bridge that ended is started again; doubles each time, up to the greatest.
    double firstPause_s = 0.25;
    double greatestPause_s = 8.0;
};

/// Keeps a bridge running and talks to it, in a thread of its own: nothing here ever blocks the caller.
class BridgeSupervisor {
  public:
    using Clock = std::chrono::steady_clock;

    /// Something that happened: an event, or the end of a bridge.
    struct Arrival {
        std::optional<Event> event;
        /// Why the bridge is gone, in one sentence; else empty.
        std::string trouble;
        Clock::time_point when;
    };

    explicit BridgeSupervisor(SupervisorSettings settings);
    ~BridgeSupervisor();

    /// Goes to the bridge that runs; nothing is kept for a later one, since who asked has been told that it is gone.
    void send(Request request);
    std::vector<Arrival> take();
    /// Of the bridge that runs; 0: none does.
    pid_t processId() const;

  private:
    class Conversation;

    void run();
    /// @return why it ended; empty when it was told to
    std::string superviseOne();
    void tell(Arrival arrival);
    bool isOver() const;
    void pause(double time_s);

    SupervisorSettings settings_;
    mutable std::mutex mutex_;
    std::condition_variable over_;
    bool isOver_ = false;
    bool isHopeless_ = false;
    pid_t processId_ = 0;
    int wake_ = -1;
    std::deque<Request> outgoing_;
    std::vector<Arrival> arrivals_;
    std::thread thread_;
};

}  // namespace fodscope::bridge
