// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QSlider;
class QToolButton;

namespace fodscope {

/// Values are kept in the program's unit (metres) and shown times `displayFactor` in `unit` (cm: 100).
struct ValueRange {
    double minimum = 0.0;
    double maximum = 1.0;
    double step = 0.01;
    /// Page up/down and Shift+arrow; 0: ten steps.
    double coarseStep = 0.0;
    QString unit;
    double displayFactor = 1.0;
    int decimals = 2;
};

/// A named number: slider and number box in one. The number box takes values between the slider's steps.
class ValueSlider : public QWidget {
    Q_OBJECT

  public:
    ValueSlider(const QString& label, const ValueRange& range, QWidget* parent = nullptr);

    /// Clamped to the range; no signal is sent.
    void setValue(double value);
    double value() const { return value_; }
    void setRange(const ValueRange& range);
    /// Shows a button to go back when the value differs.
    void setDefaultValue(double value);
    /// Tool tip: what it does and where the default comes from.
    void setHelp(const QString& help);
    void setLabel(const QString& label);

  signals:
    /// While dragging or typing.
    void valueChanging(double value);
    /// When the slider is let go, a key was pressed, or the box was left or confirmed; only after a change.
    void valueCommitted(double value);

  private:
    void takeSlider(int position);
    void takeBox(double shown);
    void change(double value);
    void commit();
    void display(double value);

    ValueRange range_;
    double value_ = 0.0;
    double committed_ = 0.0;
    double default_ = 0.0;
    bool hasDefault_ = false;
    QLabel* label_ = nullptr;
    QSlider* slider_ = nullptr;
    QDoubleSpinBox* box_ = nullptr;
    QToolButton* reset_ = nullptr;
};

}  // namespace fodscope
