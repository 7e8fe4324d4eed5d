// SPDX-License-Identifier: MIT
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QThreadPool>
#include <deque>
#include <functional>
#include <memory>
#include <optional>

#include "core/common/Progress.h"

namespace fodscope {

/// Where a long task is.
struct TaskReport {
    QString task;
    QString stage;
    double fraction = 0.0;
    std::optional<double> secondsLeft;
};

/// Runs long work off the GUI thread, one task after the other. A cancelled task is given up at once for whoever
/// watches, though its thread may take a moment to notice; what it brings is then thrown away.
class TaskRunner : public QObject {
    Q_OBJECT

  public:
    /// Takes the result over; runs on the GUI thread.
    using Adopt = std::function<void()>;
    /// Runs on the worker thread and hands back what is to be done with its result.
    using Work = std::function<Adopt(Progress&)>;

    explicit TaskRunner(QObject* parent = nullptr);
    ~TaskRunner() override;

    /// @param task its name in words, as the status bar shows it ("loading the map")
    void run(const QString& task, Work work);

    bool isBusy() const { return current_ != nullptr; }
    QString currentTask() const;

    /// Gives up the task under way and those that wait.
    void cancel();

  signals:
    void started(const QString& task);
    void progressed(const fodscope::TaskReport& report);
    void succeeded(const QString& task);
    void cancelled(const QString& task);
    void failed(const QString& task, const QString& sentence);
    /// After each of the three above, when nothing more waits.
    void idle();

  private:
    struct Task;

    void startNext();
    void reportProgress(int number, const QString& stage, double fraction);
    void finish(int number, const Adopt& adopt, const QString& error, bool wasCancelled);

    QThreadPool thread_;
    std::deque<std::shared_ptr<Task>> waiting_;
    std::shared_ptr<Task> current_;
    int lastNumber_ = 0;
    QElapsedTimer stageClock_;
    QString stage_;
};

/// @return the sentence of an exception for people; out of memory and unknown ones get one too
QString sentenceOf(const std::exception& error);

}  // namespace fodscope

Q_DECLARE_METATYPE(fodscope::TaskReport)
