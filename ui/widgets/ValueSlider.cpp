// SPDX-License-Identifier: MIT
#include "ui/widgets/ValueSlider.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "ui/theme/Icons.h"
#include "ui/theme/Theme.h"

namespace fodscope {
namespace {

int stepsOf(const ValueRange& range) {
    return std::max(1, static_cast<int>(std::lround((range.maximum - range.minimum) / range.step)));
}

}  // namespace

ValueSlider::ValueSlider(const QString& label, const ValueRange& range, QWidget* parent) : QWidget(parent) {
    label_ = new QLabel(label, this);
    slider_ = new QSlider(Qt::Horizontal, this);
    box_ = new QDoubleSpinBox(this);
    box_->setFixedWidth(96);
    box_->setAlignment(Qt::AlignRight);
    box_->setKeyboardTracking(false);
    reset_ = new QToolButton(this);
    reset_->setIcon(icon(Icon::Retry));
    reset_->setIconSize({14, 14});
    reset_->setFocusPolicy(Qt::TabFocus);
    reset_->setVisible(false);
    label_->setBuddy(box_);
    setLabel(label);

    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setHorizontalSpacing(2 * metrics::kStep_px);
    layout->setVerticalSpacing(0);
    layout->addWidget(label_, 0, 0);
    layout->addWidget(reset_, 0, 1);
    layout->addWidget(box_, 0, 2);
    layout->addWidget(slider_, 1, 0, 1, 3);
    layout->setColumnStretch(0, 1);
    setFocusProxy(slider_);

    setRange(range);
    connect(slider_, &QSlider::valueChanged, this, &ValueSlider::takeSlider);
    connect(slider_, &QSlider::sliderReleased, this, &ValueSlider::commit);
    connect(box_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &ValueSlider::takeBox);
    connect(box_, &QDoubleSpinBox::editingFinished, this, &ValueSlider::commit);
    connect(reset_, &QToolButton::clicked, this, [this] {
        change(default_);
        commit();
    });
}

void ValueSlider::setValue(double value) {
    value_ = std::clamp(value, range_.minimum, range_.maximum);
    committed_ = value_;
    display(value_);
}

void ValueSlider::setRange(const ValueRange& range) {
    range_ = range;
    const QSignalBlocker sliderBlocker(slider_);
    const QSignalBlocker boxBlocker(box_);
    slider_->setRange(0, stepsOf(range));
    const double coarse = range.coarseStep > 0.0 ? range.coarseStep : 10.0 * range.step;
    slider_->setPageStep(std::max(1, static_cast<int>(std::lround(coarse / range.step))));
    box_->setDecimals(range.decimals);
    box_->setRange(range.minimum * range.displayFactor, range.maximum * range.displayFactor);
    box_->setSingleStep(range.step * range.displayFactor);
    box_->setSuffix(range.unit.isEmpty() ? QString() : QChar(0x202F) + range.unit);
    setValue(value_);
}

void ValueSlider::setDefaultValue(double value) {
    default_ = std::clamp(value, range_.minimum, range_.maximum);
    hasDefault_ = true;
    const QString shown = QLocale().toString(default_ * range_.displayFactor, 'f', range_.decimals);
    reset_->setToolTip(tr("Back to %1 %2").arg(shown, range_.unit));
    reset_->setAccessibleName(tr("Reset %1").arg(label_->text()));
    display(value_);
}

void ValueSlider::setHelp(const QString& help) {
    setToolTip(help);
    box_->setAccessibleDescription(help);
    slider_->setAccessibleDescription(help);
}

void ValueSlider::setLabel(const QString& label) {
    label_->setText(label);
    box_->setAccessibleName(label);
    slider_->setAccessibleName(label);
}

void ValueSlider::takeSlider(int position) {
    const double value = std::min(range_.maximum, range_.minimum + position * range_.step);
    change(value);
    // A key press or a click beside the handle is a whole act; a drag commits when it ends.
    if (!slider_->isSliderDown()) commit();
}

void ValueSlider::takeBox(double shown) {
    change(shown / range_.displayFactor);
    commit();
}

void ValueSlider::change(double value) {
    const double clamped = std::clamp(value, range_.minimum, range_.maximum);
    if (clamped == value_) return;
    value_ = clamped;
    display(value_);
    emit valueChanging(value_);
}

void ValueSlider::commit() {
    if (value_ == committed_) return;
    committed_ = value_;
    emit valueCommitted(value_);
}

void ValueSlider::display(double value) {
    const QSignalBlocker sliderBlocker(slider_);
    const QSignalBlocker boxBlocker(box_);
    slider_->setValue(static_cast<int>(std::lround((value - range_.minimum) / range_.step)));
    box_->setValue(value * range_.displayFactor);
    reset_->setVisible(hasDefault_ && std::abs(value - default_) > 1e-9 * std::max(1.0, std::abs(default_)));
}

}  // namespace fodscope
