// SPDX-License-Identifier: MIT
#include "app/robot_simulator/ros/MasterWatch.h"

#include <ros/master.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <chrono>

namespace fodscope::robot_simulator {
namespace {

/// @return the master's process id; 0 while none answers
int masterProcess() {
    XmlRpc::XmlRpcValue request, response, payload;
    request[0] = ros::this_node::getName();
    if (!ros::master::execute("getPid", request, response, payload, false)) return 0;
    return payload.getType() == XmlRpc::XmlRpcValue::TypeInt ? static_cast<int&>(payload) : 0;
}

}  // namespace

MasterWatch::MasterWatch() : first_(masterProcess()), thread_([this] { watch(); }) {}

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
        const int now = masterProcess();
        if (now != 0 && now != first_) isAnother_ = true;
        lock.lock();
    }
}

}  // namespace fodscope::robot_simulator
