// SPDX-License-Identifier: MIT
#include <actionlib_msgs/GoalID.h>
#include <actionlib_msgs/GoalStatusArray.h>
#include <geometry_msgs/Twist.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <ros/callback_queue.h>
#include <ros/console.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2/buffer_core.h>
#include <tf2/exceptions.h>
#include <tf2_msgs/TFMessage.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "app/ros1_bridge/RosPort.h"
#include "app/ros1_bridge/RosServices.h"

namespace fodscope::bridge {
namespace {

constexpr double kTransformsKept_s = 30.0;

std::int64_t nanoseconds(const ros::Time& time) {
    return static_cast<std::int64_t>(time.toNSec());
}

DataView viewOf(const std::vector<std::uint8_t>& data) {
    return {data.data(), data.size()};
}

DataView viewOf(const std::vector<std::int8_t>& data) {
    return {reinterpret_cast<const std::uint8_t*>(data.data()), data.size()};
}

std::array<double, 7> numbersOf(const geometry_msgs::Pose& pose) {
    return {pose.position.x,    pose.position.y,    pose.position.z,   pose.orientation.x,
            pose.orientation.y, pose.orientation.z, pose.orientation.w};
}

Rows rowsOf(const geometry_msgs::Transform& transform) {
    const auto& q = transform.rotation;
    const auto& t = transform.translation;
    return {1 - 2 * (q.y * q.y + q.z * q.z),
            2 * (q.x * q.y - q.z * q.w),
            2 * (q.x * q.z + q.y * q.w),
            t.x,
            2 * (q.x * q.y + q.z * q.w),
            1 - 2 * (q.x * q.x + q.z * q.z),
            2 * (q.y * q.z - q.x * q.w),
            t.y,
            2 * (q.x * q.z - q.y * q.w),
            2 * (q.y * q.z + q.x * q.w),
            1 - 2 * (q.x * q.x + q.y * q.y),
            t.z,
            0,
            0,
            0,
            1};
}

std::string withoutSlash(const std::string& frame) {
    return !frame.empty() && frame[0] == '/' ? frame.substr(1) : frame;
}

GoalStatusMessage goalOf(const actionlib_msgs::GoalStatus& status) {
    return {status.goal_id.id, nanoseconds(status.goal_id.stamp), static_cast<ActionStatus>(status.status),
            status.text};
}

class RoscppPort : public RosPort {
  public:
    explicit RoscppPort(const ParameterValues& parameters)
        : parameters_(parameters), buffer_(ros::Duration(kTransformsKept_s)) {}

    void attach(RosListener& listener) override;
    void spin() override;
    void watchCloud(bool on) override;
    void watchImage(bool compressed) override;
    int goalListeners() const override { return goals_ ? static_cast<int>(goals_.getNumSubscribers()) : 0; }
    void publishGoal(const GoalStatusMessage& goal, const std::string& frame, const PlanarPose& pose) override;
    void publishCancelAll() override;
    void publishSpeeds(double forward_m_per_s, double turn_rad_per_s) override;
    std::optional<StampedTransform> lookup(const std::string& target, const std::string& source,
                                           std::optional<std::int64_t> stamp_ns) const override;
    void callService(const std::string& service) override;
    std::int64_t now_ns() const override { return nanoseconds(ros::Time::now()); }

  private:
    template <class Message>
    ros::Subscriber subscribe(const std::string& topic, std::uint32_t queue,
                              std::function<void(const Message&)> handle) {
        const boost::function<void(const boost::shared_ptr<const Message>&)> callback =
            [handle = std::move(handle)](const boost::shared_ptr<const Message>& message) { handle(*message); };
        return node_->subscribe<Message>(topic, queue, callback);
    }
    void subscribeState();
    void subscribeGrid(const std::string& topic, bool isCostMap);
    void subscribeAction();
    void subscribeCloud();
    void subscribeImage();
    void takeTransforms(const tf2_msgs::TFMessage& message, bool isStatic);

    const ParameterValues& parameters_;
    RosListener* listener_ = nullptr;
    ros::CallbackQueue queue_;
    std::unique_ptr<ros::NodeHandle> node_;
    std::vector<ros::Subscriber> subscribers_;
    ros::Subscriber cloud_;
    ros::Subscriber image_;
    bool wantsCloud_ = false;
    std::optional<bool> wantsCompressed_;
    ros::Publisher goals_;
    ros::Publisher cancels_;
    ros::Publisher speeds_;
    tf2::BufferCore buffer_;
    ServiceCaller services_;
};

void RoscppPort::attach(RosListener& listener) {
    listener_ = &listener;
    for (ros::Subscriber& subscriber : subscribers_)
        subscriber.shutdown();
    subscribers_.clear();
    cloud_.shutdown();
    image_.shutdown();
    goals_.shutdown();
    cancels_.shutdown();
    speeds_.shutdown();
    if (!node_) {
        node_ = std::make_unique<ros::NodeHandle>();
        node_->setCallbackQueue(&queue_);
    }
    subscribeState();
    subscribeGrid(parameters_.text("grid"), false);
    subscribeGrid(parameters_.text("costmap"), true);
    subscribeAction();
    speeds_ = node_->advertise<geometry_msgs::Twist>(parameters_.text("cmd_vel"), 1);
    subscribeCloud();
    subscribeImage();
}

void RoscppPort::subscribeState() {
    subscribers_.push_back(subscribe<tf2_msgs::TFMessage>(
        "/tf", 100, [this](const tf2_msgs::TFMessage& message) { takeTransforms(message, false); }));
    subscribers_.push_back(subscribe<tf2_msgs::TFMessage>(
        "/tf_static", 100, [this](const tf2_msgs::TFMessage& message) { takeTransforms(message, true); }));
    subscribers_.push_back(
        subscribe<nav_msgs::Odometry>(parameters_.text("odometry"), 20, [this](const nav_msgs::Odometry& message) {
            const auto& speed = message.twist.twist.linear;
            const auto& turn = message.twist.twist.angular;
            listener_->onOdometry({nanoseconds(message.header.stamp), std::hypot(speed.x, speed.y, speed.z),
                                   std::hypot(turn.x, turn.y, turn.z)});
        }));
    subscribers_.push_back(subscribe<sensor_msgs::CameraInfo>(
        parameters_.text("camera_info"), 2, [this](const sensor_msgs::CameraInfo& message) {
            const bool isDistorted =
                std::any_of(message.D.begin(), message.D.end(), [](double value) { return value != 0.0; });
            listener_->onCameraInfo(
                {message.width, message.height, message.K[0], message.K[4], message.K[2], message.K[5], isDistorted});
        }));
    subscribers_.push_back(
        subscribe<nav_msgs::Path>(parameters_.text("trajectory"), 1, [this](const nav_msgs::Path& message) {
            PathMessage path{withoutSlash(message.header.frame_id), {}};
            for (const auto& pose : message.poses)
                path.poses.push_back(numbersOf(pose.pose));
            listener_->onPath(path);
        }));
}

void RoscppPort::subscribeGrid(const std::string& topic, bool isCostMap) {
    subscribers_.push_back(
        subscribe<nav_msgs::OccupancyGrid>(topic, 1, [this, isCostMap](const nav_msgs::OccupancyGrid& message) {
            listener_->onGrid({withoutSlash(message.header.frame_id), message.info.width, message.info.height,
                               message.info.resolution, numbersOf(message.info.origin), viewOf(message.data)},
                              isCostMap);
        }));
    // Updates build on each other: none may be left out while one is worked on.
    subscribers_.push_back(subscribe<map_msgs::OccupancyGridUpdate>(
        topic + "_updates", 200, [this, isCostMap](const map_msgs::OccupancyGridUpdate& message) {
            listener_->onGridUpdate({message.x, message.y, message.width, message.height, viewOf(message.data)},
                                    isCostMap);
        }));
}

void RoscppPort::subscribeAction() {
    const std::string action = parameters_.text("move_base");
    goals_ = node_->advertise<move_base_msgs::MoveBaseActionGoal>(action + "/goal", 10);
    cancels_ = node_->advertise<actionlib_msgs::GoalID>(action + "/cancel", 10);
    subscribers_.push_back(subscribe<actionlib_msgs::GoalStatusArray>(
        action + "/status", 10, [this](const actionlib_msgs::GoalStatusArray& message) {
            std::vector<GoalStatusMessage> goals;
            for (const auto& status : message.status_list)
                goals.push_back(goalOf(status));
            listener_->onGoalStatus(goals);
        }));
    subscribers_.push_back(subscribe<move_base_msgs::MoveBaseActionFeedback>(
        action + "/feedback", 1, [this](const move_base_msgs::MoveBaseActionFeedback& message) {
            listener_->onGoalFeedback(message.status.goal_id.id);
        }));
    subscribers_.push_back(subscribe<move_base_msgs::MoveBaseActionResult>(
        action + "/result", 10, [this](const move_base_msgs::MoveBaseActionResult& message) {
            listener_->onGoalResult(goalOf(message.status));
        }));
}

void RoscppPort::watchCloud(bool on) {
    if (on == wantsCloud_) return;
    wantsCloud_ = on;
    cloud_.shutdown();
    if (node_) subscribeCloud();
}

void RoscppPort::subscribeCloud() {
    if (!wantsCloud_) return;
    cloud_ = subscribe<sensor_msgs::PointCloud2>(
        parameters_.text("map_cloud"), 1, [this](const sensor_msgs::PointCloud2& message) {
            CloudMessage cloud{withoutSlash(message.header.frame_id),
                               nanoseconds(message.header.stamp),
                               message.width,
                               message.height,
                               message.point_step,
                               message.row_step,
                               message.is_bigendian != 0,
                               {},
                               viewOf(message.data)};
            for (const auto& field : message.fields)
                cloud.fields.push_back({field.name, field.offset, field.datatype, field.count});
            listener_->onCloud(cloud);
        });
}

void RoscppPort::watchImage(bool compressed) {
    if (wantsCompressed_ == compressed) return;
    wantsCompressed_ = compressed;
    image_.shutdown();
    if (node_) subscribeImage();
}

void RoscppPort::subscribeImage() {
    if (!wantsCompressed_) return;
    const std::string base = parameters_.text("image");
    if (*wantsCompressed_) {
        image_ = subscribe<sensor_msgs::CompressedImage>(
            base + "/compressed", 2, [this](const sensor_msgs::CompressedImage& message) {
                listener_->onImage({true, withoutSlash(message.header.frame_id), nanoseconds(message.header.stamp), 0,
                                    0, 0, message.format, false, viewOf(message.data)});
            });
    } else {
        image_ = subscribe<sensor_msgs::Image>(base, 2, [this](const sensor_msgs::Image& message) {
            listener_->onImage({false, withoutSlash(message.header.frame_id), nanoseconds(message.header.stamp),
                                message.width, message.height, message.step, message.encoding,
                                message.is_bigendian != 0, viewOf(message.data)});
        });
    }
}

void RoscppPort::takeTransforms(const tf2_msgs::TFMessage& message, bool isStatic) {
    for (geometry_msgs::TransformStamped transform : message.transforms) {
        transform.header.frame_id = withoutSlash(transform.header.frame_id);
        transform.child_frame_id = withoutSlash(transform.child_frame_id);
        // Broken transforms are refused by the buffer, which says so in the log.
        buffer_.setTransform(transform, "robot", isStatic);
    }
    listener_->onTransforms();
}

void RoscppPort::spin() {
    queue_.callAvailable(ros::WallDuration(0));
    for (const ServiceAnswered& answer : services_.takeAnswers())
        listener_->onServiceAnswered(answer);
}

void RoscppPort::publishGoal(const GoalStatusMessage& goal, const std::string& frame, const PlanarPose& pose) {
    move_base_msgs::MoveBaseActionGoal message;
    message.header.stamp.fromNSec(static_cast<std::uint64_t>(goal.stamp_ns));
    message.goal_id.id = goal.id;
    message.goal_id.stamp = message.header.stamp;
    // Without a stamp the robot takes its latest transform, so that differing clocks do no harm.
    message.goal.target_pose.header.frame_id = frame;
    message.goal.target_pose.pose.position.x = pose.x_m;
    message.goal.target_pose.pose.position.y = pose.y_m;
    message.goal.target_pose.pose.orientation.z = std::sin(pose.yaw_rad / 2);
    message.goal.target_pose.pose.orientation.w = std::cos(pose.yaw_rad / 2);
    goals_.publish(message);
}

void RoscppPort::publishCancelAll() {
    // An empty id and no stamp mean all goals of all clients.
    if (cancels_) cancels_.publish(actionlib_msgs::GoalID());
}

void RoscppPort::publishSpeeds(double forward_m_per_s, double turn_rad_per_s) {
    if (!speeds_) return;
    geometry_msgs::Twist message;
    message.linear.x = forward_m_per_s;
    message.angular.z = turn_rad_per_s;
    speeds_.publish(message);
}

std::optional<StampedTransform> RoscppPort::lookup(const std::string& target, const std::string& source,
                                                   std::optional<std::int64_t> stamp_ns) const {
    ros::Time time;
    if (stamp_ns) time.fromNSec(static_cast<std::uint64_t>(std::max<std::int64_t>(*stamp_ns, 1)));
    try {
        const geometry_msgs::TransformStamped found = buffer_.lookupTransform(target, source, time);
        return StampedTransform{rowsOf(found.transform), nanoseconds(found.header.stamp)};
    } catch (const tf2::TransformException&) {
        return std::nullopt;
    }
}

void RoscppPort::callService(const std::string& service) {
    services_.call(service, parameters_.text(service));
}

template <class Message>
std::pair<std::string, std::string> typeOf() {
    return {ros::message_traits::datatype<Message>(), ros::message_traits::md5sum<Message>()};
}

}  // namespace

std::unique_ptr<RosPort> makeRosPort(const ParameterValues& parameters) {
    return std::make_unique<RoscppPort>(parameters);
}

void initialiseRos(const std::string& masterUri, const std::string& ownAddress) {
    std::map<std::string, std::string> settings;
    if (!masterUri.empty()) settings["__master"] = masterUri;
    if (!ownAddress.empty()) settings["__hostname"] = ownAddress;
    ros::init(settings, "fodscope_bridge",
              ros::init_options::NoSigintHandler | ros::init_options::AnonymousName | ros::init_options::NoRosout);
    ros::master::setRetryTimeout(ros::WallDuration(1.0));
    ros::console::set_logger_level(ROSCONSOLE_DEFAULT_NAME, ros::console::levels::Fatal);
    ros::console::notifyLoggerLevelsChanged();
}

void shutDownRos() {
    ::alarm(2);
    if (ros::isStarted()) ros::shutdown();
}

std::map<std::string, std::string> usedMessageTypes() {
    std::map<std::string, std::string> types = ServiceCaller::usedTypes();
    types.insert({typeOf<actionlib_msgs::GoalID>(), typeOf<actionlib_msgs::GoalStatusArray>(),
                  typeOf<geometry_msgs::Twist>(), typeOf<map_msgs::OccupancyGridUpdate>(),
                  typeOf<move_base_msgs::MoveBaseActionFeedback>(), typeOf<move_base_msgs::MoveBaseActionGoal>(),
                  typeOf<move_base_msgs::MoveBaseActionResult>(), typeOf<nav_msgs::OccupancyGrid>(),
                  typeOf<nav_msgs::Odometry>(), typeOf<nav_msgs::Path>(), typeOf<sensor_msgs::CameraInfo>(),
                  typeOf<sensor_msgs::CompressedImage>(), typeOf<sensor_msgs::Image>(),
                  typeOf<sensor_msgs::PointCloud2>(), typeOf<tf2_msgs::TFMessage>()});
    return types;
}

}  // namespace fodscope::bridge
