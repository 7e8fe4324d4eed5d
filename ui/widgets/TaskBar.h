// SPDX-License-Identifier: MIT
#pragma once

#include <QElapsedTimer>
#include <QString>
#include <QWidget>

class QLabel;
class QProgressBar;
class QToolButton;

namespace fodscope {

/// The running task in the status bar: "smoothing the discrepancy 63 %, 2 s left" and a button to cancel. Hidden when
/// nothing runs.
class TaskBar : public QWidget {
    Q_OBJECT

  public:
    explicit TaskBar(QWidget* parent = nullptr);

    /// A negative fraction: how long it takes is not known. The first call of a stage starts its clock.
    void setTask(const QString& stage, double fraction);
    void setCancellable(bool cancellable);
    /// "cancelling …" until finish().
    void setCancelling();
    void finish();
    bool isRunning() const { return running_; }

  signals:
    void cancelRequested();

  private:
    QString stage_;
    QElapsedTimer clock_;
    bool running_ = false;
    bool cancelling_ = false;
    QLabel* text_ = nullptr;
    QProgressBar* bar_ = nullptr;
    QToolButton* cancel_ = nullptr;
};

/// @return "2 s", "1 min 20 s"; rough on purpose
QString roughDuration(double seconds);

}  // namespace fodscope
