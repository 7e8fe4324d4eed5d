// SPDX-License-Identifier: MIT
#pragma once

#include "ui/panels/PanelParts.h"

namespace fodscope {

class Card;
class CommandSet;
class InspectionController;
class PoseList;
class StatusChip;

/// Step 2: the map under inspection and how it lies on the reference.
class MapPanel : public PanelColumn {
    Q_OBJECT

  public:
    MapPanel(InspectionController& controller, const CommandSet& commands, QWidget* parent = nullptr);

  private:
    void refresh();
    void refreshMap();
    void refreshAlignment();

    InspectionController& controller_;
    QLabel* hint_ = nullptr;
    FieldList* fields_ = nullptr;
    QLabel* warning_ = nullptr;
    Card* alignment_ = nullptr;
    StatusChip* quality_ = nullptr;
    QLabel* sentence_ = nullptr;
    QLabel* remedy_ = nullptr;
    FieldList* measures_ = nullptr;
    PoseList* poses_ = nullptr;
};

}  // namespace fodscope
