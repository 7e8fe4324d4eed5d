// SPDX-License-Identifier: MIT
#pragma once

#include <QAction>

#include "ui/commands/Navigation.h"
#include "ui/session/FileDialogs.h"
#include "ui/session/InspectionController.h"
#include "ui/theme/Icons.h"

namespace fodscope {

/// What every command acts on; outlives the commands.
struct CommandContext {
    InspectionController& controller;
    FileDialogs& files;
    Navigation& navigation;
    QWidget& window;
};

/// Something the operator can do, by menu, button, key or name. One class each.
class Command : public QAction {
  public:
    /// @param id how buttons, tests and the palette find it: "map.load"
    Command(CommandContext& context, const QString& id, const QString& text);

    virtual void run() = 0;
    /// Whether it can be done now; asked again after every change of the inspection.
    virtual bool isAvailable() const { return true; }
    /// Why it cannot be done now, when isAvailable() says no; buttons tell it in their tool tip.
    virtual QString obstacle() const { return {}; }
    /// For commands whose words depend on the state, such as undo.
    virtual void refresh();

  protected:
    InspectionController& controller() const { return context_.controller; }
    FileDialogs& files() const { return context_.files; }
    Navigation& navigation() const { return context_.navigation; }
    QWidget* window() const { return &context_.window; }

    void setKeys(const QList<QKeySequence>& keys) { setShortcuts(keys); }
    void setPicture(Icon picture) { setIcon(fodscope::icon(picture)); }

  private:
    CommandContext& context_;
};

}  // namespace fodscope
