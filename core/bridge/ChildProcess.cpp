// SPDX-License-Identifier: MIT
#include "core/bridge/ChildProcess.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <thread>

#include "core/common/Error.h"

namespace fodscope::bridge {
namespace {

constexpr int kEndsWithin_ms = 1000;

struct Pipe {
    Pipe() {
        if (::pipe2(ends, O_CLOEXEC) != 0)
            throw Error("robot bridge", std::strerror(errno), "close some programs and connect again");
    }
    ~Pipe() {
        for (const int end : ends)
            if (end >= 0) ::close(end);
    }
    int take(int which) {
        const int end = ends[which];
        ends[which] = -1;
        ::fcntl(end, F_SETFL, ::fcntl(end, F_GETFL) | O_NONBLOCK);
        return end;
    }
    int ends[2] = {-1, -1};
};

}  // namespace

ChildProcess::ChildProcess(const std::filesystem::path& program) {
    Pipe input;
    Pipe output;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input.ends[0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output.ends[1], STDOUT_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    // The thread that starts it blocks signals that the program needs.
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    std::string name = program.string();
    char* arguments[] = {name.data(), nullptr};
    const int problem = ::posix_spawn(&id_, name.c_str(), &actions, &attributes, arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (problem != 0)
        throw Error(name, std::string("it cannot be started: ") + std::strerror(problem),
                    "install Fodscope's ROS 1 bridge");
    input_ = input.take(1);
    output_ = output.take(0);
}

ChildProcess::~ChildProcess() {
    ::close(input_);
    ::close(output_);
    if (!reap(kEndsWithin_ms)) {
        kill();
        reap(-1);
    }
}

void ChildProcess::kill() {
    if (!isReaped_) ::kill(id_, SIGKILL);
}

std::string ChildProcess::ending() {
    if (!reap(kEndsWithin_ms)) return "it closed its output";
    if (WIFSIGNALED(status_)) return "it was ended by signal " + std::to_string(WTERMSIG(status_));
    return "it ended with code " + std::to_string(WEXITSTATUS(status_));
}

/// @param milliseconds how long to wait; less than 0: until it ends
bool ChildProcess::reap(int milliseconds) {
    constexpr int kStep_ms = 5;
    for (int waited = 0; !isReaped_; waited += kStep_ms) {
        isReaped_ = ::waitpid(id_, &status_, milliseconds < 0 ? 0 : WNOHANG) == id_;
        if (isReaped_ || milliseconds < 0 || waited >= milliseconds) break;
        std::this_thread::sleep_for(std::chrono::milliseconds(kStep_ms));
    }
    return isReaped_;
}

}  // namespace fodscope::bridge
