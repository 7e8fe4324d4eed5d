// SPDX-License-Identifier: MIT
#include "ui/settings/ParameterEditor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QStyle>

#include "ui/settings/ParameterWords.h"

namespace fodscope {
namespace {

constexpr const char* kNone = "none";

QString choiceText(const std::string& word) {
    return QCoreApplication::translate("Parameters", word.c_str());
}

}  // namespace

ParameterEditor::ParameterEditor(const ParameterField& field, QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("parameter.%1.%2")
                      .arg(QString::fromStdString(field.section), QString::fromStdString(field.key)));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    QWidget* control = nullptr;
    if (field.kind == ParameterKind::Switch) {
        control = tick_ = new QCheckBox(this);
        connect(tick_, &QCheckBox::clicked, this, [this] { emit edited(text()); });
    } else if (field.kind == ParameterKind::Choice) {
        control = choice_ = new QComboBox(this);
        for (const std::string& word : field.choices)
            choice_->addItem(choiceText(word), QString::fromStdString(word));
        choice_->installEventFilter(this);
        connect(choice_, QOverload<int>::of(&QComboBox::activated), this, [this] { emit edited(text()); });
    } else {
        control = line_ = new QLineEdit(this);
        line_->setAlignment(Qt::AlignRight);
        if (field.kind == ParameterKind::OptionalNumber) line_->setPlaceholderText(tr("none"));
        connect(line_, &QLineEdit::textEdited, this, &ParameterEditor::edited);
    }
    if (tick_ != nullptr) connect(tick_, &QCheckBox::clicked, this, [this] { emit committed(text()); });
    if (choice_ != nullptr)
        connect(choice_, QOverload<int>::of(&QComboBox::activated), this, [this] { emit committed(text()); });
    if (line_ != nullptr) connect(line_, &QLineEdit::editingFinished, this, [this] { emit committed(text()); });
    control->setAccessibleName(parameterName(field));
    control->setToolTip(parameterHelp(field));
    setFocusProxy(control);
    row->addWidget(control);
}

void ParameterEditor::setText(const QString& text) {
    if (tick_ != nullptr) {
        tick_->setChecked(text == QLatin1String("true"));
        tick_->setText(tick_->isChecked() ? tr("on") : tr("off"));
        return;
    }
    if (choice_ != nullptr) {
        choice_->setCurrentIndex(choice_->findData(text));
        return;
    }
    const QString shown = text == QLatin1String(kNone) ? QString() : text;
    // "0.10" while typing towards "0.105" means 0.1 and must stay as it was typed.
    bool wasNumber = false;
    bool isNumber = false;
    const double typed = line_->text().replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&wasNumber);
    const bool isSame = wasNumber && typed == shown.toDouble(&isNumber) && isNumber;
    if (line_->text() == shown || isSame) return;
    line_->setText(shown);
}

QString ParameterEditor::text() const {
    if (tick_ != nullptr) return tick_->isChecked() ? QStringLiteral("true") : QStringLiteral("false");
    if (choice_ != nullptr) return choice_->currentData().toString();
    return line_->text();
}

void ParameterEditor::setInvalid(bool invalid) {
    if (line_ == nullptr || line_->property("invalid").toBool() == invalid) return;
    line_->setProperty("invalid", invalid);
    line_->style()->unpolish(line_);
    line_->style()->polish(line_);
}

bool ParameterEditor::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Wheel && watched == choice_) {
        event->ignore();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace fodscope
