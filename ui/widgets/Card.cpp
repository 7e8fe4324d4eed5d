// SPDX-License-Identifier: MIT
#include "ui/widgets/Card.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/theme/Icons.h"
#include "ui/theme/Theme.h"

namespace fodscope {

Card::Card(const QString& title, QWidget* parent) : QWidget(parent) {
    title_ = new QLabel(title, this);
    setTextRole(title_, TextRole::Heading);
    caption_ = new QLabel(this);
    caption_->setWordWrap(true);
    caption_->hide();
    setTextRole(caption_, TextRole::Caption);
    fold_ = new QToolButton(this);
    fold_->setAccessibleName(tr("Fold %1").arg(title));
    fold_->hide();
    content_ = new QWidget(this);

    header_ = new QHBoxLayout;
    header_->setSpacing(2 * metrics::kStep_px);
    header_->addWidget(title_);
    header_->addStretch();
    header_->addWidget(fold_);

    body_ = new QVBoxLayout(content_);
    body_->setContentsMargins(0, 0, 0, 0);
    body_->setSpacing(2 * metrics::kStep_px);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kPanelMargin_px, metrics::kPanelMargin_px, metrics::kPanelMargin_px,
                               metrics::kPanelMargin_px);
    layout->setSpacing(2 * metrics::kStep_px);
    layout->addLayout(header_);
    layout->addWidget(caption_);
    layout->addWidget(content_);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);

    connect(fold_, &QToolButton::clicked, this, [this] { setCollapsed(!isCollapsed()); });
}

void Card::setTitle(const QString& title) {
    title_->setText(title);
    fold_->setAccessibleName(tr("Fold %1").arg(title));
}

void Card::addHeaderWidget(QWidget* widget) {
    header_->insertWidget(header_->indexOf(fold_), widget);
}

void Card::setCaption(const QString& caption) {
    caption_->setText(caption);
    caption_->setVisible(!caption.isEmpty());
}

void Card::setCollapsible(bool collapsible) {
    fold_->setVisible(collapsible);
    fold_->setIcon(icon(isCollapsed() ? Icon::ChevronRight : Icon::ChevronDown));
    if (!collapsible) setCollapsed(false);
}

void Card::setCollapsed(bool collapsed) {
    if (collapsed == isCollapsed()) return;
    content_->setHidden(collapsed);
    fold_->setIcon(icon(collapsed ? Icon::ChevronRight : Icon::ChevronDown));
    emit collapsedChanged(collapsed);
}

bool Card::isCollapsed() const {
    return content_->isHidden();
}

}  // namespace fodscope
