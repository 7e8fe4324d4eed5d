// SPDX-License-Identifier: MIT
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "ui/view3d/View3DImpl.h"

namespace fodscope {
namespace {

constexpr int kClickReach_px = 4;
constexpr double kMarkReach_px = 10.0;
constexpr double kKeyTurn_px = 24.0;
constexpr double kZoomStep = 0.85;

}  // namespace

void View3D::Impl::press(const QMouseEvent& event) {
    flight.stop();
    pressed = true;
    dragged = false;
    button = event.button();
    pressedAt = lastAt = event.pos();
    overlay->setHint({}, {});
}

void View3D::Impl::move(const QMouseEvent& event) {
    const QPoint step = event.pos() - lastAt;
    if (!pressed) {
        lastAt = event.pos();
        hoverTimer.start();
        return;
    }
    if (!dragged && (event.pos() - pressedAt).manhattanLength() < kClickReach_px) return;
    dragged = true;
    lastAt = event.pos();
    const double height = surface.widget()->height();
    const bool pan = button != Qt::LeftButton || event.modifiers().testFlag(Qt::ShiftModifier);
    setCamera(pan ? panned(camera, step.x(), step.y(), height) : orbited(camera, step.x(), step.y(), height));
}

void View3D::Impl::release(const QMouseEvent& event) {
    if (!pressed || event.button() != button) return;
    pressed = false;
    if (!dragged && button == Qt::LeftButton) click(event.pos());
}

void View3D::Impl::doubleClick(const QMouseEvent& event) {
    pressed = false;
    if (event.button() != Qt::LeftButton || measuring) return;
    const ViewOverlay::Label* label = overlay->labelAt(event.pos());
    if (label != nullptr && label->kind == ViewOverlay::LabelKind::Candidate) {
        emit self->candidateActivated(label->id);
        return;
    }
    const auto point = pick(event.pos());
    if (!point) return;
    if (!point->candidateId.isEmpty()) {
        emit self->candidateActivated(point->candidateId);
        return;
    }
    OrbitCamera target = camera;
    target.focus = point->position;
    cameraIsOurs = false;
    flyTo(target);
}

void View3D::Impl::wheel(const QWheelEvent& event) {
    const double steps = event.angleDelta().y() / 120.0;
    if (steps == 0.0) return;
    if (!wheelRunning) {
        // What is under the pointer stays there for as long as the wheel turns.
        const QPointF at = event.position();
        const auto point = scene.pick(projection(), at.x(), at.y());
        wheelAnchor = point ? point->position : projection().unproject(at.x(), at.y(), projection().depthOfFocus_m());
        wheelRunning = true;
    }
    setCamera(zoomed(camera, std::pow(kZoomStep, steps), wheelAnchor));
}

bool View3D::Impl::key(const QKeyEvent& event) {
    const double height = surface.widget()->height();
    const bool pan = event.modifiers().testFlag(Qt::ShiftModifier);
    const auto turn = [&](double dx, double dy) {
        setCamera(pan ? panned(camera, -dx, -dy, height) : orbited(camera, dx, dy, height));
    };
    switch (event.key()) {
        case Qt::Key_Left:
            turn(-kKeyTurn_px, 0.0);
            return true;
        case Qt::Key_Right:
            turn(kKeyTurn_px, 0.0);
            return true;
        case Qt::Key_Up:
            turn(0.0, pan ? -kKeyTurn_px : kKeyTurn_px);
            return true;
        case Qt::Key_Down:
            turn(0.0, pan ? kKeyTurn_px : -kKeyTurn_px);
            return true;
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            setCamera(zoomed(camera, kZoomStep, camera.focus));
            return true;
        case Qt::Key_Minus:
            setCamera(zoomed(camera, 1.0 / kZoomStep, camera.focus));
            return true;
        case Qt::Key_Home:
            self->fit();
            return true;
        case Qt::Key_Escape:
            if (!measuring) return false;
            self->setMeasuring(false);
            return true;
        default:
            return false;
    }
}

void View3D::Impl::click(const QPoint& position) {
    if (const ViewOverlay::Label* label = measuring ? nullptr : overlay->labelAt(position)) {
        if (label->kind == ViewOverlay::LabelKind::Candidate) {
            emit self->candidateSelected(label->id);
        } else {
            emit self->waypointSelected(label->id);
        }
        return;
    }
    if (const ViewWaypoint* waypoint = measuring ? nullptr : waypointAt(position)) {
        emit self->waypointSelected(waypoint->id);
        return;
    }
    const auto point = pick(position);
    if (!point) {
        if (!measuring) emit self->candidateSelected({});
        return;
    }
    emit self->picked(*point);
    if (measuring) {
        measureAt(*point);
    } else {
        emit self->candidateSelected(point->candidateId);
    }
}

void View3D::Impl::measureAt(const PickedPoint& point) {
    if (measured.size() >= 2) measured.clear();
    measured.push_back(point.position);
    if (measured.size() == 2) emit self->distanceMeasured((measured[1] - measured[0]).norm());
    updateOverlay();
}

std::optional<PickedPoint> View3D::Impl::pick(const QPoint& position) const {
    return scene.pick(projection(), position.x(), position.y());
}

QString View3D::Impl::describe(const PickedPoint& point) const {
    if (!point.candidateId.isEmpty()) return point.candidateId;
    const auto value = scene.valueAt(point);
    if (!value) return {};
    const PointValues* legend = scene.legend();
    if (legend == nullptr) return {};
    const ScalarStyle& style = legend->style;
    if (std::isnan(*value))
        return style.unknownWord.isEmpty() ? View3D::tr("%1: not known").arg(style.title) : style.unknownWord;
    if (style.describe) return style.describe(*value);
    const QString number = QLocale().toString(*value * legend->style.displayFactor, 'f', legend->style.decimals);
    return legend->style.unit.isEmpty() ? number : number + QChar(0x202F) + legend->style.unit;
}

void View3D::Impl::showHover() {
    if (pressed || !surface.widget()->underMouse()) {
        overlay->setHint({}, {});
        return;
    }
    const ViewOverlay::Label* label = overlay->labelAt(lastAt);
    const auto point = label ? std::nullopt : pick(lastAt);
    const bool clickable =
        label != nullptr || measuring || waypointAt(lastAt) != nullptr || (point && !point->candidateId.isEmpty());
    surface.widget()->setCursor(measuring ? Qt::CrossCursor : clickable ? Qt::PointingHandCursor : Qt::ArrowCursor);
    overlay->setHint(lastAt, point ? describe(*point) : QString());
    emit self->hovered(point);
}

const ViewWaypoint* View3D::Impl::waypointAt(const QPoint& position) const {
    if (!scene.isVisible(ViewLayer::Waypoints)) return nullptr;
    const ScreenProjection screen = projection();
    for (const ViewWaypoint& waypoint : scene.waypoints()) {
        const auto spot = screen.project(Eigen::Vector3d(waypoint.pose.x_m, waypoint.pose.y_m, scene.floorHeight_m()));
        if (spot && std::hypot(spot->x_px - position.x(), spot->y_px - position.y()) < kMarkReach_px) return &waypoint;
    }
    return nullptr;
}

}  // namespace fodscope
