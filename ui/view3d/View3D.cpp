// SPDX-License-Identifier: MIT
#include "ui/view3d/View3D.h"

#include <QEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QTimer>
#include <QVBoxLayout>
#include <QVariantAnimation>
#include <QWheelEvent>
#include <cmath>

#include "ui/theme/Colours.h"
#include "ui/view3d/Peel.h"
#include "ui/view3d/RenderWidget.h"
#include "ui/view3d/ViewOverlay.h"
#include "ui/view3d/ViewScene.h"
#include "ui/view3d/ViewToolBar.h"

namespace fodscope {
namespace {

constexpr double kQuarterTurn_rad = 1.57079632679489661923;
constexpr double kFitMargin = 0.05;
constexpr int kFlight_ms = 250;
constexpr int kHoverPause_ms = 60;
constexpr int kRest_ms = 180;
constexpr int kClickReach_px = 4;
constexpr double kMarkReach_px = 10.0;
constexpr double kKeyTurn_px = 24.0;
constexpr double kZoomStep = 0.85;

QString distanceText(double distance_m) {
    if (distance_m < 1.0) return View3D::tr("%1 mm").arg(QLocale().toString(distance_m * 1000.0, 'f', 0));
    return View3D::tr("%1 m").arg(QLocale().toString(distance_m, 'f', 3));
}

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

class View3D::Impl {
  public:
    explicit Impl(View3D* view)
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

const ViewWaypoint* View3D::Impl::waypointAt(const QPoint& position) const {
    if (!scene.isVisible(ViewLayer::Waypoints)) return nullptr;
    const ScreenProjection screen = projection();
    for (const ViewWaypoint& waypoint : scene.waypoints()) {
        const auto spot = screen.project(Eigen::Vector3d(waypoint.pose.x_m, waypoint.pose.y_m, scene.floorHeight_m()));
        if (spot && std::hypot(spot->x_px - position.x(), spot->y_px - position.y()) < kMarkReach_px) return &waypoint;
    }
    return nullptr;
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
    if (std::isnan(*value)) return View3D::tr("%1: not known").arg(legend->style.title);
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
