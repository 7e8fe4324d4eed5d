// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace fodscope::robot_simulator {

/// Notices when the master that this node registered with is gone and another one answers in its place: to that one the
/// node does not exist, and roscpp does not tell. Asks in a thread of its own, since a master may not answer.
class MasterWatch {
  public:
    MasterWatch();
    ~MasterWatch();
    MasterWatch(const MasterWatch&) = delete;
    MasterWatch& operator=(const MasterWatch&) = delete;

    bool isAnotherMaster() const { return isAnother_; }

  private:
    void watch();

    int first_;
    std::atomic<bool> isAnother_{false};
    std::mutex mutex_;
    std::condition_variable ending_;
    bool ends_ = false;
    std::thread thread_;
};

}  // namespace fodscope::robot_simulator
