// SPDX-License-Identifier: MIT
#include "app/robot_simulator/ros/Faults.h"

#include <std_msgs/String.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <cmath>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace fodscope::robot_simulator {
namespace {

template <typename Fault>
using Names = std::map<std::string, Fault>;

const Names<GoalFault> kGoalFaults{{"none", GoalFault::None},
                                   {"lost", GoalFault::Lost},
                                   {"rejected", GoalFault::Rejected},
                                   {"aborted", GoalFault::Aborted},
                                   {"preempted", GoalFault::Preempted},
                                   {"never_arrives", GoalFault::NeverArrives},
                                   {"server_restarts", GoalFault::ServerRestarts},
                                   {"no_server", GoalFault::NoServer},
                                   {"result_lost", GoalFault::ResultLost},
                                   {"cancel_lost", GoalFault::CancelLost}};
const Names<TfFault> kTfFaults{
    {"none", TfFault::None}, {"missing", TfFault::Missing}, {"stale", TfFault::Stale}, {"jumped", TfFault::Jumped}};
const Names<CameraFault> kCameraFaults{
    {"none", CameraFault::None},   {"silent", CameraFault::Silent},   {"frozen", CameraFault::Frozen},
    {"black", CameraFault::Black}, {"corrupt", CameraFault::Corrupt}, {"wrong_encoding", CameraFault::WrongEncoding},
    {"huge", CameraFault::Huge}};
const Names<CloudFault> kCloudFaults{{"none", CloudFault::None},
                                     {"silent", CloudFault::Silent},
                                     {"nan", CloudFault::Nan},
                                     {"empty", CloudFault::Empty},
                                     {"missing_fields", CloudFault::MissingFields},
                                     {"wrong_row_step", CloudFault::WrongRowStep},
                                     {"truncated", CloudFault::Truncated}};
const Names<CostMapFault> kCostMapFaults{{"none", CostMapFault::None},
                                         {"silent", CostMapFault::Silent},
                                         {"wrong_size", CostMapFault::WrongSize},
                                         {"update_outside", CostMapFault::UpdateOutside}};
const Names<ServiceFault> kServiceFaults{
    {"none", ServiceFault::None}, {"missing", ServiceFault::Missing}, {"failing", ServiceFault::Failing}};
const Names<OdometryFault> kOdometryFaults{{"none", OdometryFault::None}, {"silent", OdometryFault::Silent}};

[[noreturn]] void refuse(const std::string& key, const std::string& problem, const std::string& remedy) {
    throw std::runtime_error("~faults/" + key + ": " + problem + "; " + remedy);
}

template <typename Entries>
std::string listed(const Entries& entries) {
    std::string list;
    for (const auto& entry : entries)
        list += (list.empty() ? "" : ", ") + entry.first;
    return list;
}

template <typename Fault>
Fault faultNamed(const std::string& key, XmlRpc::XmlRpcValue& value, const Names<Fault>& names) {
    const std::string name =
        value.getType() == XmlRpc::XmlRpcValue::TypeString ? static_cast<std::string&>(value) : std::string();
    const auto found = names.find(name);
    if (found == names.end()) refuse(key, "no such fault", "give one of " + listed(names));
    return found->second;
}

double number(const std::string& key, XmlRpc::XmlRpcValue& value) {
    double result = std::nan("");
    if (value.getType() == XmlRpc::XmlRpcValue::TypeInt) result = static_cast<int&>(value);
    if (value.getType() == XmlRpc::XmlRpcValue::TypeDouble) result = static_cast<double&>(value);
    if (!std::isfinite(result)) refuse(key, "it is not a number", "give a finite number");
    return result;
}

using Reader = std::function<void(Faults&, const std::string&, XmlRpc::XmlRpcValue&)>;

template <typename Fault>
Reader namedReader(Fault Faults::*member, const Names<Fault>& names) {
    return [member, &names](Faults& faults, const std::string& key, XmlRpc::XmlRpcValue& value) {
        faults.*member = faultNamed(key, value, names);
    };
}

Reader numberReader(double Faults::*member, double scale = 1.0) {
    return [member, scale](Faults& faults, const std::string& key, XmlRpc::XmlRpcValue& value) {
        faults.*member = scale * number(key, value);
    };
}

const std::map<std::string, Reader>& readers() {
    constexpr double kRadiansPerDegree = 0.017453292519943295;
    static const std::map<std::string, Reader> table{
        {"goal", namedReader(&Faults::goal, kGoalFaults)},
        {"goal_times", [](Faults& faults, const std::string& key,
                          XmlRpc::XmlRpcValue& value) { faults.goalTimes = static_cast<int>(number(key, value)); }},
        {"tf", namedReader(&Faults::tf, kTfFaults)},
        {"tf_jump_x_m", numberReader(&Faults::tfJumpX_m)},
        {"tf_jump_y_m", numberReader(&Faults::tfJumpY_m)},
        {"tf_jump_yaw_deg", numberReader(&Faults::tfJumpYaw_rad, kRadiansPerDegree)},
        {"clock_offset_s", numberReader(&Faults::clockOffset_s)},
        {"camera", namedReader(&Faults::camera, kCameraFaults)},
        {"cloud", namedReader(&Faults::cloud, kCloudFaults)},
        {"costmap", namedReader(&Faults::costMap, kCostMapFaults)},
        {"services", namedReader(&Faults::services, kServiceFaults)},
        {"odometry", namedReader(&Faults::odometry, kOdometryFaults)}};
    return table;
}

}  // namespace

FaultSource::FaultSource(const ros::NodeHandle& privateNode)
    : node_(privateNode), inEffect_(node_.advertise<std_msgs::String>("faults_in_effect", 1, true)) {}

Faults FaultSource::read() {
    Faults faults;
    XmlRpc::XmlRpcValue values;
    node_.getParamCached("faults", values);
    if (values.getType() != XmlRpc::XmlRpcValue::TypeStruct) {
        tell("");
        return faults;
    }
    std::ostringstream inEffect;
    for (auto& entry : values) {
        const auto reader = readers().find(entry.first);
        if (reader == readers().end()) refuse(entry.first, "no such parameter", "give one of " + listed(readers()));
        reader->second(faults, entry.first, entry.second);
        inEffect << (inEffect.tellp() > 0 ? " " : "") << entry.first << "=" << entry.second;
    }
    tell(inEffect.str());
    return faults;
}

void FaultSource::tell(const std::string& inEffect) {
    if (inEffect == told_) return;
    told_ = inEffect;
    std_msgs::String message;
    message.data = inEffect;
    inEffect_.publish(message);
}

}  // namespace fodscope::robot_simulator
