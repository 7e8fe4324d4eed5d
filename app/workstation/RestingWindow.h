// SPDX-License-Identifier: MIT
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>

class QWidget;

namespace fodscope {

/// Tells when a window has come to rest: nothing in it was painted for a moment, or it has moved for long enough that a
/// picture of it is as good now as later.
class RestingWindow : public QObject {
    Q_OBJECT

  public:
    explicit RestingWindow(QWidget& window);

    void then(std::function<void()> action);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void look();

    QWidget& window_;
    QElapsedTimer sinceAsked_;
    QElapsedTimer sincePainted_;
    QTimer timer_;
    std::function<void()> action_;
};

}  // namespace fodscope
