// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

#include "ui/session/Steps.h"

class QLabel;

namespace fodscope {

class InspectionController;
class StepTabs;

/// The top row: what is inspected, and the six steps.
class TitleRow : public QWidget {
    Q_OBJECT

  public:
    explicit TitleRow(const InspectionController& controller, QWidget* parent = nullptr);

    void setCurrent(Step step);

  signals:
    void stepRequested(fodscope::Step step);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void refresh();

    const InspectionController& controller_;
    QLabel* title_ = nullptr;
    QLabel* detail_ = nullptr;
    StepTabs* tabs_ = nullptr;
};

}  // namespace fodscope
