// SPDX-License-Identifier: MIT
#pragma once

#include <QAbstractButton>
#include <QWidget>
#include <array>

#include "ui/panels/Format.h"

namespace fodscope {

class InspectionController;

/// One step in the title row: number, name, its state as shape and word.
class StepTab : public QAbstractButton {
    Q_OBJECT

  public:
    StepTab(Step step, const QString& name, QWidget* parent);

    void setState(StepState state);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEvent* event) override;
    void leaveEvent(QEvent* event) override;

  private:
    Step step_;
    QString name_;
    StepState state_ = StepState::ToDo;
    bool hovered_ = false;
};

/// The row of the six steps.
class StepTabs : public QWidget {
    Q_OBJECT

  public:
    explicit StepTabs(const InspectionController& controller, QWidget* parent = nullptr);

    void setCurrent(Step step);

  signals:
    void stepRequested(fodscope::Step step);

  private:
    void refresh();

    const InspectionController& controller_;
    std::array<StepTab*, kStepCount> tabs_{};
};

}  // namespace fodscope
