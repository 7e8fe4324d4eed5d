// SPDX-License-Identifier: MIT
#include <QLocale>
#include <cmath>

#include "ui/view3d/Peel.h"
#include "ui/view3d/View3DImpl.h"

namespace fodscope {
namespace {

constexpr int kFlight_ms = 250;
constexpr int kHoverPause_ms = 60;
constexpr int kRest_ms = 180;

QString distanceText(double distance_m) {
    if (distance_m < 1.0) return View3D::tr("%1 mm").arg(QLocale().toString(distance_m * 1000.0, 'f', 0));
    return View3D::tr("%1 m").arg(QLocale().toString(distance_m, 'f', 3));
}

}  // namespace

View3D::Impl::Impl(View3D* view)
    : self(view),
      surface(view),
      scene(surface.renderer(), surface.topRenderer()),
      overlay(new ViewOverlay(view)),
      toolBar(new ViewToolBar(view)) {
    renderTimer.setSingleShot(true);
    renderTimer.setInterval(0);
    restTimer.setSingleShot(true);
    restTimer.setInterval(kRest_ms);
    hoverTimer.setSingleShot(true);
    hoverTimer.setInterval(kHoverPause_ms);
    flight.setDuration(kFlight_ms);
    flight.setStartValue(0.0);
    flight.setEndValue(1.0);
    flight.setEasingCurve(QEasingCurve::InOutCubic);
}

void View3D::Impl::render() {
    renderTimer.stop();
    scene.setPixelsPerMetre(projection().pixelsPerMetre() * surface.widget()->devicePixelRatioF());
    surface.render(camera);
    updateOverlay();
}

void View3D::Impl::updateOverlay() {
    const ScreenProjection screen = projection();
    std::vector<ViewOverlay::Label> labels;
    if (scene.isVisible(ViewLayer::Candidates)) {
        for (const ViewCandidate& candidate : scene.candidates()) {
            if (candidate.faint) continue;
            const auto spot = screen.project(candidate.centroid);
            if (!spot) continue;
            labels.push_back({ViewOverlay::LabelKind::Candidate, candidate.id, QPointF(spot->x_px, spot->y_px),
                              candidate.colour, candidate.selected, candidate.state});
        }
    }
    if (scene.isVisible(ViewLayer::Waypoints)) {
        for (const ViewWaypoint& waypoint : scene.waypoints()) {
            const auto spot =
                screen.project(Eigen::Vector3d(waypoint.pose.x_m, waypoint.pose.y_m, scene.floorHeight_m()));
            if (!spot) continue;
            labels.push_back({ViewOverlay::LabelKind::Waypoint, waypoint.id, QPointF(spot->x_px, spot->y_px), QColor(),
                              waypoint.selected, waypoint.state});
        }
    }
    overlay->setCamera(camera);
    updateLegend();
    overlay->setToolBarArea(toolBar->isVisible() ? QRectF(toolBar->geometry()) : QRectF());
    overlay->setLabels(std::move(labels));
    ViewOverlay::Measurement measurement;
    const auto toScreen = [&screen](const Eigen::Vector3d& point) -> std::optional<QPointF> {
        const auto spot = screen.project(point);
        return spot ? std::optional(QPointF(spot->x_px, spot->y_px)) : std::nullopt;
    };
    if (!measured.empty()) measurement.from = toScreen(measured[0]);
    if (measured.size() > 1) {
        measurement.to = toScreen(measured[1]);
        measurement.text = distanceText((measured[1] - measured[0]).norm());
    }
    overlay->setMeasurement(measurement);
    const bool nothing = scene.empty();
    overlay->setMessage(nothing ? (emptyMessage.isEmpty() ? View3D::tr("Nothing is loaded yet") : emptyMessage)
                                : QString());
}

void View3D::Impl::updateLegend() {
    const PointValues* legend = scene.legend();
    overlay->setLegend(legend ? std::optional(ViewOverlay::Legend{legend->style, legend->anyUnknown}) : std::nullopt);
}

void View3D::Impl::contentChanged() {
    updateLegend();
    const Bounds bounds = scene.bounds();
    if (!bounds.empty()) toolBar->setHeights(bounds.minimum.z(), bounds.maximum.z());
    if (cameraIsOurs && !bounds.empty()) {
        const OrbitCamera base = flight.state() == QAbstractAnimation::Running ? flightEnd : camera;
        flight.stop();
        camera = fittedCamera(base);
    }
    requestRender();
}

void View3D::Impl::openFromAbove(std::span<const Eigen::Vector3d> points) {
    if (!peelIsOurs || points.empty()) return;
    const auto height_m = openingHeight(points);
    scene.setPeelHeight(height_m);
    const Bounds bounds = scene.bounds();
    if (!bounds.empty()) toolBar->setHeights(bounds.minimum.z(), bounds.maximum.z());
    toolBar->setPeelHeight(height_m);
    emit self->peelHeightChanged();
}

void View3D::Impl::touch() {
    cameraIsOurs = false;
    flight.stop();
    scene.setCoarse(true);
    restTimer.start();
}

void View3D::Impl::setCamera(const OrbitCamera& target) {
    touch();
    camera = target;
    requestRender();
}

void View3D::Impl::flyTo(const OrbitCamera& target) {
    flight.stop();
    flightStart = camera;
    flightEnd = target;
    if (!self->isVisible()) {
        camera = target;
        return;
    }
    flight.start();
}

OrbitCamera View3D::Impl::fittedCamera(const OrbitCamera& from) const {
    const double width = surface.widget()->width();
    const double height = std::max(1, surface.widget()->height());
    const double covered = overlay->legendArea().width();
    // In a narrow view the legend may cover a corner rather than squeeze the tank.
    if (covered > 0.25 * width) return fitted(from, scene.bounds(), aspect(), kFitMargin);
    const OrbitCamera camera = fitted(from, scene.bounds(), (width - covered) / height, kFitMargin);
    return panned(camera, -0.5 * covered, 0.0, height);
}

}  // namespace fodscope
