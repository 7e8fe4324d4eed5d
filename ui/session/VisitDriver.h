// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "core/robot/RobotLink.h"
#include "core/robot/VisitRunner.h"

namespace fodscope {

/// Holds the robot and, once there is a plan, the runner that drives it; polls both some twenty times a second.
class VisitDriver : public QObject {
    Q_OBJECT

  public:
    /// Monotonic seconds. A faster clock makes a simulated robot faster.
    using Clock = std::function<double()>;

    explicit VisitDriver(QObject* parent = nullptr);
    ~VisitDriver() override;

    void setClock(Clock clock);
    double now_s() const { return clock_(); }

    void setRobot(std::unique_ptr<RobotLink> robot);
    bool hasRobot() const { return robot_ != nullptr; }
    QString robotName() const;
    const std::optional<RobotState>& robotState() const { return robotState_; }

    /// Takes a plan over. Whatever was under way is stopped first.
    void setPlan(const VisitPlan& plan, const std::vector<Visit>& visits, const VisitSettings& settings,
                 const std::vector<PhotoMark>& kept);
    void clearPlan();
    bool hasPlan() const { return plan_.has_value(); }
    RunnerState runnerState() const;

    void start();
    void pause();
    void skip();
    void stop();
    void retry(const std::string& waypointId);
    /// Answered by mapReceived().
    void requestMap();

  signals:
    void robotChanged();
    void gridReceived(const fodscope::OccupancyGrid& grid);
    void mapReceived(const std::shared_ptr<const fodscope::PointCloud>& map);
    void visitChanged(const fodscope::Visit& visit);
    void photoArrived(const fodscope::Photo& photo);
    void runnerStateChanged();
    void message(const QString& text);

  private:
    void makeRunner();
    void poll();
    void handle(const RobotEvent& event);

    QTimer timer_;
    Clock clock_;
    std::unique_ptr<RobotLink> robot_;
    std::optional<VisitPlan> plan_;
    std::vector<Visit> visits_;
    VisitSettings settings_;
    std::vector<PhotoMark> kept_;
    std::unique_ptr<VisitRunner> runner_;
    RunnerState shownState_ = RunnerState::Idle;
    std::optional<RobotState> robotState_;
};

}  // namespace fodscope
