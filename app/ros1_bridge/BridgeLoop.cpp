// SPDX-License-Identifier: MIT
#include "app/ros1_bridge/BridgeLoop.h"

#include <chrono>
#include <memory>

#include "app/ros1_bridge/MessagePipe.h"
#include "app/ros1_bridge/RobotBridge.h"
#include "core/common/Error.h"

namespace fodscope::bridge {
namespace {

constexpr int kPause_ms = 10;

double steadySeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Everything that exists once the workstation has said which robot it wants.
struct Session {
    Session(const Configure& configuration, MessagePipe& pipe)
        : parameters(configuration.parameters),
          port(makeRosPort(parameters)),
          robot(*port, parameters, configuration, [&pipe](const Event& event) { pipe.send(event); }) {}

    ParameterValues parameters;
    std::unique_ptr<RosPort> port;
    RobotBridge robot;
    MasterWatch master;
};

void begin(std::unique_ptr<Session>& session, const Configure& configuration, MessagePipe& pipe) {
    if (configuration.version != kProtocolVersion)
        throw ProtocolError("the workstation speaks another version of the protocol");
    if (session) throw ProtocolError("the workstation configured the bridge twice");
    initialiseRos(configuration.masterUri, configuration.ownAddress);
    session = std::make_unique<Session>(configuration, pipe);
}

void handleRequests(std::unique_ptr<Session>& session, MessagePipe& pipe) {
    while (const auto request = pipe.next()) {
        if (const auto* configuration = std::get_if<Configure>(&*request)) {
            begin(session, *configuration, pipe);
        } else if (session) {
            session->robot.handle(*request, steadySeconds());
        } else {
            throw ProtocolError("the workstation asked for something before it configured the bridge");
        }
    }
}

void converse(std::unique_ptr<Session>& session, MessagePipe& pipe) {
    pipe.send(Hello{kProtocolVersion, "fodscope-ros1-bridge"});
    while (!pipe.isClosed()) {
        pipe.wait(kPause_ms);
        handleRequests(session, pipe);
        if (!session) continue;
        if (const auto sighting = session->master.take()) session->robot.onMaster(*sighting, steadySeconds());
        session->robot.tick(steadySeconds());
    }
}

}  // namespace

int runBridge(int input, int output) {
    MessagePipe pipe(input, output);
    std::unique_ptr<Session> session;
    int exitCode = 0;
    try {
        converse(session, pipe);
    } catch (const std::exception& problem) {
        pipe.send(Note{std::string("the bridge ended: ") + problem.what()});
        pipe.wait(100);
        exitCode = 1;
    }
    if (session) session->robot.workstationLost();
    shutDownRos();
    return exitCode;
}

}  // namespace fodscope::bridge
