// SPDX-License-Identifier: MIT
#include "core/robot/RobotLink.h"

namespace fodscope {

std::string toString(LinkState state) {
    switch (state) {
        case LinkState::Disconnected:
            return "disconnected";
        case LinkState::Connecting:
            return "connecting";
        case LinkState::Connected:
            return "connected";
        case LinkState::Lost:
            return "link lost";
    }
    return "unknown";
}

std::string toString(GoalFailure failure) {
    switch (failure) {
        case GoalFailure::Rejected:
            return "rejected by the robot";
        case GoalFailure::Aborted:
            return "given up by the robot";
        case GoalFailure::Preempted:
            return "replaced by another goal";
        case GoalFailure::NotAcknowledged:
            return "not confirmed by the robot";
        case GoalFailure::TimedOut:
            return "not arrived in time";
        case GoalFailure::LinkLost:
            return "link lost";
        case GoalFailure::StopRequested:
            return "stopped";
    }
    return "unknown";
}

std::string toString(PhotoFailure failure) {
    switch (failure) {
        case PhotoFailure::Missing:
            return "the robot has no photo";
        case PhotoFailure::Corrupt:
            return "the photo is damaged";
        case PhotoFailure::TimedOut:
            return "no photo in time";
        case PhotoFailure::LinkLost:
            return "link lost";
    }
    return "unknown";
}

}  // namespace fodscope
