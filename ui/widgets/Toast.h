// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QWidget>

#include "ui/theme/Theme.h"

class QLabel;
class QPushButton;
class QTimer;
class QToolButton;

namespace fodscope {

/// A message over the lower edge of its parent that takes no focus: "Set aside C-004. Undo". One at a time: the next
/// message replaces it. Findings (errors) stay until they are closed, others leave by themselves.
class Toast : public QWidget {
    Q_OBJECT

  public:
    explicit Toast(QWidget* parent);

    void showMessage(StatusKind kind, const QString& message, const QString& actionText = {});
    QString message() const;
    /// How long messages other than errors stay.
    void setDuration(int duration_ms) { duration_ms_ = duration_ms; }
    /// Room to leave free at the parent's lower edge, for a status bar.
    void setBottomMargin(int margin_px);

  signals:
    void actionTriggered();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    void place();

    StatusKind kind_ = StatusKind::Neutral;
    int duration_ms_ = 6000;
    int bottomMargin_px_ = 48;
    QLabel* text_ = nullptr;
    QPushButton* action_ = nullptr;
    QToolButton* close_ = nullptr;
    QTimer* timer_ = nullptr;
};

}  // namespace fodscope
