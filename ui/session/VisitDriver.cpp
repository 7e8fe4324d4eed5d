// SPDX-License-Identifier: MIT
#include "ui/session/VisitDriver.h"

#include <chrono>
#include <utility>

namespace fodscope {
namespace {

constexpr int kPollEvery_ms = 50;

double steadySeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

VisitDriver::VisitDriver(QObject* parent) : QObject(parent), clock_(steadySeconds) {
    timer_.setInterval(kPollEvery_ms);
    connect(&timer_, &QTimer::timeout, this, &VisitDriver::poll);
}

VisitDriver::~VisitDriver() = default;

void VisitDriver::setClock(Clock clock) {
    clock_ = std::move(clock);
}

void VisitDriver::setRobot(std::unique_ptr<RobotLink> robot) {
    timer_.stop();
    runner_.reset();
    if (robot_) robot_->disconnect();
    robot_ = std::move(robot);
    robotState_.reset();
    if (robot_) {
        robot_->connect();
        robot_->requestGrid();
        makeRunner();
        timer_.start();
    }
    emit robotChanged();
    emit runnerStateChanged();
}

QString VisitDriver::robotName() const {
    return robot_ ? QString::fromStdString(robot_->name()) : QString();
}

void VisitDriver::setPlan(const VisitPlan& plan, const std::vector<Visit>& visits, const VisitSettings& settings,
                          const std::vector<PhotoMark>& kept) {
    plan_ = plan;
    kept_ = kept;
    visits_ = visits;
    settings_ = settings;
    makeRunner();
    emit runnerStateChanged();
}

void VisitDriver::clearPlan() {
    if (runner_ && runnerState() == RunnerState::Running) runner_->stop();
    runner_.reset();
    plan_.reset();
    visits_.clear();
    emit runnerStateChanged();
}

RunnerState VisitDriver::runnerState() const {
    return runner_ ? runner_->state() : RunnerState::Idle;
}

void VisitDriver::makeRunner() {
    if (runner_ && runner_->state() == RunnerState::Running) runner_->stop();
    runner_.reset();
    if (robot_ && plan_) runner_ = std::make_unique<VisitRunner>(*robot_, *plan_, visits_, settings_, kept_);
    shownState_ = runnerState();
}

void VisitDriver::start() {
    if (runner_) runner_->start();
    poll();
}

void VisitDriver::pause() {
    if (runner_) runner_->pause();
    poll();
}

void VisitDriver::skip() {
    if (runner_) runner_->skip();
    poll();
}

void VisitDriver::stop() {
    if (runner_)
        runner_->stop();
    else if (robot_)
        robot_->cancelAllGoals();
    poll();
}

void VisitDriver::retry(const std::string& waypointId) {
    if (runner_) runner_->retry(waypointId);
    poll();
}

void VisitDriver::requestMap() {
    if (robot_) robot_->requestMap();
}

void VisitDriver::poll() {
    if (!robot_) return;
    if (!runner_) {
        for (const RobotEvent& event : robot_->poll(clock_()))
            handle(event);
        return;
    }
    const VisitProgress progress = runner_->advance(clock_());
    visits_ = runner_->visits();
    kept_ = runner_->photoMarks();
    if (progress.robot) {
        robotState_ = progress.robot;
        emit robotChanged();
    }
    // Photos first: whoever hears that a visit is done finds its photo already kept.
    for (const Photo& photo : progress.photos)
        emit photoArrived(photo);
    for (const Visit& visit : progress.changedVisits)
        emit visitChanged(visit);
    for (const RobotEvent& event : progress.otherEvents)
        handle(event);
    for (const std::string& text : progress.messages)
        emit message(QString::fromStdString(text));
    if (const RunnerState state = runnerState(); state != shownState_) {
        shownState_ = state;
        emit runnerStateChanged();
    }
}

void VisitDriver::handle(const RobotEvent& event) {
    if (const auto* changed = std::get_if<RobotStateChanged>(&event)) {
        robotState_ = changed->state;
        emit robotChanged();
    } else if (const auto* map = std::get_if<MapReceived>(&event)) {
        emit mapReceived(map->map);
    } else if (const auto* grid = std::get_if<GridReceived>(&event)) {
        emit gridReceived(grid->grid);
    } else if (const auto* text = std::get_if<LinkMessage>(&event)) {
        emit message(QString::fromStdString(text->text));
    }
}

}  // namespace fodscope
