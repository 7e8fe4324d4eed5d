// SPDX-License-Identifier: MIT
#pragma once

#include "ui/panels/PanelParts.h"

class QLineEdit;

namespace fodscope {

class CommandSet;
class InspectionController;
class NumberReadout;

/// Step 5, left of the photo: who labels, with which labels, and how far they are.
class LabelPanel : public PanelColumn {
    Q_OBJECT

  public:
    LabelPanel(InspectionController& controller, const CommandSet& commands, QWidget* parent = nullptr);

  private:
    void refresh();

    InspectionController& controller_;
    QLineEdit* labeller_ = nullptr;
    NumberReadout* left_ = nullptr;
    FieldList* counts_ = nullptr;
    FieldList* set_ = nullptr;
};

}  // namespace fodscope
