// SPDX-License-Identifier: MIT
#include "app/ros1_bridge/RosServices.h"

#include <ros/node_handle.h>
#include <ros/service.h>
#include <ros/service_client.h>
#include <ros/service_client_options.h>
#include <std_srvs/Empty.h>

#include <mutex>
#include <thread>
#include <utility>

#include "app/ros1_bridge/PublishMap.h"

namespace fodscope::bridge {
namespace {

const char* const kPublishMapService = "publish_map";

bool callEmpty(const std::string& name) {
    std_srvs::Empty call;
    return ros::service::call(name, call);
}

bool callPublishMap(const std::string& name) {
    PublishMap call;
    ros::NodeHandle node;
    ros::ServiceClientOptions options(name, kPublishMapMd5, false, ros::M_string());
    ros::ServiceClient client = node.serviceClient(options);
    return client.call(call.request, call.response, kPublishMapMd5);
}

ServiceAnswered answerOf(const std::string& service, const std::string& name) {
    if (!ros::service::exists(name, false)) return {service, false, "the robot has no service " + name};
    const bool done = service == kPublishMapService ? callPublishMap(name) : callEmpty(name);
    return {service, done, done ? "" : name + " did not do it"};
}

}  // namespace

struct ServiceCaller::Answers {
    std::mutex mutex;
    std::vector<ServiceAnswered> waiting;
};

ServiceCaller::ServiceCaller() : answers_(std::make_shared<Answers>()) {}

ServiceCaller::~ServiceCaller() = default;

void ServiceCaller::call(const std::string& service, const std::string& name) {
    std::thread([service, name, answers = answers_] {
        ServiceAnswered answer = answerOf(service, name);
        const std::lock_guard<std::mutex> lock(answers->mutex);
        answers->waiting.push_back(std::move(answer));
    }).detach();
}

std::vector<ServiceAnswered> ServiceCaller::takeAnswers() {
    const std::lock_guard<std::mutex> lock(answers_->mutex);
    return std::exchange(answers_->waiting, {});
}

std::map<std::string, std::string> ServiceCaller::usedTypes() {
    return {{ros::service_traits::datatype<std_srvs::Empty>(), ros::service_traits::md5sum<std_srvs::Empty>()},
            {kPublishMapType, kPublishMapMd5}};
}

}  // namespace fodscope::bridge
