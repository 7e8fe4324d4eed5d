// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <optional>

#include "app/robot_simulator/OwnRoscore.h"
#include "app/robot_simulator/ros/RobotNode.h"
#include "core/common/Version.h"

namespace {

enum ExitCode { kDone = 0, kInputAtFault = 1 };

constexpr const char* kHelp =
    "A ROS 1 robot like the paper's, simulated: to try a whole inspection over ROS on one machine.\n"
    "Parameters (_NAME:=VALUE) and faults are in the manual, under \"Trying it on one machine\".";

/// ROS's own arguments hold ":=".
bool isForRos(const std::string& argument) {
    return argument.find(":=") != std::string::npos;
}

/// roscpp cannot register with another master; a new process can.
[[noreturn]] void beginAgain(const std::vector<std::string>& arguments) {
    std::vector<char*> argv;
    for (const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    execv("/proc/self/exe", argv.data());
    throw std::runtime_error("robot simulator: it could not start itself again; start it by hand");
}

}  // namespace

int main(int argc, char** argv) {
    // What ROS logs goes there, and whoever reads it through a pipe wants it at once.
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
    const std::vector<std::string> arguments(argv, argv + argc);
    std::vector<std::string> own;
    for (auto argument = arguments.rbegin(); argument + 1 != arguments.rend(); ++argument)
        if (!isForRos(*argument)) own.push_back(*argument);

    fodscope::robot_simulator::ModelSettings settings;
    CLI::App program(kHelp, "fodscope-robot-simulator");
    program.set_version_flag("--version", fodscope::kVersion);
    bool withRoscore = false;
    program.add_flag("--roscore", withRoscore, "start a roscore too, unless a master answers already");
    program.add_option("--world", settings.world, "builtin, or a world file")->capture_default_str();
    try {
        program.parse(own);
    } catch (const CLI::ParseError& stop) {
        return program.exit(stop) == 0 ? 0 : 2;
    }
    try {
        std::optional<fodscope::robot_simulator::OwnRoscore> roscore;
        if (withRoscore) roscore.emplace();
        if (const auto again = fodscope::robot_simulator::runRobotNode(arguments, settings)) beginAgain(*again);
        return kDone;
    } catch (const std::exception& problem) {
        std::cerr << "error: " << problem.what() << "\n";
        return kInputAtFault;
    }
}
