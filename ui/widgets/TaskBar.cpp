// SPDX-License-Identifier: MIT
#include "ui/widgets/TaskBar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "ui/theme/Icons.h"
#include "ui/theme/Theme.h"

namespace fodscope {
namespace {

/// Before that the guess is worth nothing.
constexpr double kLeastFractionForGuess = 0.08;
constexpr double kLeastTimeForGuess_s = 0.7;

}  // namespace

QString roughDuration(double seconds) {
    const int whole = std::max(1, static_cast<int>(std::ceil(seconds)));
    if (whole < 60) return TaskBar::tr("%1 s").arg(whole);
    const int minutes = whole / 60;
    const int rest = (whole % 60) / 10 * 10;
    if (minutes >= 10 || rest == 0) return TaskBar::tr("%1 min").arg(minutes);
    return TaskBar::tr("%1 min %2 s").arg(minutes).arg(rest);
}

TaskBar::TaskBar(QWidget* parent) : QWidget(parent) {
    text_ = new QLabel(this);
    bar_ = new QProgressBar(this);
    bar_->setTextVisible(false);
    bar_->setFixedWidth(120);
    cancel_ = new QToolButton(this);
    cancel_->setIcon(icon(Icon::Close));
    cancel_->setToolTip(tr("Cancel this task"));
    cancel_->setAccessibleName(tr("Cancel this task"));

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2 * metrics::kStep_px);
    layout->addWidget(bar_);
    layout->addWidget(text_);
    layout->addWidget(cancel_);
    connect(cancel_, &QToolButton::clicked, this, [this] {
        setCancelling();
        emit cancelRequested();
    });
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    hide();
}

void TaskBar::setTask(const QString& stage, double fraction) {
    if (!running_ || stage != stage_) {
        stage_ = stage;
        clock_.restart();
    }
    running_ = true;
    show();
    if (cancelling_) return;
    if (fraction < 0.0) {
        bar_->setRange(0, 0);
        text_->setText(stage);
        return;
    }
    const double share = std::clamp(fraction, 0.0, 1.0);
    bar_->setRange(0, 1000);
    bar_->setValue(static_cast<int>(std::lround(share * 1000.0)));
    QString words = tr("%1 %2 %").arg(stage).arg(static_cast<int>(share * 100.0));
    const double elapsed_s = static_cast<double>(clock_.elapsed()) / 1000.0;
    if (share > kLeastFractionForGuess && share < 1.0 && elapsed_s > kLeastTimeForGuess_s) {
        words = tr("%1, %2 left").arg(words, roughDuration(elapsed_s * (1.0 - share) / share));
    }
    text_->setText(words);
}

void TaskBar::setCancellable(bool cancellable) {
    cancel_->setVisible(cancellable);
}

void TaskBar::setCancelling() {
    cancelling_ = true;
    cancel_->setEnabled(false);
    bar_->setRange(0, 0);
    text_->setText(tr("cancelling %1 …").arg(stage_));
}

void TaskBar::finish() {
    running_ = false;
    cancelling_ = false;
    cancel_->setEnabled(true);
    stage_.clear();
    hide();
}

}  // namespace fodscope
