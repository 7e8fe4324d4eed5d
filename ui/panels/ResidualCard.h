// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "ui/widgets/Card.h"

class QLabel;
class QListWidget;

namespace fodscope {

class CommandSet;
class InspectionController;

/// What is left between map and reference after the alignment: the worst regions in words; a click flies there.
class ResidualCard : public Card {
    Q_OBJECT

  public:
    ResidualCard(InspectionController& controller, const CommandSet& commands, QWidget* parent = nullptr);

  private:
    void refresh();
    void flyTo(int row);

    InspectionController& controller_;
    const CommandSet& commands_;
    QLabel* sentence_ = nullptr;
    QListWidget* list_ = nullptr;
    /// Of each row its region.
    std::vector<std::size_t> regions_;
};

}  // namespace fodscope
