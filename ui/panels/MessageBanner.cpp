// SPDX-License-Identifier: MIT
#include "ui/panels/MessageBanner.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

#include "ui/theme/Colours.h"
#include "ui/theme/Icons.h"
#include "ui/theme/Theme.h"
#include "ui/widgets/StatusChip.h"

namespace fodscope {

MessageBanner::MessageBanner(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("banner"));
    text_ = new QLabel(this);
    text_->setObjectName(QStringLiteral("banner.text"));
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* close = new QToolButton(this);
    close->setObjectName(QStringLiteral("banner.dismiss"));
    close->setIcon(icon(Icon::Close));
    close->setAutoRaise(true);
    close->setToolTip(tr("Dismiss (Esc)"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(40, 8, 8, 8);
    row->addWidget(text_, 1);
    row->addWidget(close, 0, Qt::AlignTop);
    connect(close, &QToolButton::clicked, this, &MessageBanner::dismiss);
    hide();
}

void MessageBanner::showError(const QString& sentence) {
    text_->setText(sentence);
    show();
}

QString MessageBanner::message() const {
    return isHidden() ? QString() : text_->text();
}

void MessageBanner::dismiss() {
    hide();
}

void MessageBanner::paintEvent(QPaintEvent*) {
    const Theme theme = currentTheme();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), mixed(theme.surface1, theme.finding, 0.18));
    painter.fillRect(QRect(0, 0, 4, height()), theme.finding);
    paintStatusShape(painter, QRectF(16, (height() - 16) / 2.0, 16, 16), StatusKind::Finding, theme);
}

}  // namespace fodscope
