// SPDX-License-Identifier: MIT
#include "storage/Payloads.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/common/Hash.h"
#include "storage/Words.h"

namespace fodscope {
namespace {

using Json = nlohmann::ordered_json;

/// Text that is not UTF-8 is mended rather than refused: the act must not be lost for it.
std::string text(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json point(const Eigen::Vector3d& p) {
    return Json::array({p.x(), p.y(), p.z()});
}

Json pose(const Pose2& p) {
    return {{"x_m", p.x_m}, {"y_m", p.y_m}, {"yaw_rad", p.yaw_rad}};
}

Json transform(const Transform& t) {
    return rowsFromTransform(t);
}

/// Keeps the blob and tells how the payload names it.
Json keep(Blob blob, std::vector<Blob>& blobs) {
    Json named = {{"sha256", sha256(blob.bytes)}, {"format", blob.format}, {"bytes", blob.bytes.size()}};
    blobs.push_back(std::move(blob));
    return named;
}

/// @return the name of a cloud that is stored already, else the one that `store` gives it
template <typename Cloud, typename Store>
Json namedOnce(const std::shared_ptr<const Cloud>& cloud, std::weak_ptr<const Cloud>& stored, std::string& name,
               const Store& store) {
    if (stored.lock() == cloud) return Json::parse(name);
    const Json json = store();
    stored = cloud;
    name = text(json);
    return json;
}

Json sourceJson(const SourceFile& source) {
    return {{"path", source.path}, {"sha256", source.sha256}, {"points", source.points}};
}

Json uncertaintyJson(const std::optional<PoseUncertainty>& uncertainty) {
    if (!uncertainty) return nullptr;
    Json covariance = Json::array();
    for (Eigen::Index i = 0; i < 36; ++i)
        covariance.push_back(uncertainty->covariance(i / 6, i % 6));
    Json loose = Json::array();
    for (const Eigen::Vector3d& direction : uncertainty->looseDirections)
        loose.push_back(point(direction));
    return {{"centre_reference_m", point(uncertainty->centre_reference)},
            {"covariance", covariance},
            {"loose_directions", loose},
            {"loose_turn", uncertainty->looseTurn}};
}

Json registrationJson(const RegistrationResult& registration) {
    Json converged;
    if (registration.converged) converged = *registration.converged;
    Json alternatives = Json::array();
    for (const PoseAlternative& other : registration.alternatives) {
        alternatives.push_back({{"T_reference_from_map", transform(other.T_reference_from_map)},
                                {"rms_m", other.rms_m},
                                {"overlap", other.overlap},
                                {"explained", other.explained}});
    }
    Json start;
    if (registration.start_T_reference_from_map) start = transform(*registration.start_T_reference_from_map);
    return {{"T_reference_from_map", transform(registration.T_reference_from_map)},
            {"quality", wordOf(registration.quality)},
            {"converged", converged},
            {"rms_m", registration.rms_m},
            {"overlap", registration.overlap},
            {"explained", registration.explained},
            {"summary", registration.summary},
            {"start_T_reference_from_map", start},
            {"alternatives", alternatives},
            {"uncertainty", uncertaintyJson(registration.uncertainty)}};
}

Json candidateJson(const Candidate& candidate) {
    return {{"id", candidate.id},
            {"points", candidate.voxels.size()},
            {"centroid_reference_m", point(candidate.centroid_reference)},
            {"centroid_map_m", point(candidate.centroid_map)},
            {"size_m", point(candidate.size_m)},
            {"length_direction_rad", candidate.lengthDirection_rad},
            {"height_above_floor_m", candidate.heightAboveFloor_m},
            {"discrepancy_max", candidate.discrepancyMax},
            {"discrepancy_mean", candidate.discrepancyMean},
            {"discrepancy_sum", candidate.discrepancySum}};
}

Json candidateSetJson(const CandidateSet& set, std::vector<Blob>& blobs) {
    Json list = Json::array();
    for (const Candidate& candidate : set.candidates) {
        list.push_back(candidateJson(candidate));
    }
    return {{"points_above_threshold", set.pointsAboveThreshold},
            {"voxels", keep(encodeVoxels(set), blobs)},
            {"list", list}};
}

Json coverageJson(const Coverage& coverage, std::vector<Blob>& blobs) {
    return {{"observed_share", coverage.observedShare},
            {"left_out", coverage.leftOut},
            {"observed", keep(encodeCoverage(coverage), blobs)}};
}

Json gridJson(const OccupancyGrid& grid, std::vector<Blob>& blobs) {
    return {{"width", grid.width},
            {"height", grid.height},
            {"resolution_m", grid.resolution_m},
            {"origin_map", pose(grid.origin_map)},
            {"cells", keep(encodeGrid(grid), blobs)}};
}

Json driveJson(const DrivePath& drive) {
    Json points = Json::array();
    for (const Eigen::Vector2d& p : drive.points_map) {
        points.push_back(Json::array({p.x(), p.y()}));
    }
    return {{"length_m", drive.length_m}, {"points_map_m", points}};
}

Json orNull(const std::optional<double>& number) {
    return number ? Json(*number) : Json();
}

Json waypointJson(const Waypoint& waypoint) {
    Json where;
    if (waypoint.pose_map) where = pose(*waypoint.pose_map);
    return {{"id", waypoint.id},
            {"candidates", waypoint.candidateIds},
            {"pose_map", where},
            {"cost", waypoint.cost},
            {"status", wordOf(waypoint.status)},
            {"takes_photo", waypoint.takesPhoto},
            {"drive", driveJson(waypoint.drive)}};
}

Json visitJson(const Visit& visit) {
    return {{"waypoint", visit.waypointId},   {"state", wordOf(visit.state)}, {"goal", visit.goalId},
            {"reason", wordOf(visit.reason)}, {"detail", visit.detail},       {"tries", visit.tries},
            {"photo_tries", visit.photoTries}};
}

Json labelJson(const PhotoLabel& label) {
    Json box;
    if (label.box) {
        box = {{"left_px", label.box->left_px},
               {"top_px", label.box->top_px},
               {"width_px", label.box->width_px},
               {"height_px", label.box->height_px}};
    }
    return {{"label", label.label}, {"box", box}};
}

}  // namespace

ActContent headerContent(const InspectionHeader& header) {
    const Json json = {{"id", header.id},
                       {"title", header.title},
                       {"ship", header.ship},
                       {"tank", header.tank},
                       {"work_order", header.workOrder},
                       {"inspector", header.inspector},
                       {"robot", header.robot},
                       {"created_utc", toIso8601(header.created)},
                       {"software_version", header.softwareVersion}};
    return {act_kind::kHeader, header.inspector, text(json), {}};
}

ActContent referenceContent(const SourceFile& source, const ReferenceMap& reference) {
    ActContent content{act_kind::kReference, {}, {}, {}};
    content.payload = text({{"source", sourceJson(source)},
                            {"provenance", reference.provenance},
                            {"cloud", keep(encodeReference(reference), content.blobs)}});
    return content;
}

ActContent mapContent(const SourceFile& source) {
    return {act_kind::kMap, {}, text({{"source", sourceJson(source)}}), {}};
}

ActContent parametersContent(const Parameters& parameters) {
    return {act_kind::kParameters, {}, text({{"yaml", parametersYaml(parameters)}}), {}};
}

ActContent detectionContent(const DetectionRecord& detection, int highestCandidateNumber, StoredClouds& stored) {
    ActContent content{act_kind::kDetection, {}, {}, {}};
    Json field;
    Json candidates;
    Json coverage;
    if (detection.field)
        field = namedOnce(detection.field, stored.field, stored.fieldName,
                          [&] { return keep(encodeField(*detection.field), content.blobs); });
    if (detection.candidates) candidates = candidateSetJson(*detection.candidates, content.blobs);
    if (detection.coverage)
        coverage = namedOnce(detection.coverage, stored.coverage, stored.coverageName,
                             [&] { return coverageJson(*detection.coverage, content.blobs); });
    content.payload = text({{"parameters_yaml", parametersYaml(detection.parameters)},
                            {"registration", registrationJson(detection.registration)},
                            {"floor_height_m", detection.floorHeight_m},
                            {"highest_candidate_number", highestCandidateNumber},
                            {"field", field},
                            {"candidates", candidates},
                            {"coverage", coverage}});
    return content;
}

ActContent planContent(const OccupancyGrid& grid_map, const VisitPlan& plan, const std::vector<Visit>& visits) {
    ActContent content{act_kind::kPlan, {}, {}, {}};
    Json waypoints = Json::array();
    for (const Waypoint& waypoint : plan.waypoints) {
        waypoints.push_back(waypointJson(waypoint));
    }
    Json visitList = Json::array();
    for (const Visit& visit : visits) {
        visitList.push_back(visitJson(visit));
    }
    Json views = Json::array();
    for (const CandidateView& view : plan.views) {
        views.push_back({{"candidate", view.candidateId}, {"share", view.share}, {"rest", wordOf(view.rest)}});
    }
    content.payload = text({{"grid_map", gridJson(grid_map, content.blobs)},
                            {"start_map", pose(plan.start_map)},
                            {"length_m", plan.length_m},
                            {"nearest_next_length_m", orNull(plan.nearestNextLength_m)},
                            {"shortest_tour_length_m", orNull(plan.shortestTourLength_m)},
                            {"views", views},
                            {"waypoints", waypoints},
                            {"visits", visitList}});
    return content;
}

ActContent routeContent(const InspectionRoute& route, const std::vector<Visit>& visits) {
    Json poses = Json::array();
    for (const RoutePose& each : route.poses)
        poses.push_back({{"id", each.id}, {"pose_map", pose(each.pose_map)}, {"takes_photo", each.takesPhoto}});
    Json visitList = Json::array();
    for (const Visit& visit : visits)
        visitList.push_back(visitJson(visit));
    return {act_kind::kRoute,
            {},
            text({{"highest_number", route.highestNumber}, {"poses", poses}, {"visits", visitList}}),
            {}};
}

ActContent visitContent(const Visit& visit) {
    return {act_kind::kVisit, {}, text(visitJson(visit)), {}};
}

ActContent photoContent(const Photo& photo) {
    ActContent content{act_kind::kPhoto, {}, {}, {}};
    const CameraIntrinsics& camera = photo.intrinsics;
    content.payload = text({{"id", photo.id},
                            {"waypoint", photo.waypointId},
                            {"request", photo.requestId},
                            {"candidates", photo.candidateIds},
                            {"taken_utc", toIso8601(photo.taken)},
                            {"T_map_from_camera", transform(photo.T_map_from_camera)},
                            {"camera",
                             {{"width_px", camera.width_px},
                              {"height_px", camera.height_px},
                              {"fx_px", camera.fx_px},
                              {"fy_px", camera.fy_px},
                              {"cx_px", camera.cx_px},
                              {"cy_px", camera.cy_px}}},
                            {"image", keep({photo.mediaType, photo.bytes}, content.blobs)}});
    return content;
}

ActContent labelSetContent(const LabelSet& labelSet) {
    Json labels = Json::array();
    for (const Label& label : labelSet.labels) {
        labels.push_back({{"name", label.name}, {"key", static_cast<int>(label.key)}, {"kind", wordOf(label.kind)}});
    }
    return {act_kind::kLabelSet, {}, text({{"name", labelSet.name}, {"labels", labels}}), {}};
}

ActContent decisionContent(const Decision& decision) {
    Json labels = Json::array();
    for (const PhotoLabel& label : decision.labels) {
        labels.push_back(labelJson(label));
    }
    const Json json = {{"photo", decision.photoId},
                       {"labeller", decision.labeller},
                       {"decided_utc", toIso8601(decision.time)},
                       {"takes_back", decision.takesBack},
                       {"labels", labels},
                       {"comment", decision.comment}};
    return {act_kind::kDecision, decision.labeller, text(json), {}};
}

ActContent reportContent(const ReportRecord& report) {
    const Json json = {{"issued_utc", toIso8601(report.issued)},
                       {"issued_by", report.issuedBy},
                       {"file", report.fileName},
                       {"sha256", report.sha256}};
    return {act_kind::kReport, report.issuedBy, text(json), {}};
}

}  // namespace fodscope
