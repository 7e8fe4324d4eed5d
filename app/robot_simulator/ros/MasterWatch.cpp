// SPDX-License-Identifier: MIT
#include "app/robot_simulator/ros/MasterWatch.h"

#include <ros/param.h>

#include <chrono>

namespace fodscope::robot_simulator {
namespace {

/// roscore draws one each time it starts. @return empty while none answers
std::string runId() {
    std::string id;
    ros::param::get("/run_id", id);
    return id;
}

}  // namespace

MasterWatch::MasterWatch() : firstRun_(runId()), thread_([this] { watch(); }) {}

MasterWatch::~MasterWatch() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        ends_ = true;
    }
    ending_.notify_all();
    thread_.join();
}

void MasterWatch::watch() {
    constexpr std::chrono::milliseconds kPeriod(500);
    std::unique_lock<std::mutex> lock(mutex_);
    while (!ending_.wait_for(lock, kPeriod, [this] { return ends_; })) {
        lock.unlock();
        const std::string run = runId();
        if (firstRun_.empty()) firstRun_ = run;
        if (!run.empty() && run != firstRun_) isAnother_ = true;
        lock.lock();
    }
}

}  // namespace fodscope::robot_simulator
