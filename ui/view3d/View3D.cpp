// SPDX-License-Identifier: MIT
#include "ui/view3d/View3D.h"

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QVBoxLayout>
#include <QWheelEvent>

#include "ui/view3d/View3DImpl.h"

namespace fodscope {
namespace {

constexpr double kQuarterTurn_rad = 1.57079632679489661923;

}  // namespace

QString toString(ViewLayer layer) {
    switch (layer) {
        case ViewLayer::Reference:
            return View3D::tr("Reference");
        case ViewLayer::ReferenceMesh:
            return View3D::tr("Reference mesh");
        case ViewLayer::Map:
            return View3D::tr("Map");
        case ViewLayer::Discrepancy:
            return View3D::tr("Discrepancy");
        case ViewLayer::Candidates:
            return View3D::tr("Candidates");
        case ViewLayer::Waypoints:
            return View3D::tr("Waypoints");
        case ViewLayer::Route:
            return View3D::tr("Route");
        case ViewLayer::Trajectory:
            return View3D::tr("Trajectory");
        case ViewLayer::Robot:
            return View3D::tr("Robot");
        case ViewLayer::Grid:
            return View3D::tr("Floor grid");
    }
    return {};
}
View3D::View3D(QWidget* parent) : QWidget(parent), impl_(std::make_unique<Impl>(this)) {
    qRegisterMetaType<ViewLayer>();
    qRegisterMetaType<PickedPoint>();
    qRegisterMetaType<std::optional<PickedPoint>>();
    QWidget* canvas = impl_->surface.widget();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(canvas);
    canvas->installEventFilter(this);
    canvas->setMouseTracking(true);
    canvas->setFocusPolicy(Qt::NoFocus);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("3D view"));
    impl_->overlay->raise();
    impl_->toolBar->raise();
    impl_->toolBar->move(12, 12);
    impl_->toolBar->adjustSize();
    impl_->surface.setBackground(currentTheme().surface0);
    setStandardView(StandardView::Isometric);

    Impl* impl = impl_.get();
    connect(&impl->renderTimer, &QTimer::timeout, this, [impl] { impl->render(); });
    connect(&impl->hoverTimer, &QTimer::timeout, this, [impl] { impl->showHover(); });
    connect(&impl->restTimer, &QTimer::timeout, this, [impl] {
        impl->wheelRunning = false;
        impl->scene.setCoarse(false);
        impl->requestRender();
    });
    connect(&impl->flight, &QVariantAnimation::valueChanged, this, [impl](const QVariant& share) {
        impl->camera = between(impl->flightStart, impl->flightEnd, share.toDouble());
        impl->requestRender();
    });
    ViewToolBar* bar = impl->toolBar;
    connect(bar, &ViewToolBar::layersAsked, this, [impl] {
        std::vector<ViewToolBar::LayerRow> rows;
        for (const ViewLayer layer : kViewLayers) {
            if (!impl->scene.has(layer)) continue;
            rows.push_back({layer, impl->scene.isVisible(layer), impl->scene.opacity(layer)});
        }
        impl->toolBar->setLayers(std::move(rows));
    });
    connect(bar, &ViewToolBar::layerVisible, this, &View3D::setLayerVisible);
    connect(bar, &ViewToolBar::layerOpacity, this, &View3D::setLayerOpacity);
    connect(bar, &ViewToolBar::viewChosen, this, &View3D::setStandardView);
    connect(bar, &ViewToolBar::fitChosen, this, &View3D::fit);
    connect(bar, &ViewToolBar::measureChosen, this, &View3D::setMeasuring);
    connect(bar, &ViewToolBar::pictureChosen, this, [this] { emit snapshotTaken(grabImage()); });
    connect(bar, &ViewToolBar::peelChosen, this, [this, impl](std::optional<double> height_m) {
        impl->peelIsOurs = false;
        impl->scene.setPeelHeight(height_m);
        impl->requestRender();
        emit peelHeightChanged();
    });
}

View3D::~View3D() = default;

void View3D::setReference(std::span<const Eigen::Vector3d> points) {
    impl_->scene.setReference(points);
    impl_->openFromAbove(points);
    impl_->contentChanged();
}

void View3D::setReferenceValues(std::span<const double> values, const ScalarStyle& style) {
    impl_->scene.setReferenceValues(values, style);
    impl_->requestRender();
}

void View3D::setReferenceMesh(std::span<const Eigen::Vector3d> vertices,
                              std::span<const std::array<std::uint32_t, 3>> triangles) {
    impl_->scene.setReferenceMesh(vertices, triangles);
    impl_->contentChanged();
}

void View3D::setMap(std::span<const Eigen::Vector3d> points) {
    impl_->scene.setMap(points);
    if (!hasLayer(ViewLayer::Reference)) impl_->openFromAbove(points);
    impl_->contentChanged();
}

void View3D::setMapTransform(const Transform& T_reference_from_map) {
    impl_->scene.setMapTransform(T_reference_from_map);
    impl_->contentChanged();
}

void View3D::setDiscrepancy(std::span<const Eigen::Vector3d> points, std::span<const double> values,
                            const ScalarStyle& style) {
    impl_->scene.setDiscrepancy(points, values, style);
    if (!hasLayer(ViewLayer::Reference)) impl_->openFromAbove(points);
    impl_->contentChanged();
}

void View3D::setDiscrepancyThreshold(std::optional<double> threshold) {
    impl_->scene.setDiscrepancyThreshold(threshold);
    impl_->requestRender();
}

void View3D::setCandidates(std::vector<ViewCandidate> candidates) {
    impl_->scene.setCandidates(std::move(candidates));
    impl_->contentChanged();
}

void View3D::setSelectedCandidate(const QString& id) {
    impl_->scene.setSelectedCandidate(id);
    impl_->requestRender();
}

void View3D::setFloorHeight(double height_m) {
    impl_->scene.setFloorHeight(height_m);
    impl_->requestRender();
}

void View3D::setWaypoints(std::vector<ViewWaypoint> waypoints) {
    impl_->scene.setWaypoints(std::move(waypoints));
    impl_->requestRender();
}

void View3D::setRoute(std::span<const Eigen::Vector3d> points) {
    impl_->scene.setRoute(points);
    impl_->requestRender();
}

void View3D::setTrajectory(std::span<const Eigen::Vector3d> points) {
    impl_->scene.setTrajectory(points);
    impl_->requestRender();
}

void View3D::setRobot(const std::optional<ViewRobot>& robot) {
    impl_->scene.setRobot(robot);
    impl_->requestRender();
}

void View3D::clear() {
    impl_->scene.clear();
    impl_->measured.clear();
    impl_->toolBar->setPeelHeight(std::nullopt);
    impl_->peelIsOurs = true;
    setStandardView(StandardView::Isometric);
    impl_->requestRender();
}

bool View3D::hasLayer(ViewLayer layer) const {
    return impl_->scene.has(layer);
}

bool View3D::isLayerVisible(ViewLayer layer) const {
    return impl_->scene.isVisible(layer);
}

void View3D::setLayerVisible(ViewLayer layer, bool visible) {
    if (impl_->scene.isVisible(layer) == visible) return;
    impl_->scene.setVisible(layer, visible);
    impl_->requestRender();
    emit layerVisibilityChanged(layer, visible);
}

double View3D::layerOpacity(ViewLayer layer) const {
    return impl_->scene.opacity(layer);
}

void View3D::setLayerOpacity(ViewLayer layer, double opacity) {
    impl_->scene.setOpacity(layer, opacity);
    impl_->requestRender();
}

void View3D::setStandardView(StandardView view) {
    OrbitCamera camera = impl_->camera;
    camera.parallel = view != StandardView::Isometric;
    switch (view) {
        case StandardView::Top:
            camera.azimuth_rad = -kQuarterTurn_rad;
            camera.elevation_rad = kQuarterTurn_rad;
            break;
        case StandardView::Front:
            camera.azimuth_rad = -kQuarterTurn_rad;
            camera.elevation_rad = 0.0;
            break;
        case StandardView::Side:
            camera.azimuth_rad = 0.0;
            camera.elevation_rad = 0.0;
            break;
        case StandardView::Isometric:
            camera.azimuth_rad = -0.62 * kQuarterTurn_rad;
            camera.elevation_rad = 0.42 * kQuarterTurn_rad;
            break;
    }
    impl_->cameraIsOurs = true;
    impl_->flyTo(impl_->fittedCamera(camera));
}

void View3D::fit() {
    impl_->flyTo(impl_->fittedCamera(impl_->camera));
    impl_->cameraIsOurs = true;
}

void View3D::flyTo(const Eigen::Vector3d& centroid, double radius_m) {
    Bounds box;
    box.extend(centroid - Eigen::Vector3d::Constant(radius_m));
    box.extend(centroid + Eigen::Vector3d::Constant(radius_m));
    impl_->cameraIsOurs = false;
    impl_->flyTo(fitted(impl_->camera, box, impl_->aspect(), kFitMargin));
}

void View3D::flyToCandidate(const QString& id) {
    for (const ViewCandidate& candidate : impl_->scene.candidates()) {
        if (candidate.id != id) continue;
        Bounds box;
        box.extend(candidate.centroid);
        for (const auto& point : candidate.points)
            box.extend(point);
        // The surroundings tell where it lies.
        flyTo(candidate.centroid, std::max(0.5, (box.maximum - box.minimum).norm()));
        return;
    }
}

void View3D::setPeelHeight(std::optional<double> height_m) {
    impl_->peelIsOurs = false;
    impl_->scene.setPeelHeight(height_m);
    impl_->toolBar->setPeelHeight(height_m);
    impl_->requestRender();
    emit peelHeightChanged();
}

std::optional<double> View3D::peelHeight() const {
    return impl_->scene.peelHeight();
}

void View3D::setMeasuring(bool measuring) {
    if (impl_->measuring == measuring) return;
    impl_->measuring = measuring;
    impl_->measured.clear();
    impl_->toolBar->setMeasuring(measuring);
    impl_->surface.widget()->setCursor(measuring ? Qt::CrossCursor : Qt::ArrowCursor);
    impl_->updateOverlay();
}

bool View3D::isMeasuring() const {
    return impl_->measuring;
}

std::optional<PickedPoint> View3D::pickAt(const QPoint& position) const {
    return impl_->pick(position);
}

std::optional<QPointF> View3D::positionOnScreen(const Eigen::Vector3d& point) const {
    const auto spot = impl_->projection().project(point);
    if (!spot) return std::nullopt;
    return QPointF(spot->x_px, spot->y_px);
}

void View3D::setEmptyMessage(const QString& message) {
    impl_->emptyMessage = message;
    impl_->requestRender();
}

void View3D::setToolBarVisible(bool visible) {
    impl_->toolBar->setVisible(visible);
    impl_->requestRender();
}

QImage View3D::grabImage() {
    // A picture is of where the flight leads, not of a moment of it.
    if (impl_->flight.state() == QAbstractAnimation::Running) {
        impl_->flight.stop();
        impl_->camera = impl_->flightEnd;
    }
    impl_->scene.setCoarse(false);
    impl_->render();
    return grab().toImage();
}

QSize View3D::sizeHint() const {
    return {800, 560};
}

QSize View3D::minimumSizeHint() const {
    return {320, 240};
}

void View3D::paintEvent(QPaintEvent* event) {
    // Whoever grabs the window gets what was asked for last.
    if (impl_->renderTimer.isActive()) impl_->render();
    QWidget::paintEvent(event);
}

void View3D::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    impl_->overlay->setGeometry(rect());
    impl_->contentChanged();
}

void View3D::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && impl_ != nullptr) {
        impl_->surface.setBackground(currentTheme().surface0);
        impl_->scene.setTheme(currentTheme());
        impl_->requestRender();
    }
    QWidget::changeEvent(event);
}

void View3D::keyPressEvent(QKeyEvent* event) {
    if (!impl_->key(*event)) QWidget::keyPressEvent(event);
}

bool View3D::eventFilter(QObject* watched, QEvent* event) {
    if (watched != impl_->surface.widget()) return QWidget::eventFilter(watched, event);
    switch (event->type()) {
        case QEvent::MouseButtonPress:
            setFocus(Qt::MouseFocusReason);
            impl_->press(*static_cast<QMouseEvent*>(event));
            return true;
        case QEvent::MouseMove:
            impl_->move(*static_cast<QMouseEvent*>(event));
            return true;
        case QEvent::MouseButtonRelease:
            impl_->release(*static_cast<QMouseEvent*>(event));
            return true;
        case QEvent::MouseButtonDblClick:
            impl_->doubleClick(*static_cast<QMouseEvent*>(event));
            return true;
        case QEvent::Wheel:
            impl_->wheel(*static_cast<QWheelEvent*>(event));
            return true;
        case QEvent::Leave:
            impl_->overlay->setHint({}, {});
            return false;
        default:
            return false;
    }
}

}  // namespace fodscope
