// SPDX-License-Identifier: MIT
#pragma once

#include "ui/panels/PanelParts.h"

class QComboBox;

namespace fodscope {

class Card;
class CommandSet;
class InspectionController;

/// Step 1: where the reference comes from and what it is made of.
class ReferencePanel : public PanelColumn {
    Q_OBJECT

  public:
    ReferencePanel(InspectionController& controller, const CommandSet& commands, QWidget* parent = nullptr);

  private:
    void refresh();

    InspectionController& controller_;
    QComboBox* meshUnit_ = nullptr;
    Card* facts_ = nullptr;
    FieldList* fields_ = nullptr;
    QLabel* made_ = nullptr;
    QLabel* hint_ = nullptr;
};

}  // namespace fodscope
