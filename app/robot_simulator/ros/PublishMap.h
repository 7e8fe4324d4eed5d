// SPDX-License-Identifier: MIT
#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <ros/service_traits.h>

#include <cstdint>

namespace fodscope::robot_simulator {

/// rtabmap's service that has the map sent to whoever subscribes: `rtabmap_ros/PublishMap` in Melodic,
/// `rtabmap_msgs/PublishMap` in later Noetic. No Debian package has it, so its type is spelled out here:
///     bool global      # from the whole memory, not only what is in work
///     bool optimized   # in the optimized frame, as opposed to odometry's
///     bool graphOnly   # the poses alone, without clouds and grids
///     ---
struct PublishMap {
    struct Request {
        std::uint8_t global = 1;
        std::uint8_t optimized = 1;
        std::uint8_t graphOnly = 0;
    };
    struct Response {};

    Request request;
    Response response;
};

inline constexpr const char* kPublishMapType = "rtabmap_msgs/PublishMap";
inline constexpr const char* kPublishMapMd5 = "6213f9f13cced23f4d224b22f59d839c";
/// Of an empty message.
inline constexpr const char* kEmptyMd5 = "d41d8cd98f00b204e9800998ecf8427e";

}  // namespace fodscope::robot_simulator

namespace ros::service_traits {

template <>
struct MD5Sum<fodscope::robot_simulator::PublishMap> {
    static const char* value() { return fodscope::robot_simulator::kPublishMapMd5; }
    static const char* value(const fodscope::robot_simulator::PublishMap&) { return value(); }
};
template <>
struct DataType<fodscope::robot_simulator::PublishMap> {
    static const char* value() { return fodscope::robot_simulator::kPublishMapType; }
    static const char* value(const fodscope::robot_simulator::PublishMap&) { return value(); }
};
template <>
struct MD5Sum<fodscope::robot_simulator::PublishMap::Request> : MD5Sum<fodscope::robot_simulator::PublishMap> {
    using MD5Sum<fodscope::robot_simulator::PublishMap>::value;
    static const char* value(const fodscope::robot_simulator::PublishMap::Request&) { return value(); }
};
template <>
struct DataType<fodscope::robot_simulator::PublishMap::Request> : DataType<fodscope::robot_simulator::PublishMap> {
    using DataType<fodscope::robot_simulator::PublishMap>::value;
    static const char* value(const fodscope::robot_simulator::PublishMap::Request&) { return value(); }
};
template <>
struct MD5Sum<fodscope::robot_simulator::PublishMap::Response> : MD5Sum<fodscope::robot_simulator::PublishMap> {
    using MD5Sum<fodscope::robot_simulator::PublishMap>::value;
    static const char* value(const fodscope::robot_simulator::PublishMap::Response&) { return value(); }
};
template <>
struct DataType<fodscope::robot_simulator::PublishMap::Response> : DataType<fodscope::robot_simulator::PublishMap> {
    using DataType<fodscope::robot_simulator::PublishMap>::value;
    static const char* value(const fodscope::robot_simulator::PublishMap::Response&) { return value(); }
};

}  // namespace ros::service_traits

namespace ros::message_traits {

template <>
struct MD5Sum<fodscope::robot_simulator::PublishMap::Request> {
    static const char* value() { return fodscope::robot_simulator::kPublishMapMd5; }
    static const char* value(const fodscope::robot_simulator::PublishMap::Request&) { return value(); }
};
template <>
struct DataType<fodscope::robot_simulator::PublishMap::Request> {
    static const char* value() { return "rtabmap_msgs/PublishMapRequest"; }
    static const char* value(const fodscope::robot_simulator::PublishMap::Request&) { return value(); }
};
template <>
struct MD5Sum<fodscope::robot_simulator::PublishMap::Response> {
    static const char* value() { return fodscope::robot_simulator::kEmptyMd5; }
    static const char* value(const fodscope::robot_simulator::PublishMap::Response&) { return value(); }
};
template <>
struct DataType<fodscope::robot_simulator::PublishMap::Response> {
    static const char* value() { return "rtabmap_msgs/PublishMapResponse"; }
    static const char* value(const fodscope::robot_simulator::PublishMap::Response&) { return value(); }
};

}  // namespace ros::message_traits

namespace ros::serialization {

template <>
struct Serializer<fodscope::robot_simulator::PublishMap::Request> {
    template <typename Stream, typename Message>
    static void allInOne(Stream& stream, Message message) {
        stream.next(message.global);
        stream.next(message.optimized);
        stream.next(message.graphOnly);
    }
    ROS_DECLARE_ALLINONE_SERIALIZER
};
template <>
struct Serializer<fodscope::robot_simulator::PublishMap::Response> {
    template <typename Stream, typename Message>
    static void allInOne(Stream&, Message) {}
    ROS_DECLARE_ALLINONE_SERIALIZER
};

}  // namespace ros::serialization
