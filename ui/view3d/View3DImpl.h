// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QTimer>
#include <QVariantAnimation>
#include <optional>
#include <span>
#include <vector>

#include "ui/view3d/RenderWidget.h"
#include "ui/view3d/View3D.h"
#include "ui/view3d/ViewOverlay.h"
#include "ui/view3d/ViewScene.h"
#include "ui/view3d/ViewToolBar.h"

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace fodscope {

inline constexpr double kFitMargin = 0.05;

/// The inside of the 3D view: View3DDrawing.cpp puts the picture together and moves the camera, View3DInput.cpp answers
/// mouse and keys.
class View3D::Impl {
  public:
    explicit Impl(View3D* view);

    double aspect() const { return surface.widget()->width() / std::max(1.0, double(surface.widget()->height())); }
    ScreenProjection projection() const {
        return {camera, double(surface.widget()->width()), double(surface.widget()->height())};
    }

    void requestRender() {
        if (!renderTimer.isActive()) renderTimer.start();
    }
    void render();
    void updateOverlay();
    void updateLegend();
    void contentChanged();
    void openFromAbove(std::span<const Eigen::Vector3d> points);
    const ViewWaypoint* waypointAt(const QPoint& position) const;
    void touch();
    void setCamera(const OrbitCamera& target);
    void flyTo(const OrbitCamera& target);
    OrbitCamera fittedCamera(const OrbitCamera& from) const;

    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void doubleClick(const QMouseEvent& event);
    void wheel(const QWheelEvent& event);
    bool key(const QKeyEvent& event);
    void click(const QPoint& position);
    void measureAt(const PickedPoint& point);
    void showHover();
    QString describe(const PickedPoint& point) const;
    std::optional<PickedPoint> pick(const QPoint& position) const;

    View3D* self;
    RenderWidget surface;
    ViewScene scene;
    ViewOverlay* overlay;
    ViewToolBar* toolBar;
    OrbitCamera camera;
    OrbitCamera flightStart;
    OrbitCamera flightEnd;
    QVariantAnimation flight;
    QTimer renderTimer;
    QTimer restTimer;
    QTimer hoverTimer;
    QString emptyMessage;
    /// Until the operator moves the camera, new data moves it so that all is seen.
    bool cameraIsOurs = true;
    /// Until the operator peels, new clouds are opened so that one sees into them.
    bool peelIsOurs = true;
    bool measuring = false;
    std::vector<Eigen::Vector3d> measured;
    QPoint pressedAt;
    QPoint lastAt;
    bool pressed = false;
    bool dragged = false;
    Qt::MouseButton button = Qt::NoButton;
    bool wheelRunning = false;
    Eigen::Vector3d wheelAnchor = Eigen::Vector3d::Zero();
};

}  // namespace fodscope
