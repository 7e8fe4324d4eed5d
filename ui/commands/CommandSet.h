// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QPushButton>
#include <memory>
#include <vector>

#include "ui/commands/Command.h"
#include "ui/theme/Theme.h"

class QMenuBar;

namespace fodscope {

/// All commands of the window, found by their id. They keep themselves enabled or disabled.
class CommandSet : public QObject {
    Q_OBJECT

  public:
    explicit CommandSet(CommandContext context, QObject* parent = nullptr);
    ~CommandSet() override;

    /// @return the command, never null for an id that the program knows
    Command* find(const QString& id) const;
    const std::vector<Command*>& all() const { return commands_; }
    /// A button that does the command, follows its state and shows its key in the tool tip.
    QPushButton* makeButton(const QString& id, QWidget* parent, ButtonRole role = ButtonRole::Normal) const;
    void fillMenuBar(QMenuBar& menuBar) const;

  private:
    void refreshAll();
    template <typename C, typename... Args>
    void add(Args&&... args);

    CommandContext context_;
    std::vector<Command*> commands_;
};

}  // namespace fodscope
