// SPDX-License-Identifier: MIT
#include "ui/widgets/Toast.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>

#include "ui/theme/Icons.h"
#include "ui/widgets/StatusChip.h"

namespace fodscope {
namespace {

constexpr int kMaximumWidth_px = 640;
constexpr double kShape_px = 14.0;

}  // namespace

Toast::Toast(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::NoFocus);
    text_ = new QLabel(this);
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    action_ = new QPushButton(this);
    setButtonRole(action_, ButtonRole::Quiet);
    close_ = new QToolButton(this);
    close_->setIcon(icon(Icon::Close));
    close_->setAccessibleName(tr("Close the message"));
    close_->setFocusPolicy(Qt::NoFocus);
    action_->setFocusPolicy(Qt::NoFocus);
    timer_ = new QTimer(this);
    timer_->setSingleShot(true);

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(40, 8, 8, 8);
    layout->setSpacing(2 * metrics::kStep_px);
    layout->addWidget(text_, 1);
    layout->addWidget(action_);
    layout->addWidget(close_);

    connect(timer_, &QTimer::timeout, this, &Toast::hide);
    connect(close_, &QToolButton::clicked, this, &Toast::hide);
    connect(action_, &QPushButton::clicked, this, [this] {
        hide();
        emit actionTriggered();
    });
    parent->installEventFilter(this);
    hide();
}

void Toast::showMessage(StatusKind kind, const QString& message, const QString& actionText) {
    kind_ = kind;
    text_->setText(message);
    action_->setText(actionText);
    action_->setVisible(!actionText.isEmpty());
    timer_->stop();
    if (kind != StatusKind::Finding) timer_->start(duration_ms_);
    place();
    show();
    raise();
    update();
}

QString Toast::message() const {
    return text_->text();
}

void Toast::setBottomMargin(int margin_px) {
    bottomMargin_px_ = margin_px;
    place();
}

void Toast::place() {
    const QWidget* over = parentWidget();
    const int room = std::min(kMaximumWidth_px, over->width() - 2 * metrics::kPanelMargin_px);
    const int margins =
        48 + 3 * 8 + close_->sizeHint().width() + (action_->isHidden() ? 0 : action_->sizeHint().width() + 8);
    const int textWidth = text_->fontMetrics().horizontalAdvance(text_->text()) + 8;
    const int wanted = std::min(room, textWidth + margins);
    const int tall = std::max(44, layout()->heightForWidth(wanted));
    setGeometry((over->width() - wanted) / 2, over->height() - bottomMargin_px_ - tall, wanted, tall);
}

bool Toast::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && isVisible()) place();
    return QWidget::eventFilter(watched, event);
}

void Toast::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme theme = currentTheme();
    painter.setBrush(theme.surface2);
    painter.setPen(QPen(kind_ == StatusKind::Finding ? theme.finding : theme.line, 1.0));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), metrics::kRadius_px, metrics::kRadius_px);
    paintStatusShape(painter, QRectF(14.0, (height() - kShape_px) / 2.0, kShape_px, kShape_px), kind_, theme);
}

}  // namespace fodscope
