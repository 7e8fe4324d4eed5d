// SPDX-License-Identifier: MIT
#pragma once

#include "core/bridge/BridgeProtocol.h"

/// The names that messages and their fields have on the wire, each written once for both directions:
/// visit(field, message) calls field(name, member) for all members.
namespace fodscope::bridge {

template <class Message>
inline constexpr const char* kMessageName = nullptr;

#define FODSCOPE_MESSAGE(Message, name)                        \
    template <>                                                \
    inline constexpr const char* kMessageName<Message> = name; \
    template <class Field>                                     \
    void visitFields(Field& field, [[maybe_unused]] Message& m)

FODSCOPE_MESSAGE(Configure, "configure") {
    field("version", m.version);
    field("master", m.masterUri);
    field("own address", m.ownAddress);
    field("goal prefix", m.goalPrefix);
    field("parameters", m.parameters);
}
FODSCOPE_MESSAGE(FetchMap, "fetch map") {
    static_cast<void>(field);
}
FODSCOPE_MESSAGE(FollowMap, "follow map") {
    field("on", m.on);
}
FODSCOPE_MESSAGE(FetchGrid, "fetch grid") {
    static_cast<void>(field);
}
FODSCOPE_MESSAGE(SendGoal, "send goal") {
    field("id", m.id);
    field("pose", m.pose_map);
}
FODSCOPE_MESSAGE(CancelAllGoals, "cancel all goals") {
    static_cast<void>(field);
}
FODSCOPE_MESSAGE(TakePhoto, "take photo") {
    field("request", m.requestId);
}
FODSCOPE_MESSAGE(Drive, "drive") {
    field("forward", m.forward_m_per_s);
    field("turn", m.turn_rad_per_s);
}
FODSCOPE_MESSAGE(CallService, "call service") {
    field("service", m.service);
}
FODSCOPE_MESSAGE(ListTopics, "list topics") {
    static_cast<void>(field);
}

FODSCOPE_MESSAGE(Hello, "hello") {
    field("version", m.version);
    field("program", m.program);
}
FODSCOPE_MESSAGE(State, "state") {
    field("link", m.link);
    field("reason", m.reason);
    field("pose", m.pose_map);
    field("pose age", m.poseAge_s);
    field("moving", m.moving);
    field("still for", m.stillFor_s);
    field("goal", m.goalId);
    field("any goal", m.anyGoalUnderWay);
    field("distance left", m.distanceLeft_m);
    field("clock ahead", m.clockAhead_s);
}
FODSCOPE_MESSAGE(Stream, "stream") {
    field("name", m.name);
    field("topic", m.topic);
    field("type", m.type);
    field("age", m.age_s);
    field("stale after", m.staleAfter_s);
    field("count", m.count);
    field("note", m.note);
}
FODSCOPE_MESSAGE(Streams, "streams") {
    field("streams", m.streams);
}
FODSCOPE_MESSAGE(Topic, "topic") {
    field("name", m.name);
    field("type", m.type);
}
FODSCOPE_MESSAGE(Topics, "topics") {
    field("topics", m.topics);
}
FODSCOPE_MESSAGE(GoalAccepted, "goal accepted") {
    field("goal", m.goalId);
}
FODSCOPE_MESSAGE(GoalArrived, "goal arrived") {
    field("goal", m.goalId);
    field("pose", m.pose_map);
}
FODSCOPE_MESSAGE(GoalFailed, "goal failed") {
    field("goal", m.goalId);
    field("problem", m.problem);
    field("message", m.message);
}
FODSCOPE_MESSAGE(PhotoTaken, "photo taken") {
    field("request", m.requestId);
    field("goal", m.goalId);
    field("stamp", m.stamp_ns);
    field("map from camera", m.T_map_from_camera);
    field("odom from camera", m.T_odom_from_camera);
    field("width", m.width_px);
    field("height", m.height_px);
    field("fx", m.fx_px);
    field("fy", m.fy_px);
    field("cx", m.cx_px);
    field("cy", m.cy_px);
    field("picture", m.picture);
}
FODSCOPE_MESSAGE(PhotoFailed, "photo failed") {
    field("request", m.requestId);
    field("problem", m.problem);
    field("message", m.message);
}
FODSCOPE_MESSAGE(MapCloud, "map cloud") {
    field("points", m.points);
    field("colours", m.colours);
    field("dropped", m.dropped);
    field("stamp", m.stamp_ns);
}
FODSCOPE_MESSAGE(Grid, "grid") {
    field("width", m.width);
    field("height", m.height);
    field("resolution", m.resolution_m);
    field("origin", m.origin_map);
    field("cells", m.cells);
    field("cost map", m.isCostMap);
}
FODSCOPE_MESSAGE(Trajectory, "trajectory") {
    field("poses", m.T_map_from_robot);
}
FODSCOPE_MESSAGE(ServiceAnswered, "service answered") {
    field("service", m.service);
    field("ok", m.ok);
    field("message", m.message);
}
FODSCOPE_MESSAGE(Note, "note") {
    field("text", m.text);
}

#undef FODSCOPE_MESSAGE

}  // namespace fodscope::bridge
