// SPDX-License-Identifier: MIT
#include "ui/view3d/ViewScene.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace fodscope {
namespace {

constexpr double kPickRadius_px = 7.0;
constexpr double kMeshOpacity = 0.22;
/// A candidate's point lies on a point of the discrepancy; within this it is the candidate that was meant.
constexpr double kCandidateBias_m = 0.10;

Bounds transformed(const Bounds& bounds, const Transform& transform) {
    Bounds box;
    if (bounds.empty()) return box;
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d point(corner & 1 ? bounds.maximum.x() : bounds.minimum.x(),
                                    corner & 2 ? bounds.maximum.y() : bounds.minimum.y(),
                                    corner & 4 ? bounds.maximum.z() : bounds.minimum.z());
        box.extend(Eigen::Vector3d(transform * point));
    }
    return box;
}

/// Points without a value have none that is known.
PointValues pointValues(std::span<const double> values, const ScalarStyle& style, std::size_t points) {
    PointValues result{{values.begin(), values.end()}, style, false};
    result.values.resize(points, std::nan(""));
    result.anyUnknown =
        std::any_of(result.values.begin(), result.values.end(), [](double value) { return std::isnan(value); });
    return result;
}

std::vector<std::uint32_t> knownDescending(const std::vector<double>& values) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < values.size(); ++i)
        if (!std::isnan(values[i])) order.push_back(i);
    std::ranges::sort(order, std::greater<>(), [&](std::uint32_t i) { return values[i]; });
    return order;
}

}  // namespace

ViewScene::ViewScene(vtkRenderer* renderer, vtkRenderer* top)
    : theme_(currentTheme()),
      reference_(renderer),
      map_(renderer),
      discrepancy_(renderer),
      discrepant_(renderer),
      candidatePoints_(top),
      mesh_(renderer),
      grid_(renderer, 1.0),
      waypointMarks_(top, 2.0),
      routeLine_(top, 2.5),
      trajectoryLine_(top, 1.5),
      robotMark_(top, 2.5),
      selection_(top, 2.0) {
    state(ViewLayer::ReferenceMesh).opacity = kMeshOpacity;
    setTheme(theme_);
}

void ViewScene::setTheme(const Theme& theme) {
    theme_ = theme;
    mesh_.setTheme(theme);
    colourReference();
    colourMap();
    colourDiscrepancy();
    buildCandidates();
    buildShapes();
    for (const ViewLayer layer : kViewLayers)
        apply(layer);
}

void ViewScene::setReference(std::span<const Eigen::Vector3d> points) {
    reference_.setPoints(points);
    referenceValues_ = {};
    colourReference();
    buildShapes();
    apply(ViewLayer::Reference);
}

void ViewScene::setReferenceValues(std::span<const double> values, const ScalarStyle& style) {
    referenceValues_ = values.empty() ? PointValues() : pointValues(values, style, reference_.points().size());
    colourReference();
    apply(ViewLayer::Reference);
}

void ViewScene::setReferenceMesh(std::span<const Eigen::Vector3d> vertices,
                                 std::span<const std::array<std::uint32_t, 3>> triangles) {
    mesh_.setMesh(vertices, triangles);
    buildShapes();
    apply(ViewLayer::ReferenceMesh);
}

void ViewScene::setMap(std::span<const Eigen::Vector3d> points) {
    map_.setPoints(points);
    colourMap();
    buildShapes();
    apply(ViewLayer::Map);
}

void ViewScene::setMapTransform(const Transform& T_reference_from_map) {
    T_reference_from_map_ = T_reference_from_map;
    map_.setTransform(T_reference_from_map);
}

void ViewScene::setDiscrepancy(std::span<const Eigen::Vector3d> points, std::span<const double> values,
                               const ScalarStyle& style) {
    discrepancy_.setPoints(points);
    discrepancyValues_ = pointValues(values, style, points.size());
    byDiscrepancy_ = knownDescending(discrepancyValues_.values);
    colourDiscrepancy();
    buildShapes();
    apply(ViewLayer::Discrepancy);
}

void ViewScene::setDiscrepancyThreshold(std::optional<double> threshold) {
    if (discrepancyValues_.style.threshold == threshold) return;
    const bool isMoved = discrepancyValues_.style.threshold && threshold;
    discrepancyValues_.style.threshold = threshold;
    if (isMoved)
        drawDiscrepant();
    else
        colourDiscrepancy();
    apply(ViewLayer::Discrepancy);
}

void ViewScene::setCandidates(std::vector<ViewCandidate> candidates) {
    candidates_ = std::move(candidates);
    buildCandidates();
    apply(ViewLayer::Candidates);
}

void ViewScene::setSelectedCandidate(const QString& id) {
    for (ViewCandidate& candidate : candidates_)
        candidate.selected = !id.isEmpty() && candidate.id == id;
    markSelection();
    apply(ViewLayer::Candidates);
}

void ViewScene::setFloorHeight(double height_m) {
    floor_m_ = height_m;
    buildShapes();
}

void ViewScene::setWaypoints(std::vector<ViewWaypoint> waypoints) {
    waypoints_ = std::move(waypoints);
    waypointMarks_.setShapes(waypointShapes(waypoints_, floor_m_, theme_));
    apply(ViewLayer::Waypoints);
}

void ViewScene::setRoute(std::span<const Eigen::Vector3d> points) {
    route_.assign(points.begin(), points.end());
    routeLine_.setShapes(lineShapes(route_, theme_.text));
    apply(ViewLayer::Route);
}

void ViewScene::setTrajectory(std::span<const Eigen::Vector3d> points) {
    trajectory_.assign(points.begin(), points.end());
    trajectoryLine_.setShapes(lineShapes(trajectory_, theme_.muted));
    apply(ViewLayer::Trajectory);
}

void ViewScene::setRobot(const std::optional<ViewRobot>& robot) {
    robot_ = robot;
    robotMark_.setShapes(robot ? robotShapes(*robot, floor_m_, theme_) : Shapes());
    apply(ViewLayer::Robot);
}

void ViewScene::clear() {
    setReference({});
    setReferenceMesh({}, {});
    setMap({});
    setMapTransform(Transform::Identity());
    setDiscrepancy({}, {}, {});
    setCandidates({});
    setWaypoints({});
    setRoute({});
    setTrajectory({});
    setRobot(std::nullopt);
    setPeelHeight(std::nullopt);
}

bool ViewScene::has(ViewLayer layer) const {
    switch (layer) {
        case ViewLayer::ReferenceMesh:
            return !mesh_.empty();
        case ViewLayer::Candidates:
            return !candidates_.empty();
        case ViewLayer::Waypoints:
            return !waypointMarks_.empty();
        case ViewLayer::Route:
            return !routeLine_.empty();
        case ViewLayer::Trajectory:
            return !trajectoryLine_.empty();
        case ViewLayer::Robot:
            return robot_.has_value();
        case ViewLayer::Grid:
            return !grid_.empty();
        default:
            return !pointLayer(layer)->empty();
    }
}

void ViewScene::setVisible(ViewLayer layer, bool visible) {
    state(layer).visible = visible;
    apply(layer);
}

void ViewScene::setOpacity(ViewLayer layer, double opacity) {
    state(layer).opacity = std::clamp(opacity, 0.0, 1.0);
    apply(layer);
}

void ViewScene::setPeelHeight(std::optional<double> height_m) {
    peel_m_ = height_m;
    for (PointLayer* layer : {&reference_, &map_, &discrepancy_, &discrepant_, &candidatePoints_})
        layer->setPeelHeight(height_m);
    mesh_.setPeelHeight(height_m);
}

Bounds ViewScene::bounds() const {
    Bounds box = reference_.bounds();
    box.extend(mesh_.bounds());
    box.extend(discrepancy_.bounds());
    box.extend(transformed(map_.bounds(), T_reference_from_map_));
    if (box.empty()) {
        for (const ViewCandidate& candidate : candidates_)
            box.extend(candidate.centroid);
        box.extend(waypointMarks_.bounds());
    }
    return box;
}

void ViewScene::setPixelsPerMetre(double pixelsPerMetre) {
    // Points grow with the zoom until they touch, so that a surface stays a surface, and never into blocks.
    const auto size = [pixelsPerMetre](const PointLayer& layer, double least, double most) {
        return std::clamp(0.7 * layer.spacing_m() * pixelsPerMetre, least, most);
    };
    reference_.setPointSize(size(reference_, 2.0, 7.0));
    map_.setPointSize(size(map_, 2.0, 6.0));
    discrepancy_.setPointSize(size(discrepancy_, 2.0, 7.0));
    discrepant_.setPointSize(size(discrepancy_, 2.0, 7.0));
    // Large enough to cover the discrepancy's point in the same place.
    const double covering = discrepancy_.empty() ? 5.0 : kAboveEmphasis * size(discrepancy_, 2.0, 7.0) + 1.0;
    const PointLayer& spaced = discrepancy_.empty() ? candidatePoints_ : discrepancy_;
    candidatePoints_.setPointSize(std::max(covering, size(spaced, 5.0, 12.0)));
}

void ViewScene::setCoarse(bool coarse) {
    for (PointLayer* layer : {&reference_, &map_, &discrepancy_, &discrepant_})
        layer->setCoarse(coarse);
}

std::optional<PickedPoint> ViewScene::pick(const ScreenProjection& projection, double x_px, double y_px) const {
    std::optional<PickedPoint> best;
    double bestDepth = 0.0;
    for (const ViewLayer layer :
         {ViewLayer::Candidates, ViewLayer::Discrepancy, ViewLayer::Map, ViewLayer::Reference}) {
        if (!isVisible(layer) || opacity(layer) <= 0.0) continue;
        const PointLayer& cloud = *pointLayer(layer);
        const std::vector<Eigen::Vector3f>* points = &cloud.points();
        std::vector<Eigen::Vector3f> moved;
        if (layer == ViewLayer::Map && !T_reference_from_map_.isApprox(Transform::Identity())) {
            const Eigen::Isometry3f motion = T_reference_from_map_.cast<float>();
            moved.reserve(points->size());
            for (const Eigen::Vector3f& point : *points)
                moved.push_back(motion * point);
            points = &moved;
        }
        const auto hit = pickNearest(*points, projection, x_px, y_px, kPickRadius_px,
                                     layer == ViewLayer::Candidates ? std::nullopt : peel_m_);
        if (!hit) continue;
        const double depth = hit->depth_m - (layer == ViewLayer::Candidates ? kCandidateBias_m : 0.0);
        if (best && depth >= bestDepth) continue;
        bestDepth = depth;
        best = PickedPoint{layer, hit->index, (*points)[hit->index].cast<double>(), {}};
        if (layer == ViewLayer::Candidates) {
            best->index = candidateOfPoint_[hit->index];
            best->candidateId = candidates_[best->index].id;
        }
    }
    return best;
}

const PointValues* ViewScene::legend() const {
    if (isVisible(ViewLayer::Discrepancy) && !discrepancyValues_.empty()) return &discrepancyValues_;
    if (isVisible(ViewLayer::Reference) && !referenceValues_.empty()) return &referenceValues_;
    return nullptr;
}

std::optional<double> ViewScene::valueAt(const PickedPoint& point) const {
    if (point.layer == ViewLayer::Discrepancy && point.index < discrepancyValues_.values.size()) {
        return discrepancyValues_.values[point.index];
    }
    if (point.layer == ViewLayer::Reference && point.index < referenceValues_.values.size()) {
        return referenceValues_.values[point.index];
    }
    return std::nullopt;
}

PointLayer* ViewScene::pointLayer(ViewLayer layer) {
    return const_cast<PointLayer*>(std::as_const(*this).pointLayer(layer));
}

const PointLayer* ViewScene::pointLayer(ViewLayer layer) const {
    switch (layer) {
        case ViewLayer::Reference:
            return &reference_;
        case ViewLayer::Map:
            return &map_;
        case ViewLayer::Discrepancy:
            return &discrepancy_;
        case ViewLayer::Candidates:
            return &candidatePoints_;
        default:
            return nullptr;
    }
}

ShapeLayer* ViewScene::shapeLayer(ViewLayer layer) {
    switch (layer) {
        case ViewLayer::Waypoints:
            return &waypointMarks_;
        case ViewLayer::Route:
            return &routeLine_;
        case ViewLayer::Trajectory:
            return &trajectoryLine_;
        case ViewLayer::Robot:
            return &robotMark_;
        case ViewLayer::Grid:
            return &grid_;
        default:
            return nullptr;
    }
}

void ViewScene::apply(ViewLayer layer) {
    const LayerState& wanted = state(layer);
    if (PointLayer* points = pointLayer(layer)) {
        points->setVisible(wanted.visible);
        points->setOpacity(wanted.opacity);
    }
    if (ShapeLayer* shapes = shapeLayer(layer)) {
        shapes->setVisible(wanted.visible);
        shapes->setOpacity(wanted.opacity);
    }
    if (layer == ViewLayer::ReferenceMesh) {
        mesh_.setVisible(wanted.visible);
        mesh_.setOpacity(wanted.opacity);
    }
    if (layer == ViewLayer::Discrepancy) {
        discrepant_.setVisible(wanted.visible);
        discrepant_.setOpacity(wanted.opacity);
    }
    if (layer == ViewLayer::Candidates) selection_.setVisible(wanted.visible);
}

}  // namespace fodscope
