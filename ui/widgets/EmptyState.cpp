// SPDX-License-Identifier: MIT
#include "ui/widgets/EmptyState.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/theme/Theme.h"

namespace fodscope {

EmptyState::EmptyState(QWidget* parent) : QWidget(parent) {
    picture_ = new QLabel(this);
    picture_->setAlignment(Qt::AlignCenter);
    message_ = new QLabel(this);
    message_->setAlignment(Qt::AlignCenter);
    message_->setWordWrap(true);
    message_->setMaximumWidth(420);
    message_->setMinimumWidth(160);
    message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    setTextRole(message_, TextRole::Muted);
    progress_ = new QProgressBar(this);
    progress_->setTextVisible(false);
    progress_->setFixedWidth(200);
    button_ = new QPushButton(this);
    setButtonRole(button_, ButtonRole::Primary);
    second_ = new QPushButton(this);
    setButtonRole(second_, ButtonRole::Quiet);

    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(2 * metrics::kStep_px);
    buttons->addStretch();
    buttons->addWidget(button_);
    buttons->addWidget(second_);
    buttons->addStretch();

    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(message_, 8);
    row->addStretch(1);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kPanelMargin_px, metrics::kPanelMargin_px, metrics::kPanelMargin_px,
                               metrics::kPanelMargin_px);
    layout->setSpacing(metrics::kPanelMargin_px);
    layout->addStretch(2);
    layout->addWidget(picture_);
    layout->addLayout(row);
    layout->addWidget(progress_, 0, Qt::AlignHCenter);
    layout->addLayout(buttons);
    layout->addStretch(3);

    connect(button_, &QPushButton::clicked, this, &EmptyState::activated);
    connect(second_, &QPushButton::clicked, this, &EmptyState::secondActivated);
    second_->hide();
    showEmpty(Icon::Info, {});
}

EmptyState::EmptyState(const QString& message, const QString& buttonText, QWidget* parent) : EmptyState(parent) {
    showEmpty(Icon::Drop, message, buttonText);
}

void EmptyState::showEmpty(Icon picture, const QString& message, const QString& buttonText) {
    kind_ = Kind::Empty;
    pictureName_ = picture;
    message_->setText(message);
    button_->setText(buttonText);
    button_->setVisible(!buttonText.isEmpty());
    progress_->hide();
    refreshPicture();
}

void EmptyState::showLoading(const QString& message, double fraction) {
    kind_ = Kind::Loading;
    pictureName_ = Icon::Spinner;
    message_->setText(message);
    button_->hide();
    progress_->show();
    if (fraction < 0.0) {
        progress_->setRange(0, 0);
    } else {
        progress_->setRange(0, 1000);
        progress_->setValue(qRound(fraction * 1000.0));
    }
    refreshPicture();
}

void EmptyState::showError(const QString& message, const QString& buttonText) {
    showEmpty(Icon::Warning, message, buttonText);
    kind_ = Kind::Error;
    refreshPicture();
}

void EmptyState::setSecondButton(const QString& text) {
    second_->setText(text);
    second_->setVisible(!text.isEmpty());
}

void EmptyState::refreshPicture() {
    const Theme theme = currentTheme();
    const QColor colour = kind_ == Kind::Error ? theme.finding : theme.muted;
    picture_->setPixmap(iconPixmap(pictureName_, colour, 2 * metrics::kLargeIcon_px, devicePixelRatioF()));
    setTextRole(message_, kind_ == Kind::Error ? TextRole::Body : TextRole::Muted);
}

void EmptyState::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && picture_ != nullptr) refreshPicture();
    QWidget::changeEvent(event);
}

}  // namespace fodscope
