// SPDX-License-Identifier: MIT
#include "ui/labelling/LabellerPrompt.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "ui/theme/Theme.h"

namespace fodscope {

LabellerPrompt::LabellerPrompt(QWidget* parent) : QWidget(parent), name_(new QLineEdit(this)) {
    auto* question = new QLabel(tr("Who is labelling?"), this);
    setTextRole(question, TextRole::Emphasis);
    question->setBuddy(name_);
    name_->setObjectName(QStringLiteral("labellerName"));
    name_->setPlaceholderText(tr("your name, kept with every decision"));
    name_->setMaxLength(80);
    name_->setFixedHeight(metrics::kControlHeight_px);
    auto* begin = new QPushButton(tr("Begin labelling"), this);
    begin->setObjectName(QStringLiteral("beginLabelling"));
    setButtonRole(begin, ButtonRole::Primary);
    begin->setEnabled(false);

    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kPanelMargin_px);
    row->addWidget(question);
    row->addWidget(name_, 1);
    row->addWidget(begin);

    connect(name_, &QLineEdit::textChanged, this,
            [begin](const QString& text) { begin->setEnabled(!text.trimmed().isEmpty()); });
    connect(name_, &QLineEdit::returnPressed, this, &LabellerPrompt::confirm);
    connect(begin, &QPushButton::clicked, this, &LabellerPrompt::confirm);
}

void LabellerPrompt::takeFocus() {
    name_->setFocus();
}

void LabellerPrompt::confirm() {
    const QString name = name_->text().simplified();
    if (!name.isEmpty()) emit named(name);
}

}  // namespace fodscope
