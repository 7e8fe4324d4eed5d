// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QWidget>

#include "ui/theme/Theme.h"

namespace fodscope {

/// A state as colour, shape and word: "● driving to W-04".
class StatusChip : public QWidget {
    Q_OBJECT

  public:
    explicit StatusChip(QWidget* parent = nullptr);
    StatusChip(StatusKind kind, const QString& text, QWidget* parent = nullptr);

    void setStatus(StatusKind kind, const QString& text);
    StatusKind kind() const { return kind_; }
    QString text() const { return text_; }
    /// Muted words after the text, such as the age of a value ("0.2 s old").
    void setDetail(const QString& detail);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    StatusKind kind_ = StatusKind::Neutral;
    QString text_;
    QString detail_;
};

/// The shape of a state, also for tabs, table cells and thumbnails: ring, spinner, dot, tick, filled warning, hatch.
void paintStatusShape(QPainter& painter, const QRectF& area, StatusKind kind, const Theme& theme);

}  // namespace fodscope
