// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "core/inspection/JsonNumbers.h"
#include "core/inspection/ParameterJson.h"
#include "core/inspection/ReportModel.h"

namespace fodscope {
namespace {

using Json = nlohmann::ordered_json;

/// Null for what is not recorded: an empty text could be taken for a value.
Json textOrNull(const std::string& text) {
    return text.empty() ? Json() : Json(text);
}

Json timeOrNull(UtcTime time) {
    return time.milliseconds == 0 ? Json() : Json(toIso8601(time));
}

Json headerJson(const InspectionHeader& header) {
    return {{"id", textOrNull(header.id)},
            {"title", textOrNull(header.title)},
            {"ship", textOrNull(header.ship)},
            {"tank", textOrNull(header.tank)},
            {"work_order", textOrNull(header.workOrder)},
            {"inspector", textOrNull(header.inspector)},
            {"robot", textOrNull(header.robot)},
            {"created_utc", timeOrNull(header.created)},
            {"software_version", textOrNull(header.softwareVersion)}};
}

Json sourceJson(const std::optional<SourceFile>& source) {
    if (!source) return nullptr;
    return {{"path", source->path}, {"points", source->points}, {"sha256", textOrNull(source->sha256)}};
}

Json registrationJson(const RegistrationResult& registration) {
    Json converged;
    if (registration.converged) converged = *registration.converged;
    return {{"quality", qualityWord(registration.quality)},
            {"converged", converged},
            {"rms_m", rounded(registration.rms_m)},
            {"overlap", rounded(registration.overlap)},
            {"explained", rounded(registration.explained)},
            {"alternatives", jsonAlternatives(registration.alternatives)},
            {"uncertainty", jsonUncertainty(registration.uncertainty)},
            {"summary", registration.summary},
            {"T_reference_from_map", jsonTransform(registration.T_reference_from_map)}};
}

Json coverageJson(const DetectionRecord& detection) {
    if (!detection.coverage) return nullptr;
    return {{"observed_share", rounded(detection.coverage->observedShare)},
            {"observed_within_m", rounded(detection.parameters.coverage.observedWithin_m)},
            {"basis", "point density; no sensor rays were used"},
            {"reference_points", detection.coverage->observed.size()},
            {"reference_points_left_out", detection.coverage->leftOut}};
}

Json candidateJson(const Candidate& candidate, const CandidateVerdict& verdict) {
    return {{"id", candidate.id},
            {"verdict", toString(verdict.verdict)},
            {"labels", verdict.fodLabels},
            {"points", candidate.voxels.size()},
            {"centroid_reference", jsonPoint(candidate.centroid_reference)},
            {"centroid_map", jsonPoint(candidate.centroid_map)},
            {"size", jsonPoint(candidate.size_m)},
            {"height_above_floor", rounded(candidate.heightAboveFloor_m)},
            {"discrepancy_max", rounded(candidate.discrepancyMax)},
            {"discrepancy_mean", rounded(candidate.discrepancyMean)}};
}

Json detectionJson(const InspectionState& state) {
    if (!state.detection) return nullptr;
    const DetectionRecord& detection = *state.detection;
    Json candidates;
    Json above;
    if (detection.candidates) {
        candidates = Json::array();
        above = detection.candidates->pointsAboveThreshold;
        const std::vector<CandidateVerdict> verdicts = verdictsOf(state);
        for (std::size_t i = 0; i < verdicts.size(); ++i) {
            candidates.push_back(candidateJson(detection.candidates->candidates[i], verdicts[i]));
        }
    }
    return {{"parameters", jsonParameters(detection.parameters)},
            {"registration", registrationJson(detection.registration)},
            {"floor_height", rounded(detection.floorHeight_m)},
            {"coverage", coverageJson(detection)},
            {"points_above_threshold", above},
            {"candidates", candidates}};
}

Json waypointsJson(const InspectionState& state) {
    Json list = Json::array();
    if (!state.plan) return list;
    for (const Waypoint& waypoint : state.plan->waypoints) {
        Json pose;
        if (waypoint.pose_map) {
            pose = {{"x", rounded(waypoint.pose_map->x_m)},
                    {"y", rounded(waypoint.pose_map->y_m)},
                    {"yaw_deg", rounded(degreesFromRadians(waypoint.pose_map->yaw_rad))}};
        }
        list.push_back({{"id", waypoint.id},
                        {"candidates", waypoint.candidateIds},
                        {"pose_map", pose},
                        {"cost", rounded(waypoint.cost)},
                        {"status", toString(waypoint.status)},
                        {"drive_m", rounded(waypoint.drive.length_m)}});
    }
    return list;
}

/// How much of each candidate the plan shows.
Json viewsJson(const InspectionState& state) {
    Json list = Json::array();
    if (!state.plan) return list;
    for (const CandidateView& view : state.plan->views)
        list.push_back({{"id", view.candidateId}, {"shown", rounded(view.share)}, {"rest", toString(view.rest)}});
    return list;
}

Json visitsJson(const InspectionState& state) {
    Json list = Json::array();
    for (const Visit& visit : state.visits) {
        list.push_back({{"waypoint", visit.waypointId},
                        {"state", toString(visit.state)},
                        {"reason", textOrNull(reasonText(visit))},
                        {"tries", visit.tries}});
    }
    return list;
}

Json photosJson(const InspectionState& state) {
    Json list = Json::array();
    for (const Photo& photo : state.photos) {
        list.push_back({{"id", photo.id},
                        {"waypoint", photo.waypointId},
                        {"candidates", photo.candidateIds},
                        {"taken_utc", timeOrNull(photo.taken)},
                        {"width_px", photo.intrinsics.width_px},
                        {"height_px", photo.intrinsics.height_px},
                        {"fx_px", rounded(photo.intrinsics.fx_px)},
                        {"fy_px", rounded(photo.intrinsics.fy_px)},
                        {"cx_px", rounded(photo.intrinsics.cx_px)},
                        {"cy_px", rounded(photo.intrinsics.cy_px)},
                        {"T_map_from_camera", jsonTransform(photo.T_map_from_camera)},
                        {"media_type", photo.mediaType},
                        {"bytes", photo.bytes.size()},
                        {"sha256", photo.sha256}});
    }
    return list;
}

Json labelsJson(const Decision& decision) {
    Json list = Json::array();
    for (const PhotoLabel& label : decision.labels) {
        Json box;
        if (label.box) {
            box = {{"left_px", rounded(label.box->left_px)},
                   {"top_px", rounded(label.box->top_px)},
                   {"width_px", rounded(label.box->width_px)},
                   {"height_px", rounded(label.box->height_px)}};
        }
        list.push_back({{"label", label.label}, {"box", box}});
    }
    return list;
}

Json decisionsJson(const InspectionState& state) {
    Json list = Json::array();
    for (const Decision& decision : state.decisions) {
        list.push_back({{"photo", decision.photoId},
                        {"labeller", decision.labeller},
                        {"time_utc", timeOrNull(decision.time)},
                        {"undo", decision.takesBack},
                        {"labels", labelsJson(decision)},
                        {"comment", textOrNull(decision.comment)}});
    }
    return list;
}

Json reportsJson(const InspectionState& state) {
    Json list = Json::array();
    for (const ReportRecord& report : state.reports) {
        list.push_back({{"issued_utc", timeOrNull(report.issued)},
                        {"issued_by", textOrNull(report.issuedBy)},
                        {"file", report.fileName},
                        {"sha256", report.sha256}});
    }
    return list;
}

}  // namespace

std::string sessionJson(const InspectionState& state) {
    const ReportModel model = makeReportModel(state);
    Json labels = Json::array();
    for (const Label& label : state.labelSet.labels) {
        labels.push_back(label.name);
    }
    Json length, nearestNext, shortestTour;
    if (state.plan) {
        length = rounded(state.plan->length_m);
        if (state.plan->nearestNextLength_m) nearestNext = rounded(*state.plan->nearestNextLength_m);
        if (state.plan->shortestTourLength_m) shortestTour = rounded(*state.plan->shortestTourLength_m);
    }
    Json root = Json::object();
    root["schema"] = "fodscope.session/1";
    root["inspection"] = headerJson(state.header);
    root["statement"] = model.statement;
    root["limits"] = model.limits;
    root["missing"] = model.missing;
    root["reference"] = sourceJson(state.referenceSource);
    root["map"] = sourceJson(state.mapSource);
    root["parameters"] = jsonParameters(state.parameters);
    root["detection"] = detectionJson(state);
    root["waypoints"] = waypointsJson(state);
    root["drive_length_m"] = length;
    root["nearest_next_length_m"] = nearestNext;
    root["shortest_tour_length_m"] = shortestTour;
    root["planned_views"] = viewsJson(state);
    root["visits"] = visitsJson(state);
    root["photos"] = photosJson(state);
    root["label_set"] = {{"name", textOrNull(state.labelSet.name)}, {"labels", labels}};
    root["decisions"] = decisionsJson(state);
    root["reports"] = reportsJson(state);
    return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace fodscope
