// SPDX-License-Identifier: MIT
#include "app/workstation/Autopilot.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPixmap>
#include <QSlider>
#include <utility>

#include "ui/commands/CommandSet.h"
#include "ui/window/MainWindow.h"

namespace fodscope {
namespace {

/// Longest time without anything happening before something must be wrong.
constexpr int kStalledAfter_ms = 120000;
constexpr int kThresholdSteps = 12;

void press(QWidget& widget, int key, Qt::KeyboardModifiers modifiers, const QString& text) {
    QKeyEvent down(QEvent::KeyPress, key, modifiers, text);
    QApplication::sendEvent(&widget, &down);
    QKeyEvent up(QEvent::KeyRelease, key, modifiers, text);
    QApplication::sendEvent(&widget, &up);
}

void removeOldSession(const QString& file) {
    for (const char* ending : {"", "-wal", "-shm"})
        QFile::remove(file + QString::fromLatin1(ending));
}

}  // namespace

Autopilot::Autopilot(MainWindow& window, InspectionController& controller, const QString& folder)
    : QObject(&window), window_(window), controller_(controller), folder_(folder), rest_(window) {
    connect(&controller, &InspectionController::errorRaised, this, &Autopilot::fail);
    connect(&controller, &InspectionController::builtinTankReady, this, [this] { tankReady_ = true; });
    connect(&controller, &InspectionController::reportIssued, this, [this] { reportReady_ = true; });
    // What happened must first have reached the panels: look once they had their turn.
    for (const auto signal : {&InspectionController::builtinTankReady, &InspectionController::candidatesChanged,
                              &InspectionController::planChanged, &InspectionController::visitsChanged,
                              &InspectionController::photosChanged, &InspectionController::decisionsChanged,
                              &InspectionController::stepsChanged, &InspectionController::historyChanged})
        connect(&controller, signal, this, &Autopilot::check, Qt::QueuedConnection);
    connect(&controller, &InspectionController::reportIssued, this, &Autopilot::check, Qt::QueuedConnection);
    connect(&controller.tasks(), &TaskRunner::idle, this, &Autopilot::check, Qt::QueuedConnection);
    stalled_.setSingleShot(true);
    stalled_.setInterval(kStalledAfter_ms);
    connect(&stalled_, &QTimer::timeout, this, [this] {
        fail(tr("autopilot: nothing happened for %1 s; run the demonstration by hand to see why")
                 .arg(kStalledAfter_ms / 1000));
    });
}

void Autopilot::start() {
    if (!QDir().mkpath(folder_)) {
        fail(tr("%1: the folder cannot be made; choose another one").arg(folder_));
        return;
    }
    plan();
    check();
}

void Autopilot::stage(std::function<void()> begin, std::function<bool()> isDone) {
    stages_.push_back({std::move(begin), std::move(isDone)});
}

void Autopilot::picture(const QString& name) {
    stage(
        [this, name] {
            pictureTaken_ = false;
            rest_.then([this, name] { savePicture(name); });
        },
        [this] { return pictureTaken_; });
}

void Autopilot::plan() {
    const auto isIdle = [this] { return !controller_.tasks().isBusy(); };
    const auto run = [this](const char* command) { window_.commands().find(QString::fromLatin1(command))->trigger(); };
    const auto show = [this](Step step) { window_.showStep(step); };

    picture(QStringLiteral("01-start"));
    stage(
        [this] {
            const QString session = QDir(folder_).filePath(QStringLiteral("demo.fodscope"));
            removeOldSession(session);
            controller_.createBuiltinTank(session);
        },
        [this] { return tankReady_; });
    stage(
        [show, run] {
            show(Step::Reference);
            run("reference.heatmap");
        },
        isIdle);
    picture(QStringLiteral("02-reference"));
    stage([run] { run("reference.heatmap"); }, isIdle);
    stage([show] { show(Step::Map); }, isIdle);
    picture(QStringLiteral("03-map"));
    stage(
        [this, show] {
            show(Step::Candidates);
            moveThreshold();
        },
        [this] { return !controller_.tasks().isBusy() && controller_.history().canUndo(); });
    stage([run] { run("edit.undo"); },
          [this] { return !controller_.tasks().isBusy() && controller_.history().canRedo(); });
    stage([run] { run("candidate.next"); }, isIdle);
    picture(QStringLiteral("04-candidates"));
    stage(
        [show, run] {
            run("visit.plan");
            show(Step::Visit);
        },
        [this] { return controller_.state().plan.has_value() && !controller_.tasks().isBusy(); });
    picture(QStringLiteral("05-plan"));
    stage([run] { run("visit.start"); },
          [this] {
              const bool ended = controller_.visits().runnerState() == RunnerState::Finished;
              if (ended && controller_.state().photos.empty())
                  fail(tr("autopilot: the robot brought no photo; run the demonstration by hand to see why"));
              return !controller_.state().photos.empty();
          });
    picture(QStringLiteral("06-visit"));
    stage([] {}, [this] { return controller_.visits().runnerState() == RunnerState::Finished; });
    stage(
        [this, show] {
            labeller_ = std::make_unique<GroundTruthLabeller>(controller_.simulatedWorld(), true);
            controller_.setLabeller(QString::fromStdString(labeller_->name()));
            show(Step::Label);
        },
        [this] { return !controller_.selectedPhoto().isEmpty(); });
    picture(QStringLiteral("07-label"));
    stage([this] { labelNext(); },
          [this] {
              if (photosWithoutDecision(controller_.state()).empty()) return true;
              labelNext();
              return false;
          });
    picture(QStringLiteral("08-labelled"));
    stage(
        [this, show] {
            show(Step::Report);
            fillFrontPage();
        },
        isIdle);
    stage([run] { run("report.issue"); }, [this] { return reportReady_; });
    picture(QStringLiteral("09-report"));
}

void Autopilot::check() {
    if (over_ || checking_) return;
    checking_ = true;
    stalled_.start();
    while (!over_ && current_ < stages_.size()) {
        if (!begun_) {
            begun_ = true;
            stages_[current_].begin();
        }
        if (over_ || !stages_[current_].isDone()) break;
        begun_ = false;
        ++current_;
    }
    checking_ = false;
    if (over_ || current_ < stages_.size()) return;
    over_ = true;
    stalled_.stop();
    emit finished();
}

void Autopilot::fail(const QString& sentence) {
    if (over_) return;
    over_ = true;
    stalled_.stop();
    emit failed(sentence);
}

void Autopilot::savePicture(const QString& name) {
    const QString file = QDir(folder_).filePath(name + QStringLiteral(".png"));
    if (!window_.grab().save(file)) {
        fail(tr("%1: the picture cannot be written; free some space or choose another folder").arg(file));
        return;
    }
    emit pictureSaved(file);
    pictureTaken_ = true;
    check();
}

void Autopilot::moveThreshold() {
    auto* threshold = window_.findChild<QWidget*>(QStringLiteral("slider.threshold"));
    auto* slider = threshold->findChild<QSlider*>();
    for (int i = 0; i < kThresholdSteps; ++i)
        press(*slider, Qt::Key_Left, Qt::NoModifier, {});
}

void Autopilot::labelNext() {
    const auto waiting = photosWithoutDecision(controller_.state());
    if (waiting.empty()) return;
    const QString id = QString::fromStdString(waiting.front());
    // Each photo is asked about once; a decision that does not arrive is a fault.
    const std::size_t left = waiting.size();
    if (left == photosAsked_) return;
    photosAsked_ = left;
    controller_.selectPhoto(id);
    pressLabel(labeller_->answer(*controller_.findPhoto(id), controller_.state().labelSet));
}

void Autopilot::pressLabel(const PhotoAnswer& answer) {
    auto* view = window_.findChild<QWidget*>(QStringLiteral("labellingView"));
    if (!answer.comment.empty())
        if (auto* comment = view->findChild<QLineEdit*>(QStringLiteral("comment")))
            comment->setText(QString::fromStdString(answer.comment));
    for (const PhotoLabel& given : answer.labels) {
        const Label* label = controller_.state().labelSet.find(given.label);
        if (label == nullptr) continue;
        const bool several = answer.labels.size() > 1;
        press(*view, label->key, several ? Qt::ShiftModifier : Qt::NoModifier, QString(QLatin1Char(label->key)));
    }
    if (answer.labels.size() > 1) press(*view, Qt::Key_Return, Qt::NoModifier, {});
}

void Autopilot::fillFrontPage() {
    const std::pair<const char*, QString> fields[] = {
        {"report.ship", tr("Demonstration ship")},
        {"report.tank", tr("Built-in tank (simulated)")},
        {"report.workOrder", tr("DEMO-1")},
        {"report.inspector", tr("automatic demonstration")},
    };
    for (const auto& [name, text] : fields) {
        auto* line = window_.findChild<QLineEdit*>(QString::fromLatin1(name));
        line->setText(text);
        emit line->editingFinished();
    }
}

}  // namespace fodscope
