// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "ui/commands/Navigation.h"
#include "ui/panels/PanelParts.h"

class QLineEdit;

namespace fodscope {

class Card;
class CommandSet;
class InspectionController;
class StatusChip;

/// Step 6: what is still missing, the fields of the front page, and the issue.
class ReportPanel : public PanelColumn {
    Q_OBJECT

  public:
    ReportPanel(InspectionController& controller, const CommandSet& commands, QWidget* parent = nullptr);

  signals:
    /// Whoever has the fields must see that they changed.
    void stepRequested(fodscope::Step step);

  private:
    void refresh();
    void refreshHeader();
    void refreshMissing();
    void takeHeader();
    void tellIssued(const QString& folder);

    InspectionController& controller_;
    std::array<QLineEdit*, 5> fields_{};
    Card* missing_ = nullptr;
    StatusChip* chip_ = nullptr;
    QVBoxLayout* missingList_ = nullptr;
    QLabel* issued_ = nullptr;
};

}  // namespace fodscope
