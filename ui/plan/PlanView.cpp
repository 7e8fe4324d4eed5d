// SPDX-License-Identifier: MIT
#include "ui/plan/PlanView.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/plan/PlanPainter.h"
#include "ui/plan/PlanSigns.h"
#include "ui/plan/PlanWords.h"
#include "ui/plan/PoseEditing.h"
#include "ui/theme/Icons.h"
#include "ui/theme/Theme.h"

namespace fodscope {

struct PlanView::Parts {
    PlanScene scene;
    PlanExtent extent;
    PlanImages images;
    ThemeKind imagesOf = ThemeKind::Dark;
    PlanTransform transform;
    PlanLook look;
    double legendHeight = 0.0;
    /// The operator zoomed or panned: a resize then keeps the scale.
    bool moved = false;
    bool dragging = false;
    /// The pose of a route that the mouse holds, and where it was.
    std::optional<PoseGrip> grip;
    Pose2 gripped_map;
    QPointF pressed;
    QPointF dragged;
    QToolButton* fit = nullptr;
    bool editable = false;
    /// The waypoint that is being dragged; empty: none.
    std::string held;
};

PlanView::PlanView(QWidget* parent) : QWidget(parent), parts_(std::make_unique<Parts>()) {
    qRegisterMetaType<Pose2>();
    setObjectName(QStringLiteral("planView"));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(240, 180);
    setAccessibleName(tr("Plan of the visits"));
    parts_->fit = new QToolButton(this);
    parts_->fit->setObjectName(QStringLiteral("fitPlan"));
    parts_->fit->setIcon(icon(Icon::Fit));
    parts_->fit->setToolTip(tr("Show the whole plan (Home)"));
    parts_->fit->setFocusPolicy(Qt::NoFocus);
    setButtonRole(parts_->fit, ButtonRole::Normal);
    connect(parts_->fit, &QToolButton::clicked, this, &PlanView::fit);
}

PlanView::~PlanView() = default;

void PlanView::setEditable(bool editable) {
    parts_->editable = editable;
    parts_->held.clear();
}

const PlanScene& PlanView::scene() const {
    return parts_->scene;
}

void PlanView::setScene(PlanScene scene) {
    parts_->scene = std::move(scene);
    parts_->grip.reset();
    parts_->images = {};
    const PlanExtent extent = planExtent(parts_->scene);
    const bool sameExtent = extent == parts_->extent;
    parts_->extent = extent;
    parts_->fit->setVisible(!extent.empty);
    if (!sameExtent) fit();
    update();
}

void PlanView::setVisits(const std::vector<Visit>& visits) {
    updateVisits(parts_->scene, visits);
    update();
}

void PlanView::setRobot(const std::optional<PlanRobot>& robot) {
    parts_->look.robot = robot;
    update();
}

void PlanView::setSelectedCandidate(const QString& candidateId) {
    parts_->look.selectedCandidate = candidateId.toStdString();
    update();
}

void PlanView::setSelectedWaypoint(const QString& waypointId) {
    parts_->look.selectedWaypoint = waypointId.toStdString();
    update();
}

void PlanView::fit() {
    parts_->moved = false;
    parts_->transform = fittedPlan(parts_->extent, QRectF(0, 0, width(), height() - parts_->legendHeight));
    update();
}

void PlanView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Theme theme = currentTheme();
    if (parts_->images.cells.isNull() || parts_->imagesOf != theme.kind) {
        parts_->images = planImages(parts_->scene, theme);
        parts_->imagesOf = theme.kind;
    }
    parts_->look.theme = theme;
    painter.setFont(fontFor(TextRole::Caption));
    const double legendHeight = paintPlanLegend(painter, rect(), parts_->scene, parts_->look, false);
    if (std::abs(legendHeight - parts_->legendHeight) > 0.5) {
        parts_->legendHeight = legendHeight;
        if (!parts_->moved) fit();
    }
    const QRectF plan(0, 0, width(), height() - legendHeight);
    if (parts_->extent.empty) {
        painter.fillRect(rect(), theme.surface0);
        painter.setPen(theme.muted);
        painter.setFont(fontFor(TextRole::Body));
        painter.drawText(rect().adjusted(24, 0, -24, 0), Qt::AlignCenter | Qt::TextWordWrap,
                         parts_->scene.isRoute
                             ? tr("Connect a robot or load a route to see it here.")
                             : tr("The plan needs candidates. Detect them in step 3, then plan the visits."));
        return;
    }
    paintPlan(painter, plan, parts_->scene, parts_->images, parts_->transform, parts_->look);
    if (parts_->scene.isRoute) {
        painter.setClipRect(plan);
        paintPoseHandles(painter, parts_->scene, parts_->transform, theme);
        painter.setClipping(false);
    }
    if (parts_->dragging && !parts_->held.empty()) paintHeldWaypoint(painter);
    painter.fillRect(QRectF(0, plan.bottom(), width(), legendHeight), theme.surface1);
    painter.fillRect(QRectF(0, plan.bottom(), width(), 1), theme.line);
    paintPlanLegend(painter, QRectF(0, plan.bottom(), width(), legendHeight), parts_->scene, parts_->look, true);
}

/// Where the waypoint would be, looking at what it was taken for.
void PlanView::paintHeldWaypoint(QPainter& painter) {
    const auto held = std::ranges::find(parts_->scene.waypoints, parts_->held, &PlanWaypoint::id);
    if (held == parts_->scene.waypoints.end()) return;
    const Theme& theme = parts_->look.theme;
    const double yaw_rad = facingFrom(parts_->scene, *held, parts_->transform.toMap(parts_->dragged));
    QColor fill = theme.accent;
    fill.setAlpha(60);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    paintViewCone(painter, parts_->dragged, parts_->scene.viewRange_m * parts_->transform.pixelsPerMetre, yaw_rad,
                  parts_->scene.viewAngle_rad, fill);
    paintWaypointSign(painter, parts_->dragged, QString::number(held->number), held->state, true, true, theme);
    painter.restore();
}

void PlanView::resizeEvent(QResizeEvent*) {
    parts_->fit->adjustSize();
    parts_->fit->move(width() - parts_->fit->width() - 12, 12);
    if (!parts_->moved) fit();
}

void PlanView::wheelEvent(QWheelEvent* event) {
    parts_->moved = true;
    const double notches = event->angleDelta().y() / 120.0;
    parts_->transform = zoomedPlan(parts_->transform, std::pow(1.2, notches), event->position());
    update();
    event->accept();
}

void PlanView::mousePressEvent(QMouseEvent* event) {
    parts_->pressed = parts_->dragged = event->localPos();
    parts_->dragging = false;
    if (event->button() != Qt::LeftButton) return;
    if (parts_->scene.isRoute) {
        parts_->grip = poseGripAt(parts_->scene, parts_->transform, event->localPos());
        if (parts_->grip) parts_->gripped_map = parts_->scene.waypoints[parts_->grip->waypoint].pose_map;
        return;
    }
    const PlanHit hit = planHit(parts_->scene, parts_->transform, event->localPos());
    if (parts_->editable && hit.item == PlanItem::Waypoint) parts_->held = hit.id;
}

void PlanView::mouseMoveEvent(QMouseEvent* event) {
    constexpr double kSlip_px = 4.0;
    const QPointF place = event->localPos();
    if (event->buttons() != Qt::NoButton) {
        parts_->dragging = parts_->dragging || (place - parts_->pressed).manhattanLength() > kSlip_px;
        if (!parts_->dragging) return;
        if (parts_->grip) {
            parts_->scene.waypoints[parts_->grip->waypoint].pose_map =
                draggedPose(*parts_->grip, parts_->gripped_map, parts_->transform, place);
            update();
            return;
        }
        if (!parts_->held.empty()) {
            parts_->dragged = place;
            setCursor(Qt::ClosedHandCursor);
            update();
            return;
        }
        parts_->moved = true;
        parts_->transform.origin += place - parts_->dragged;
        parts_->dragged = place;
        setCursor(Qt::ClosedHandCursor);
        update();
        return;
    }
    const PlanHit hit = planHit(parts_->scene, parts_->transform, place);
    setCursor(hit.item == PlanItem::None ? Qt::ArrowCursor : Qt::PointingHandCursor);
    if (hit.id != parts_->look.hovered) {
        parts_->look.hovered = hit.id;
        update();
    }
}

void PlanView::mouseReleaseEvent(QMouseEvent* event) {
    unsetCursor();
    if (const auto grip = std::exchange(parts_->grip, std::nullopt)) {
        const PlanWaypoint& waypoint = parts_->scene.waypoints[grip->waypoint];
        const QString id = QString::fromStdString(waypoint.id);
        setSelectedWaypoint(id);
        emit waypointSelected(id);
        if (std::exchange(parts_->dragging, false)) emit poseChanged(id, Pose2(waypoint.pose_map));
        return;
    }
    const std::string held = std::exchange(parts_->held, {});
    if (parts_->dragging && !held.empty()) {
        parts_->dragging = false;
        update();
        emit waypointMoved(QString::fromStdString(held), parts_->transform.toMap(event->localPos()));
        return;
    }
    if (parts_->dragging || event->button() != Qt::LeftButton) {
        parts_->dragging = false;
        return;
    }
    const PlanHit hit = planHit(parts_->scene, parts_->transform, event->localPos());
    const QString id = QString::fromStdString(hit.id);
    if (hit.item == PlanItem::Waypoint) {
        setSelectedWaypoint(id);
        emit waypointSelected(id);
    } else if (hit.item == PlanItem::Candidate) {
        setSelectedCandidate(id);
        emit candidateSelected(id);
    }
}

void PlanView::mouseDoubleClickEvent(QMouseEvent* event) {
    const PlanHit hit = planHit(parts_->scene, parts_->transform, event->localPos());
    if (hit.item == PlanItem::Candidate) emit candidateActivated(QString::fromStdString(hit.id));
    if (hit.item != PlanItem::None || event->button() != Qt::LeftButton) return;
    const Eigen::Vector2d place_map = parts_->transform.toMap(event->localPos());
    if (parts_->editable) emit waypointAdded(place_map);
    const bool isFree = parts_->scene.isRoute && !poseGripAt(parts_->scene, parts_->transform, event->localPos());
    if (isFree) emit poseAdded(addedPose(parts_->scene, place_map));
}

void PlanView::keyPressEvent(QKeyEvent* event) {
    constexpr double kPan_px = 40.0;
    const QPointF middle(0.5 * width(), 0.5 * height());
    switch (event->key()) {
        case Qt::Key_Escape:
            if (!parts_->grip) {
                QWidget::keyPressEvent(event);
                return;
            }
            parts_->scene.waypoints[parts_->grip->waypoint].pose_map = parts_->gripped_map;
            parts_->grip.reset();
            parts_->dragging = false;
            update();
            return;
        case Qt::Key_Home:
            fit();
            return;
        case Qt::Key_Delete:
            if (parts_->look.selectedWaypoint.empty()) return;
            if (parts_->scene.isRoute) emit poseRemoved(QString::fromStdString(parts_->look.selectedWaypoint));
            if (parts_->editable) emit waypointRemoved(QString::fromStdString(parts_->look.selectedWaypoint));
            return;
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            parts_->transform = zoomedPlan(parts_->transform, 1.25, middle);
            break;
        case Qt::Key_Minus:
            parts_->transform = zoomedPlan(parts_->transform, 0.8, middle);
            break;
        case Qt::Key_Left:
            parts_->transform.origin += QPointF(kPan_px, 0);
            break;
        case Qt::Key_Right:
            parts_->transform.origin -= QPointF(kPan_px, 0);
            break;
        case Qt::Key_Up:
            parts_->transform.origin += QPointF(0, kPan_px);
            break;
        case Qt::Key_Down:
            parts_->transform.origin -= QPointF(0, kPan_px);
            break;
        default:
            QWidget::keyPressEvent(event);
            return;
    }
    parts_->moved = true;
    update();
}

void PlanView::leaveEvent(QEvent*) {
    parts_->look.hovered.clear();
    update();
}

bool PlanView::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const QString text = planToolTip(parts_->scene, planHit(parts_->scene, parts_->transform, help->pos()),
                                     parts_->transform.toMap(help->pos()));
    text.isEmpty() ? QToolTip::hideText() : QToolTip::showText(help->globalPos(), text, this);
    return true;
}

}  // namespace fodscope
