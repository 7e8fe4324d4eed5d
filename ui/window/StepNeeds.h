// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <optional>

#include "ui/session/InspectionController.h"
#include "ui/theme/Icons.h"

namespace fodscope {

/// What a step lacks before it can show anything, and the command that gets it.
struct StepNeed {
    Icon picture = Icon::Info;
    QString sentence;
    QString buttonText;
    QString commandId;
    QString secondText;
    QString secondCommandId;
};

/// @return empty when the step has what it needs
std::optional<StepNeed> needOf(Step step, const InspectionController& controller);

}  // namespace fodscope
