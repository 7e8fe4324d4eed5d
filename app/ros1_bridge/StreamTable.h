// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/bridge/BridgeParameters.h"
#include "core/bridge/BridgeProtocol.h"

namespace fodscope::bridge {

/// What comes from the robot, and how long ago it did.
class StreamTable {
  public:
    explicit StreamTable(const ParameterValues& parameters);

    void heard(const std::string& name, double now_s);
    /// What is odd about a stream; empty: nothing any more.
    void setNote(const std::string& name, const std::string& note);
    void setTopic(const std::string& name, const std::string& topic, const std::string& type);
    /// The youngest of those that a robot that is there never lets go silent; missing while none has come.
    std::optional<double> lifeSign_s() const;
    Streams at(double now_s) const;

  private:
    struct Entry {
        Stream stream;
        bool isLifeSign = false;
        std::optional<double> heard_s;
    };
    Entry& entry(const std::string& name);

    std::vector<Entry> entries_;
};

}  // namespace fodscope::bridge
