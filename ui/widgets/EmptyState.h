// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QWidget>

#include "ui/theme/Icons.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace fodscope {

/// What a panel shows when it has nothing to show: one sentence of what it needs and the button that gets it. Also its
/// loading and error states.
class EmptyState : public QWidget {
    Q_OBJECT

  public:
    explicit EmptyState(QWidget* parent = nullptr);
    EmptyState(const QString& message, const QString& buttonText, QWidget* parent = nullptr);

    /// An empty button text hides the button.
    void showEmpty(Icon picture, const QString& message, const QString& buttonText = {});
    /// A negative fraction: how long it takes is not known.
    void showLoading(const QString& message, double fraction = -1.0);
    void showError(const QString& message, const QString& buttonText = {});
    /// A second, quieter way out; empty hides it.
    void setSecondButton(const QString& text);

  signals:
    void activated();
    void secondActivated();

  protected:
    void changeEvent(QEvent* event) override;

  private:
    enum class Kind { Empty, Loading, Error };
    void refreshPicture();

    Kind kind_ = Kind::Empty;
    Icon pictureName_ = Icon::Info;
    QLabel* picture_ = nullptr;
    QLabel* message_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QPushButton* button_ = nullptr;
    QPushButton* second_ = nullptr;
};

}  // namespace fodscope
