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
}

}  // namespace fodscope
