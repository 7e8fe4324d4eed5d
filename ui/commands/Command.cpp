// SPDX-License-Identifier: MIT
#include "ui/commands/Command.h"

namespace fodscope {

Command::Command(CommandContext& context, const QString& id, const QString& text)
    : QAction(text, &context.window), context_(context) {
    setObjectName(id);
    connect(this, &QAction::triggered, this, [this] { run(); });
}

void Command::refresh() {
    setEnabled(isAvailable());
    // Buttons follow the action's changes, and the reason may change while it stays disabled.
    setWhatsThis(isEnabled() ? QString() : obstacle());
}

}  // namespace fodscope
