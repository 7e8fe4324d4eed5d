// SPDX-License-Identifier: MIT
#include "ui/widgets/NumberReadout.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/theme/Theme.h"

namespace fodscope {

NumberReadout::NumberReadout(const QString& caption, QWidget* parent) : QWidget(parent) {
    number_ = new QLabel(this);
    unit_ = new QLabel(this);
    caption_ = new QLabel(caption, this);
    setTextRole(number_, TextRole::Number);
    setTextRole(unit_, TextRole::Muted);
    setTextRole(caption_, TextRole::Caption);
    unit_->hide();

    auto* line = new QHBoxLayout;
    line->setSpacing(metrics::kStep_px);
    line->addWidget(number_, 0, Qt::AlignBaseline);
    line->addWidget(unit_, 0, Qt::AlignBaseline);
    line->addStretch();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(line);
    layout->addWidget(caption_);
    setUnknown();
}

void NumberReadout::setNumber(const QString& number, const QString& unit) {
    number_->setText(number);
    unit_->setText(unit);
    unit_->setVisible(!unit.isEmpty());
    setAccessibleName(QStringLiteral("%1 %2 %3").arg(number, unit, caption_->text()));
}

void NumberReadout::setUnknown() {
    number_->setText(QString(QChar(0x2013)));
    unit_->hide();
    setAccessibleName(tr("%1: not known").arg(caption_->text()));
}

void NumberReadout::setCaption(const QString& caption) {
    caption_->setText(caption);
}

QString NumberReadout::number() const {
    return number_->text();
}

}  // namespace fodscope
