// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <string>

#include "app/ros1_bridge/BridgeLoop.h"
#include "core/bridge/BridgeProtocol.h"

namespace {

constexpr const char* kHelp =
    "fodscope-ros1-bridge: speaks ROS 1 with a robot for the Fodscope workstation.\n"
    "\n"
    "The workstation starts it and talks to it over standard input and output; there is nothing\n"
    "to be done with it by hand. Which robot, topics, frames and services are meant is set in the\n"
    "workstation.\n"
    "\n"
    "  --help      this text\n"
    "  --version   the version of its protocol\n";

}  // namespace

int main(int argumentCount, char** arguments) {
    if (argumentCount > 1) {
        const std::string argument = arguments[1];
        if (argument == "--help") {
            std::cout << kHelp;
            return 0;
        }
        if (argument == "--version") {
            std::cout << "protocol " << fodscope::bridge::kProtocolVersion << "\n";
            return 0;
        }
        std::cerr << "error: '" << argument << "' is not known; see fodscope-ros1-bridge --help\n";
        return 2;
    }
    if (::isatty(STDIN_FILENO) != 0) {
        std::cout << kHelp;
        return 2;
    }
    std::signal(SIGPIPE, SIG_IGN);
    // A picture that claims to be larger is refused before memory is given to it.
    ::setenv("OPENCV_IO_MAX_IMAGE_PIXELS", "104857600", 1);
    // ROS prints to standard output, which is the workstation's: keep a copy, and give ROS standard error.
    const int output = ::dup(STDOUT_FILENO);
    ::dup2(STDERR_FILENO, STDOUT_FILENO);
    const int exitCode = fodscope::bridge::runBridge(STDIN_FILENO, output);
    // Threads that wait for a master or a service that is gone must not keep the program.
    ::_exit(exitCode);
}
