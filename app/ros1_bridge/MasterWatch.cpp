// SPDX-License-Identifier: MIT
#include "app/ros1_bridge/MasterWatch.h"

#include <ros/master.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcException.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <tuple>
#include <utility>

namespace fodscope::bridge {
namespace {

constexpr std::chrono::milliseconds kPause(500);

std::vector<Topic> publishedTopics() {
    XmlRpc::XmlRpcValue request;
    XmlRpc::XmlRpcValue response;
    XmlRpc::XmlRpcValue payload;
    request[0] = ros::this_node::getName();
    request[1] = "";
    std::vector<Topic> topics;
    if (!ros::master::execute("getPublishedTopics", request, response, payload, false)) return topics;
    for (int i = 0; i < payload.size(); ++i)
        topics.push_back({std::string(payload[i][0]), std::string(payload[i][1])});
    std::sort(topics.begin(), topics.end(), [](const Topic& first, const Topic& second) {
        return std::tie(first.type, first.name) < std::tie(second.type, second.name);
    });
    return topics;
}

MasterSighting look() {
    XmlRpc::XmlRpcValue request;
    XmlRpc::XmlRpcValue response;
    XmlRpc::XmlRpcValue payload;
    request[0] = ros::this_node::getName();
    MasterSighting sighting;
    try {
        sighting.answers = ros::master::execute("getPid", request, response, payload, false);
        if (!sighting.answers) return sighting;
        sighting.processId = static_cast<int>(payload);
        sighting.topics = publishedTopics();
    } catch (const XmlRpc::XmlRpcException&) {
        // Something else than a ROS master listens there.
        sighting = {};
    }
    return sighting;
}

}  // namespace

struct MasterWatch::Shared {
    std::mutex mutex;
    std::condition_variable changed;
    bool over = false;
    std::optional<MasterSighting> newest;
};

MasterWatch::MasterWatch() : shared_(std::make_shared<Shared>()) {
    std::thread([shared = shared_] {
        for (;;) {
            MasterSighting sighting = look();
            std::unique_lock<std::mutex> lock(shared->mutex);
            shared->newest = std::move(sighting);
            if (shared->changed.wait_for(lock, kPause, [&] { return shared->over; })) return;
        }
    }).detach();
}

MasterWatch::~MasterWatch() {
    const std::lock_guard<std::mutex> lock(shared_->mutex);
    shared_->over = true;
    shared_->changed.notify_all();
}

std::optional<MasterSighting> MasterWatch::take() {
    const std::lock_guard<std::mutex> lock(shared_->mutex);
    return std::exchange(shared_->newest, std::nullopt);
}

}  // namespace fodscope::bridge
