// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/common/Geometry.h"

namespace fodscope {

/// Something that comes from the robot again and again.
struct RobotStream {
    std::string name;
    std::string topic;
    std::string type;
    /// When the last message came, on the clock that poll() was given; missing before the first.
    std::optional<double> heard_s;
    /// Older than this is stale; 0: it comes when it comes.
    double staleAfter_s = 0.0;
    std::uint64_t count = 0;
    /// What is odd about it, in words.
    std::string note;

    bool isStale(double now_s) const { return !heard_s || (staleAfter_s > 0.0 && now_s - *heard_s > staleAfter_s); }
};

struct RobotTopic {
    std::string name;
    std::string type;
};

enum class RobotService { LocalizationMode, MappingMode, PublishMap };

/// What a real robot offers beside visits: what comes from it and how old that is, driving by hand, services. What it
/// returns is as of the link's last poll().
class RobotConsole {
  public:
    virtual ~RobotConsole() = default;

    virtual const std::vector<RobotStream>& streams() const = 0;
    virtual void requestTopics() = 0;
    /// Sorted by type and name.
    virtual const std::vector<RobotTopic>& topics() const = 0;
    /// Poses the map was seen from.
    virtual const std::vector<Transform>& trajectory_map() const = 0;
    /// Why the link is not up, in words; empty when it is.
    virtual const std::string& problem() const = 0;
    /// What odometry says; missing while it is silent.
    virtual std::optional<bool> isMoving() const = 0;
    /// How long odometry has said that the robot stands.
    virtual std::optional<double> stillFor_s() const = 0;
    /// Whether the robot works on a goal, whoever sent it.
    virtual bool isAnyGoalUnderWay() const = 0;

    /// Speeds that hold for 0.3 s and are then zero, unless this is called again.
    virtual void drive(double forward_m_per_s, double turn_rad_per_s) = 0;
    /// Every map that the robot sends comes as an event, or only those asked for.
    virtual void followMap(bool on) = 0;
    /// Only when the operator asks for it.
    virtual void callService(RobotService service) = 0;
};

}  // namespace fodscope
