// SPDX-License-Identifier: MIT
#include "ui/window/SceneBinding.h"

#include <QLocale>
#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>

#include "core/reference/Covariance.h"
#include "core/reference/LogDeterminant.h"
#include "ui/panels/Format.h"
#include "ui/window/ReferenceColours.h"

namespace fodscope {
namespace {

constexpr double kStaleAfter_s = 2.0;

std::vector<Eigen::Vector3d> pointsOf(const DiscrepancyField& field, const Candidate& candidate) {
    std::vector<Eigen::Vector3d> points;
    points.reserve(candidate.voxels.size());
    for (const std::uint32_t voxel : candidate.voxels)
        points.push_back(field.points[voxel]);
    return points;
}

std::unordered_map<std::string, StatusKind> statesById(const InspectionController& controller) {
    std::unordered_map<std::string, StatusKind> states;
    for (const CandidateVerdict& verdict : controller.verdicts())
        states[verdict.candidateId] = candidateState(controller.state(), verdict).kind;
    return states;
}

ReportField field(const QString& name, const QString& value) {
    return {name.toStdString(), value.toStdString()};
}

void addTraining(const ReferenceMap& reference, std::size_t index, std::vector<ReportField>& fields) {
    if (index < reference.sampleCount.size())
        fields.push_back(
            field(QObject::tr("Samples"), count(static_cast<std::size_t>(std::max(0, reference.sampleCount[index])))));
    const bool untrained = index < reference.untrained.size() && reference.untrained[index] != 0;
    const double value = untrained ? std::nan("") : logDeterminant(reference.covariance[index]);
    fields.push_back(field(QObject::tr("Maps vary by"),
                           std::isnan(value) ? QObject::tr("not known: without training") : spreadText(value)));
    if (!std::isnan(value))
        fields.push_back(
            field(QObject::tr("log det Σ"), QObject::tr("%1 (Σ in m²)").arg(QLocale().toString(value, 'f', 1))));
}

}  // namespace

ScalarStyle discrepancyStyle(const CandidateSettings& settings) {
    ScalarStyle style;
    switch (settings.metric) {
        case Metric::Euclidean:
            style.title = QObject::tr("Euclidean");
            style.unit = QStringLiteral("mm");
            style.displayFactor = 1000.0;
            style.maximum = 0.1;
            style.decimals = 0;
            break;
        case Metric::Mahalanobis:
            style.title = QObject::tr("Mahalanobis");
            style.maximum = 10.0;
            style.decimals = 1;
            break;
        case Metric::ChiSquare:
            style.title = QObject::tr("Chi-square");
            style.maximum = 20.0;
            style.decimals = 1;
            break;
    }
    style.threshold = settings.threshold;
    return style;
}

SceneBinding::SceneBinding(InspectionController& controller, View3D& view, QObject* parent)
    : QObject(parent), controller_(controller), view_(view) {
    connect(&controller, &InspectionController::sessionChanged, this, &SceneBinding::refreshAll);
    connect(&controller, &InspectionController::referenceChanged, this, &SceneBinding::showReference);
    connect(&controller, &InspectionController::mapChanged, this, &SceneBinding::showMap);
    connect(&controller, &InspectionController::detectionChanged, this, &SceneBinding::showDetection);
    connect(&controller, &InspectionController::candidatesChanged, this, &SceneBinding::showCandidates);
    connect(&controller, &InspectionController::planChanged, this, &SceneBinding::showPlan);
    connect(&controller, &InspectionController::visitsChanged, this, &SceneBinding::showPlan);
    connect(&controller, &InspectionController::decisionsChanged, this, &SceneBinding::showCandidates);
    connect(&controller, &InspectionController::robotChanged, this, &SceneBinding::showRobot);
    connect(&controller, &InspectionController::selectionChanged, &view, &View3D::setSelectedCandidate);
    connect(&controller, &InspectionController::flyToRequested, &view, &View3D::flyToCandidate);
    connect(&controller, &InspectionController::flyToPlaceRequested, &view, &View3D::flyTo);
    connect(&controller, &InspectionController::posePreviewChanged, this, &SceneBinding::showMap);
    connect(&controller, &InspectionController::residualsChanged, this, [this] {
        colourReference();
        showLayers();
    });
    connect(&view, &View3D::candidateSelected, &controller, &InspectionController::selectCandidate);
    connect(&view, &View3D::candidateActivated, &controller, &InspectionController::flyToCandidate);
    connect(&view, &View3D::waypointSelected, this, [this](const QString& id) {
        const auto& plan = controller_.state().plan;
        if (!plan) return;
        for (const Waypoint& waypoint : plan->waypoints)
            if (waypoint.id == id.toStdString() && !waypoint.candidateIds.empty())
                controller_.selectCandidate(QString::fromStdString(waypoint.candidateIds.front()));
    });
    connect(&view, &View3D::picked, this, &SceneBinding::tellPoint);
    refreshAll();
}

void SceneBinding::setStep(Step step) {
    step_ = step;
    colourReference();
    showMap();
    showLayers();
}

void SceneBinding::setResiduals(bool shown) {
    residuals_ = shown;
    colourReference();
    showLayers();
}

bool SceneBinding::showsResiduals() const {
    return residuals_ && step_ == Step::Map && controller_.residuals();
}

void SceneBinding::setHeatMap(bool shown) {
    heatMap_ = shown;
    colourReference();
    showLayers();
}

void SceneBinding::colourReference() {
    const auto& reference = controller_.state().reference;
    const bool showsHeat = heatMap_ && step_ == Step::Reference && reference && reference->hasCovariance();
    std::shared_ptr<const void> wanted;
    if (showsResiduals())
        wanted = controller_.residuals();
    else if (showsHeat)
        wanted = reference;
    if (wanted == colouredBy_) return;
    colouredBy_ = wanted;
    if (!wanted) {
        view_.setReferenceValues({}, {});
        return;
    }
    const ReferenceColours colours =
        showsResiduals() ? residualColours(*controller_.residuals()) : covarianceColours(*reference);
    view_.setReferenceValues(colours.values, colours.style);
}

void SceneBinding::refreshAll() {
    shownReference_ = nullptr;
    shownMap_ = nullptr;
    shownField_ = nullptr;
    fitted_ = false;
    heatMap_ = false;
    residuals_ = false;
    colouredBy_.reset();
    view_.clear();
    view_.setEmptyMessage(tr("Load a reference to begin: a CAD mesh, a reference map or nominal maps."));
    if (!controller_.isOpen()) return;
    showReference();
    showMap();
    showDetection();
    showPlan();
    showRobot();
}

void SceneBinding::showReference() {
    const auto& reference = controller_.state().reference;
    if (!reference || reference.get() == shownReference_) return;
    shownReference_ = reference.get();
    view_.setReference(reference->points);
    colouredBy_.reset();
    colourReference();
    if (!fitted_) {
        fitted_ = true;
        view_.setStandardView(StandardView::Isometric);
        view_.fit();
    }
    showLayers();
}

Transform SceneBinding::T_reference_from_map() const {
    const auto& detection = controller_.state().detection;
    return detection ? detection->registration.T_reference_from_map : Transform::Identity();
}

double SceneBinding::floorHeight_m() const {
    const auto& detection = controller_.state().detection;
    return detection ? detection->floorHeight_m : 0.0;
}

void SceneBinding::showMap() {
    const auto& map = controller_.loadedMap();
    const PointCloud* cloud = map ? map->cloud.get() : nullptr;
    if (cloud != shownMap_) {
        shownMap_ = cloud;
        view_.setMap(cloud ? std::span<const Eigen::Vector3d>(cloud->points) : std::span<const Eigen::Vector3d>{});
    }
    const auto& previewed = controller_.previewedPose();
    view_.setMapTransform(previewed && step_ == Step::Map ? *previewed : T_reference_from_map());
    showLayers();
}

void SceneBinding::showDetection() {
    const auto& detection = controller_.state().detection;
    const DiscrepancyField* shown = detection ? detection->field.get() : nullptr;
    const CandidateSettings& settings = controller_.state().parameters.candidates;
    if (shown != shownField_ || shownMetric_ != settings.metric) {
        shownField_ = shown;
        shownMetric_ = settings.metric;
        const bool known = shown && shown->has(settings.metric);
        if (known)
            view_.setDiscrepancy(shown->points, shown->smoothed(settings.metric), discrepancyStyle(settings));
        else
            view_.setDiscrepancy({}, {}, discrepancyStyle(settings));
    }
    view_.setFloorHeight(floorHeight_m());
    view_.setMapTransform(T_reference_from_map());
    showCandidates();
    showLayers();
}

void SceneBinding::showCandidates() {
    const auto shown = controller_.shownCandidates();
    std::vector<ViewCandidate> candidates;
    if (shown && controller_.state().detection && controller_.state().detection->field) {
        const DiscrepancyField& voxels = *controller_.state().detection->field;
        const auto states = statesById(controller_);
        for (const Candidate& candidate : shown->candidates) {
            ViewCandidate view;
            view.id = QString::fromStdString(candidate.id);
            view.points = pointsOf(voxels, candidate);
            view.centroid = candidate.centroid_reference;
            view.selected = view.id == controller_.selectedCandidate();
            const auto state = states.find(candidate.id);
            view.state = state == states.end() ? StatusKind::Attention : state->second;
            candidates.push_back(std::move(view));
        }
    }
    view_.setDiscrepancyThreshold(controller_.shownCandidateSettings().threshold);
    view_.setCandidates(std::move(candidates));
}

Pose2 SceneBinding::inReference(const Pose2& pose_map) const {
    return poseFromTransform(T_reference_from_map() * transformFromPose(pose_map));
}

void SceneBinding::showPlan() {
    const InspectionState& state = controller_.state();
    std::vector<ViewWaypoint> waypoints;
    std::vector<Eigen::Vector3d> route;
    if (state.plan) {
        const double drawn_m = floorHeight_m() + 0.02;
        for (const Waypoint& waypoint : state.plan->waypoints) {
            if (!waypoint.pose_map) continue;
            ViewWaypoint view;
            view.id = QString::fromStdString(waypoint.id);
            view.pose = inReference(*waypoint.pose_map);
            if (!waypoint.candidateIds.empty())
                if (const Candidate* target =
                        controller_.findShownCandidate(QString::fromStdString(waypoint.candidateIds.front())))
                    view.target = target->centroid_reference;
            if (const Visit* visit = visitOf(state, waypoint.id)) view.state = stateText(*visit).kind;
            waypoints.push_back(view);
            for (const Eigen::Vector2d& point : waypoint.drive.points_map) {
                Eigen::Vector3d place = T_reference_from_map() * Eigen::Vector3d(point.x(), point.y(), 0.0);
                place.z() = drawn_m;
                route.push_back(place);
            }
        }
    }
    view_.setWaypoints(std::move(waypoints));
    view_.setRoute(route);
    showLayers();
}

void SceneBinding::showRobot() {
    const auto& robot = controller_.visits().robotState();
    if (!robot || !robot->pose_map) {
        view_.setRobot(std::nullopt);
        return;
    }
    const bool stale = controller_.visits().now_s() - robot->poseMeasured_s > kStaleAfter_s;
    view_.setRobot(ViewRobot{inReference(*robot->pose_map), stale});
}

void SceneBinding::showLayers() {
    const bool aligned = controller_.state().detection && controller_.state().detection->field;
    const bool residuals = showsResiduals();
    const bool candidates = step_ != Step::Reference && aligned && !residuals;
    const bool driving = step_ == Step::Visit || step_ == Step::Label || step_ == Step::Report;
    view_.setLayerVisible(ViewLayer::Reference, step_ == Step::Reference || !aligned || residuals);
    view_.setLayerVisible(ViewLayer::Map, step_ == Step::Map && !aligned);
    view_.setLayerVisible(ViewLayer::Discrepancy, candidates);
    view_.setLayerVisible(ViewLayer::Candidates, candidates && step_ != Step::Map);
    view_.setLayerVisible(ViewLayer::Waypoints, driving);
    view_.setLayerVisible(ViewLayer::Route, driving);
    view_.setLayerVisible(ViewLayer::Robot, driving);
}

void SceneBinding::tellPoint(const PickedPoint& point) {
    std::vector<ReportField> fields{field(tr("Layer"), toString(point.layer)),
                                    field(tr("Place"), placeText(point.position))};
    const auto& detection = controller_.state().detection;
    if (point.layer == ViewLayer::Discrepancy && detection && detection->field &&
        point.index < detection->field->size()) {
        const DiscrepancyField& voxels = *detection->field;
        fields.push_back(field(tr("Map points"), count(voxels.weights[point.index])));
        fields.push_back(field(tr("Euclidean"), millimetres(voxels.euclidean_m[point.index], 1)));
        fields.push_back(field(tr("smoothed"), millimetres(voxels.smoothedEuclidean_m[point.index], 1)));
        if (voxels.hasMahalanobis()) {
            fields.push_back(
                field(tr("Mahalanobis"), discrepancyText(voxels.mahalanobis[point.index], Metric::Mahalanobis)));
            fields.push_back(
                field(tr("smoothed"), discrepancyText(voxels.smoothedMahalanobis[point.index], Metric::Mahalanobis)));
        }
        if (voxels.has(Metric::ChiSquare))
            fields.push_back(
                field(tr("Chi-square"), discrepancyText(voxels.chiSquare[point.index], Metric::ChiSquare)));
    }
    const auto& reference = controller_.state().reference;
    if (point.layer == ViewLayer::Reference && reference && reference->hasCovariance() &&
        point.index < reference->size())
        addTraining(*reference, point.index, fields);
    if (!point.candidateId.isEmpty()) fields.push_back(field(tr("Candidate"), point.candidateId));
    controller_.setProbe(std::move(fields));
}

}  // namespace fodscope
