// SPDX-License-Identifier: MIT
#include "tests/ros/bridge/Programs.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace fodscope {
namespace {

using Clock = std::chrono::steady_clock;

double secondsUntil(Clock::time_point deadline) {
    return std::chrono::duration<double>(deadline - Clock::now()).count();
}

std::vector<std::string> coreArguments(int port) {
    std::vector<std::string> arguments{"/usr/bin/python3", fakesFolder() + "/ros_core.py"};
    if (port != 0) arguments.insert(arguments.end(), {"--port", std::to_string(port)});
    return arguments;
}

}  // namespace

Program::Program(const std::vector<std::string>& arguments, const std::vector<std::string>& environment) {
    int input[2];
    int output[2];
    if (::pipe2(input, O_CLOEXEC) != 0 || ::pipe2(output, O_CLOEXEC) != 0) throw std::runtime_error("no pipes");
    std::vector<char*> argv;
    for (const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    id_ = ::fork();
    if (id_ == 0) {
        ::dup2(input[0], STDIN_FILENO);
        ::dup2(output[1], STDOUT_FILENO);
        for (const std::string& setting : environment)
            ::putenv(const_cast<char*>(setting.c_str()));
        ::execv(argv[0], argv.data());
        ::_exit(127);
    }
    ::close(input[0]);
    ::close(output[1]);
    input_ = input[1];
    output_ = output[0];
}

Program::~Program() {
    ::close(input_);
    for (int waited_ms = 0; waited_ms < 5000 && ::waitpid(id_, nullptr, WNOHANG) == 0; waited_ms += 10)
        ::poll(nullptr, 0, 10);
    if (::waitpid(id_, nullptr, WNOHANG) == 0) {
        ::kill(id_, SIGKILL);
        ::waitpid(id_, nullptr, 0);
    }
    ::close(output_);
}

void Program::writeLine(const std::string& line) {
    const std::string text = line + "\n";
    if (::write(input_, text.data(), text.size()) < 0) throw std::runtime_error("the program is gone");
}

bool Program::waitForLine(double within_s, const std::function<bool(const std::string&)>& holds) {
    const auto deadline =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(within_s));
    for (;;) {
        for (auto end = buffer_.find('\n'); end != std::string::npos; end = buffer_.find('\n')) {
            const std::string line = buffer_.substr(0, end);
            buffer_.erase(0, end + 1);
            if (holds(line)) return true;
        }
        pollfd descriptor{output_, POLLIN, 0};
        const double left_s = secondsUntil(deadline);
        if (left_s <= 0.0 || ::poll(&descriptor, 1, static_cast<int>(left_s * 1000) + 1) <= 0) return false;
        char text[4096];
        const ssize_t count = ::read(output_, text, sizeof text);
        if (count <= 0) return false;
        buffer_.append(text, static_cast<std::size_t>(count));
    }
}

nlohmann::json Program::waitForEvent(const std::string& name, double within_s) {
    nlohmann::json found;
    waitForLine(within_s, [&](const std::string& line) {
        const auto event = nlohmann::json::parse(line, nullptr, false);
        if (!event.is_object() || event.value("event", "") != name) return false;
        found = event;
        return true;
    });
    return found;
}

void Program::kill(int signal) {
    ::kill(id_, signal);
}

RosCore::RosCore(int port) : program_(coreArguments(port)) {
    const std::string key = "ROS_MASTER_URI=";
    const bool answers = program_.waitForLine(40.0, [&](const std::string& line) {
        if (line.rfind(key, 0) != 0) return false;
        uri_ = line.substr(key.size());
        return true;
    });
    if (!answers) throw std::runtime_error("the roscore did not start");
}

int RosCore::port() const {
    return std::stoi(uri_.substr(uri_.rfind(':') + 1));
}

std::vector<std::string> RosCore::environment() const {
    return {"ROS_MASTER_URI=" + uri_, "ROS_IP=127.0.0.1", "PYTHONDONTWRITEBYTECODE=1"};
}

std::string rosIsMissing() {
    const int status = std::system("/usr/bin/python3 -c 'import actionlib, cv2, rospy, tf2_ros' 2>/dev/null");
    if (status != 0) return "ROS 1 for Python is not installed; see packaging/dependencies.txt";
    if (!std::filesystem::exists("/usr/bin/roscore")) return "there is no roscore; see packaging/dependencies.txt";
    return "";
}

std::string fakesFolder() {
    return FODSCOPE_ROS_FAKES;
}

}  // namespace fodscope
