// SPDX-License-Identifier: MIT
#include "core/robot/VisitRunner.h"

namespace fodscope {

std::string toString(VisitState state) {
    switch (state) {
        case VisitState::Draft:
            return "draft";
        case VisitState::Sent:
            return "sent";
        case VisitState::Accepted:
            return "accepted";
        case VisitState::Driving:
            return "driving";
        case VisitState::Arrived:
            return "arrived";
        case VisitState::Done:
            return "done";
        case VisitState::Failed:
            return "failed";
        case VisitState::Skipped:
            return "skipped";
    }
    return "unknown";
}

}  // namespace fodscope
