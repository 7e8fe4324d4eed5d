// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace fodscope {

/// A program that a test starts, speaks to line by line, and ends by closing its input.
class Program {
  public:
    Program(const std::vector<std::string>& arguments, const std::vector<std::string>& environment = {});
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void writeLine(const std::string& line);
    /// @return whether a line for which the condition holds came within the time; earlier ones are dropped
    bool waitForLine(double within_s, const std::function<bool(const std::string&)>& holds);
    /// Waits for a JSON line {"event": name}. @return it, or null
    nlohmann::json waitForEvent(const std::string& name, double within_s = 20.0);
    void kill(int signal);
    pid_t id() const { return id_; }

  private:
    pid_t id_ = -1;
    int input_ = -1;
    int output_ = -1;
    std::string buffer_;
};

/// A roscore on a port of its own, which can go and come back.
class RosCore {
  public:
    /// @param port 0: a free one
    explicit RosCore(int port = 0);
    const std::string& uri() const { return uri_; }
    int port() const;
    /// For programs that are to find it.
    std::vector<std::string> environment() const;

  private:
    Program program_;
    std::string uri_;
};

/// @return why tests over ROS cannot run here; empty when they can
std::string rosIsMissing();
std::string fakesFolder();

}  // namespace fodscope
