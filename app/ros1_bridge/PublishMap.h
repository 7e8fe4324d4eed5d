// SPDX-License-Identifier: MIT
#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <ros/service_traits.h>

#include <cstdint>

namespace fodscope::bridge {

/// rtabmap_ros/PublishMap (Melodic; rtabmap_msgs in later Noetic), which no package of Debian has.
struct PublishMap {
    struct Request {
        /// The whole map instead of the local one.
        std::uint8_t global = 1;
        std::uint8_t optimized = 1;
        /// Poses without clouds.
        std::uint8_t graphOnly = 0;
    };
    struct Response {};
    Request request;
    Response response;
};

inline constexpr const char* kPublishMapType = "rtabmap_ros/PublishMap";
inline constexpr const char* kPublishMapMd5 = "6213f9f13cced23f4d224b22f59d839c";

}  // namespace fodscope::bridge

namespace ros {
namespace serialization {

template <>
struct Serializer<fodscope::bridge::PublishMap::Request> {
    template <class Stream, class Message>
    static void allInOne(Stream& stream, Message message) {
        stream.next(message.global);
        stream.next(message.optimized);
        stream.next(message.graphOnly);
    }
    ROS_DECLARE_ALLINONE_SERIALIZER
};

template <>
struct Serializer<fodscope::bridge::PublishMap::Response> {
    template <class Stream, class Message>
    static void allInOne(Stream&, Message) {}
    ROS_DECLARE_ALLINONE_SERIALIZER
};

}  // namespace serialization
}  // namespace ros
