// SPDX-License-Identifier: MIT
#pragma once

#include <QPainter>
#include <QString>
#include <QWidget>
#include <memory>
#include <optional>

#include "ui/plan/PlanScene.h"

namespace fodscope {

/// The 2D cost map with candidates, waypoints in visit order, route and robot. Wheel zooms at the cursor, drag pans,
/// click selects.
class PlanView : public QWidget {
    Q_OBJECT

  public:
    explicit PlanView(QWidget* parent = nullptr);
    ~PlanView() override;

    /// Keeps zoom and place unless the grid's extent changed.
    void setScene(PlanScene scene);
    void setVisits(const std::vector<Visit>& visits);
    /// Call it about once a second even when nothing moved, so that the shown age is true; empty: no robot.
    void setRobot(const std::optional<PlanRobot>& robot);
    /// Empty ids select nothing. Neither emits a signal.
    void setSelectedCandidate(const QString& candidateId);
    void setSelectedWaypoint(const QString& waypointId);

    /// Whether waypoints can be dragged, removed and added; not by default.
    void setEditable(bool editable);

    const PlanScene& scene() const;

  public slots:
    void fit();

  signals:
    void waypointSelected(const QString& waypointId);
    void candidateSelected(const QString& candidateId);
    /// Double click.
    void candidateActivated(const QString& candidateId);
    /// Of a route: a double click beside all poses, a pose that was dragged or turned, and Delete.
    void poseAdded(const fodscope::Pose2& pose_map);
    void poseChanged(const QString& waypointId, const fodscope::Pose2& pose_map);
    void poseRemoved(const QString& waypointId);
    /// A waypoint was dragged to a place.
    void waypointMoved(const QString& waypointId, const Eigen::Vector2d& place_map);
    /// Delete was pressed.
    void waypointRemoved(const QString& waypointId);
    /// Double click on the floor.
    void waypointAdded(const Eigen::Vector2d& place_map);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    bool event(QEvent* event) override;

  private:
    void paintHeldWaypoint(QPainter& painter);

    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace fodscope

Q_DECLARE_METATYPE(fodscope::Pose2)
