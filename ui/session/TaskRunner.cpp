// SPDX-License-Identifier: MIT
#include "ui/session/TaskRunner.h"

#include <QCoreApplication>
#include <QMetaObject>
#include <QRunnable>
#include <atomic>
#include <new>
#include <utility>

#include "core/common/Error.h"

namespace fodscope {
namespace {

constexpr qint64 kReportEvery_ms = 50;

class Job : public QRunnable {
  public:
    explicit Job(std::function<void()> work) : work_(std::move(work)) {}
    void run() override { work_(); }

  private:
    std::function<void()> work_;
};

/// Lets through the first report of each stage and then one every 50 ms: the GUI has better things to do.
class ReportFilter {
  public:
    bool lets(const std::string& stage) {
        if (stage == stage_ && clock_.isValid() && clock_.elapsed() < kReportEvery_ms) return false;
        stage_ = stage;
        clock_.start();
        return true;
    }

  private:
    std::string stage_;
    QElapsedTimer clock_;
};

}  // namespace

struct TaskRunner::Task {
    int number = 0;
    QString name;
    Work work;
    std::shared_ptr<Progress> progress;
};

QString sentenceOf(const std::exception& error) {
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
        return QCoreApplication::translate(
            "fodscope", "Memory: not enough of it is free for this; close other programs or load a smaller cloud");
    return QString::fromUtf8(error.what());
}

TaskRunner::TaskRunner(QObject* parent) : QObject(parent) {
    thread_.setMaxThreadCount(1);
    thread_.setExpiryTimeout(-1);
}

TaskRunner::~TaskRunner() {
    waiting_.clear();
    if (current_) current_->progress->cancel();
    thread_.waitForDone();
}

void TaskRunner::run(const QString& task, Work work) {
    auto queued = std::make_shared<Task>();
    queued->number = ++lastNumber_;
    queued->name = task;
    queued->work = std::move(work);
    const int number = queued->number;
    queued->progress = std::make_shared<Progress>([this, number, filter = std::make_shared<ReportFilter>()](
                                                      const std::string& stage, double fraction) {
        if (!filter->lets(stage)) return;
        QMetaObject::invokeMethod(
            this,
            [this, number, text = QString::fromStdString(stage), fraction] { reportProgress(number, text, fraction); },
            Qt::QueuedConnection);
    });
    waiting_.push_back(std::move(queued));
    if (!current_) startNext();
}

QString TaskRunner::currentTask() const {
    return current_ ? current_->name : QString();
}

void TaskRunner::cancel() {
    waiting_.clear();
    if (!current_) return;
    current_->progress->cancel();
    const QString name = current_->name;
    current_.reset();
    emit cancelled(name);
    if (!current_) emit idle();
}

void TaskRunner::startNext() {
    if (waiting_.empty()) {
        emit idle();
        return;
    }
    current_ = waiting_.front();
    waiting_.pop_front();
    stage_.clear();
    const auto task = current_;
    emit started(task->name);
    thread_.start(new Job([this, task] {
        Adopt adopt;
        QString error;
        bool wasCancelled = false;
        try {
            task->progress->throwIfCancelled();
            adopt = task->work(*task->progress);
        } catch (const Cancelled&) {
            wasCancelled = true;
        } catch (const std::exception& failure) {
            error = sentenceOf(failure);
        }
        task->work = nullptr;
        QMetaObject::invokeMethod(
            this,
            [this, number = task->number, adopt, error, wasCancelled] { finish(number, adopt, error, wasCancelled); },
            Qt::QueuedConnection);
    }));
}

void TaskRunner::reportProgress(int number, const QString& stage, double fraction) {
    if (!current_ || current_->number != number) return;
    if (stage != stage_) {
        stage_ = stage;
        stageClock_.start();
    }
    TaskReport report{current_->name, stage, fraction, std::nullopt};
    const double elapsed_s = static_cast<double>(stageClock_.elapsed()) / 1000.0;
    if (elapsed_s > 0.5 && fraction > 0.02) report.secondsLeft = elapsed_s * (1.0 - fraction) / fraction;
    emit progressed(report);
}

void TaskRunner::finish(int number, const Adopt& adopt, const QString& error, bool wasCancelled) {
    if (!current_ || current_->number != number) return;
    const QString name = current_->name;
    QString problem = error;
    if (!wasCancelled && problem.isEmpty() && adopt) {
        try {
            adopt();
        } catch (const std::exception& failure) {
            problem = sentenceOf(failure);
        }
    }
    current_.reset();
    if (wasCancelled) {
        emit cancelled(name);
    } else if (!problem.isEmpty()) {
        waiting_.clear();
        emit failed(name, problem);
    } else {
        emit succeeded(name);
    }
    if (!current_) startNext();
}

}  // namespace fodscope
