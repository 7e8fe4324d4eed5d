// SPDX-License-Identifier: MIT
#include "app/robot_simulator/OwnRoscore.h"

#include <netdb.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <memory>
#include <regex>
#include <string>

#include "core/common/Error.h"

namespace fodscope::robot_simulator {
namespace {

struct Address {
    std::string host;
    std::string port;
};

Address masterAddress() {
    const char* uri = std::getenv("ROS_MASTER_URI");
    const std::string text = uri && *uri ? uri : "http://localhost:11311";
    std::smatch parts;
    if (!std::regex_match(text, parts, std::regex("http://([^:/]+):([0-9]+)/?")))
        throw Error("ROS_MASTER_URI", "'" + text + "' is no address of a master", "give http://HOST:PORT");
    return {parts[1], parts[2]};
}

bool answers(const Address& address) {
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    if (getaddrinfo(address.host.c_str(), address.port.c_str(), &hints, &found) != 0) return false;
    const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> list(found, freeaddrinfo);
    for (const addrinfo* one = list.get(); one; one = one->ai_next) {
        const int probe = socket(one->ai_family, one->ai_socktype | SOCK_CLOEXEC, one->ai_protocol);
        if (probe < 0) continue;
        const bool isOpen = connect(probe, one->ai_addr, one->ai_addrlen) == 0;
        close(probe);
        if (isOpen) return true;
    }
    return false;
}

bool isThisMachine(const std::string& host) {
    char name[256] = {};
    gethostname(name, sizeof(name) - 1);
    return host == "localhost" || host.rfind("127.", 0) == 0 || host == name;
}

}  // namespace

OwnRoscore::OwnRoscore() {
    const Address address = masterAddress();
    if (answers(address)) return;
    if (!isThisMachine(address.host))
        throw Error("ROS_MASTER_URI", "no master answers at " + address.host + ", which is another machine",
                    "start one there, or set ROS_MASTER_URI to http://localhost:11311");
    process_ = fork();
    if (process_ < 0) throw Error("roscore", "it could not be started", "start it by hand");
    if (process_ > 0) return;
    // It must not outlive this program, however that ends; a Ctrl+C at the terminal is for this program to pass on.
    // A shell's background job has it ignored, and rosmaster would not hear it.
    signal(SIGINT, SIG_DFL);
    prctl(PR_SET_PDEATHSIG, SIGINT);
    setpgid(0, 0);
    execlp("roscore", "roscore", "-p", address.port.c_str(), static_cast<char*>(nullptr));
    static constexpr char kMissing[] = "error: roscore: it is not installed or not on the PATH; install ros-core\n";
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kMissing, sizeof(kMissing) - 1);
    _exit(1);
}

OwnRoscore::~OwnRoscore() {
    if (process_ <= 0) return;
    kill(process_, SIGINT);
    waitpid(process_, nullptr, 0);
}

}  // namespace fodscope::robot_simulator
