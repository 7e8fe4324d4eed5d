// SPDX-License-Identifier: MIT
#include "ui/panels/StepTabs.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QPainter>

#include "ui/commands/WindowCommands.h"
#include "ui/session/InspectionController.h"
#include "ui/widgets/StatusChip.h"

namespace fodscope {
namespace {

constexpr int kHeight_px = 44;
constexpr int kShape_px = 14;
constexpr int kPadding_px = 12;

}  // namespace

StepTab::StepTab(Step step, const QString& name, QWidget* parent)
    : QAbstractButton(parent), step_(step), name_(QStringLiteral("%1  %2").arg(static_cast<int>(step) + 1).arg(name)) {
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);
    setObjectName(QStringLiteral("step.%1").arg(static_cast<int>(step) + 1));
    setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
    setState(StepState::ToDo);
}

void StepTab::setState(StepState state) {
    state_ = state;
    const StateText text = stateText(state);
    setAccessibleName(QStringLiteral("%1, %2").arg(name_, text.word));
    setToolTip(QStringLiteral("%1: %2 (Ctrl+%3)").arg(name_, text.word).arg(static_cast<int>(step_) + 1));
    update();
}

QSize StepTab::sizeHint() const {
    const int name = QFontMetrics(fontFor(TextRole::Emphasis)).horizontalAdvance(name_);
    const int word = QFontMetrics(fontFor(TextRole::Caption)).horizontalAdvance(stateText(StepState::NeedsLook).word);
    return {std::max(name, word) + kShape_px + 3 * kPadding_px - 4, kHeight_px};
}

QSize StepTab::minimumSizeHint() const {
    const int name = QFontMetrics(fontFor(TextRole::Emphasis)).horizontalAdvance(name_);
    return {name + kShape_px + 2 * kPadding_px, kHeight_px};
}

void StepTab::enterEvent(QEvent* event) {
    hovered_ = true;
    update();
    QAbstractButton::enterEvent(event);
}

void StepTab::leaveEvent(QEvent* event) {
    hovered_ = false;
    update();
    QAbstractButton::leaveEvent(event);
}

void StepTab::paintEvent(QPaintEvent*) {
    const Theme theme = currentTheme();
    const StateText text = stateText(state_);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (isChecked() || hovered_) painter.fillRect(rect(), isChecked() ? theme.surface2 : theme.hover);
    if (isChecked()) painter.fillRect(QRect(0, height() - 3, width(), 3), theme.accent);
    if (hasFocus()) {
        painter.setPen(QPen(theme.accent, 1));
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
    const QRectF shape(kPadding_px - 2, (height() - kShape_px) / 2.0, kShape_px, kShape_px);
    paintStatusShape(painter, shape, text.kind, theme);
    const int left = kPadding_px + kShape_px + 6;
    painter.setPen(isEnabled() ? theme.text : theme.muted);
    painter.setFont(fontFor(isChecked() ? TextRole::Emphasis : TextRole::Body));
    painter.drawText(QRect(left, 5, width() - left, 18), Qt::AlignVCenter | Qt::AlignLeft, name_);
    painter.setPen(text.kind == StatusKind::Attention ? statusColour(theme, text.kind) : theme.muted);
    painter.setFont(fontFor(TextRole::Caption));
    painter.drawText(QRect(left, 22, width() - left, 16), Qt::AlignVCenter | Qt::AlignLeft, text.word);
}

StepTabs::StepTabs(const InspectionController& controller, QWidget* parent) : QWidget(parent), controller_(controller) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    auto* group = new QButtonGroup(this);
    for (int i = 0; i < kStepCount; ++i) {
        const auto step = static_cast<Step>(i);
        auto* tab = new StepTab(step, stepName(step), this);
        tabs_[static_cast<std::size_t>(i)] = tab;
        group->addButton(tab);
        row->addWidget(tab);
        connect(tab, &StepTab::clicked, this, [this, step] { emit stepRequested(step); });
    }
    connect(&controller, &InspectionController::stepsChanged, this, &StepTabs::refresh);
    refresh();
}

void StepTabs::setCurrent(Step step) {
    tabs_[static_cast<std::size_t>(step)]->setChecked(true);
}

void StepTabs::refresh() {
    const auto states = controller_.steps();
    for (std::size_t i = 0; i < states.size(); ++i) {
        tabs_[i]->setState(states[i]);
        tabs_[i]->setEnabled(controller_.isOpen());
    }
}

}  // namespace fodscope
