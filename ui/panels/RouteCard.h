// SPDX-License-Identifier: MIT
#pragma once

#include "ui/widgets/Card.h"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace fodscope {

class CommandSet;
class InspectionController;
class StatusChip;

/// The inspection route: its poses in their order, what became of each, and what can be done with the one selected.
class RouteCard : public Card {
    Q_OBJECT

  public:
    RouteCard(InspectionController& controller, const CommandSet& commands, QWidget* parent = nullptr);

  private:
    void makeList();
    QPushButton* makePoseButton(const QString& name, const QString& text, const QString& toolTip);
    void refresh();
    void refreshButtons();
    int selectedRow() const;
    void move(int step);
    void remove();
    void togglePhoto();

    InspectionController& controller_;
    StatusChip* chip_ = nullptr;
    QLabel* hint_ = nullptr;
    QTreeWidget* list_ = nullptr;
    QWidget* poseButtons_ = nullptr;
    QPushButton* up_ = nullptr;
    QPushButton* down_ = nullptr;
    QPushButton* photo_ = nullptr;
    QPushButton* remove_ = nullptr;
    bool filling_ = false;
};

}  // namespace fodscope
