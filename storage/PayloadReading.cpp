// SPDX-License-Identifier: MIT
#include "storage/PayloadReading.h"

#include <cstdio>
#include <ctime>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "storage/Words.h"

namespace fodscope {

using Json = nlohmann::ordered_json;

namespace {

UtcTime timeFrom(const std::string& text) {
    std::tm parts{};
    int milliseconds = 0;
    if (std::sscanf(text.c_str(), "%d-%2d-%2dT%2d:%2d:%2d.%3dZ", &parts.tm_year, &parts.tm_mon, &parts.tm_mday,
                    &parts.tm_hour, &parts.tm_min, &parts.tm_sec, &milliseconds) != 7) {
        throw std::invalid_argument("\"" + text + "\" is no time");
    }
    parts.tm_year -= 1900;
    parts.tm_mon -= 1;
    return {static_cast<std::int64_t>(timegm(&parts)) * 1000 + milliseconds};
}

Eigen::Vector3d pointFrom(const Json& json) {
    return {numberFrom(json.at(0)), numberFrom(json.at(1)), numberFrom(json.at(2))};
}

Pose2 poseFrom(const Json& json) {
    return {numberFrom(json.at("x_m")), numberFrom(json.at("y_m")), numberFrom(json.at("yaw_rad"))};
}

/// To the last bit what was written, without a check of rigidity: the value was accepted when it was recorded.
Transform transformFrom(const Json& json) {
    Transform transform = Transform::Identity();
    for (std::size_t i = 0; i < 16; ++i) {
        transform.matrix()(static_cast<Eigen::Index>(i / 4), static_cast<Eigen::Index>(i % 4)) = numberFrom(json.at(i));
    }
    return transform;
}

Candidate candidateFrom(const Json& json) {
    Candidate candidate;
    candidate.id = json.at("id").get<std::string>();
    candidate.centroid_reference = pointFrom(json.at("centroid_reference_m"));
    candidate.centroid_map = pointFrom(json.at("centroid_map_m"));
    candidate.size_m = pointFrom(json.at("size_m"));
    candidate.lengthDirection_rad = numberFrom(json.at("length_direction_rad"));
    candidate.heightAboveFloor_m = numberFrom(json.at("height_above_floor_m"));
    candidate.discrepancyMax = numberFrom(json.at("discrepancy_max"));
    candidate.discrepancyMean = numberFrom(json.at("discrepancy_mean"));
    candidate.discrepancySum = numberFrom(json.at("discrepancy_sum"));
    return candidate;
}

std::optional<double> optionalNumber(const Json& json) {
    if (json.is_null()) return std::nullopt;
    return json.get<double>();
}

DrivePath driveFrom(const Json& json) {
    DrivePath drive;
    drive.length_m = numberFrom(json.at("length_m"));
    for (const Json& point : json.at("points_map_m")) {
        drive.points_map.emplace_back(numberFrom(point.at(0)), numberFrom(point.at(1)));
    }
    return drive;
}

Waypoint waypointFrom(const Json& json) {
    Waypoint waypoint;
    waypoint.id = json.at("id").get<std::string>();
    waypoint.candidateIds = json.at("candidates").get<std::vector<std::string>>();
    if (!json.at("pose_map").is_null()) waypoint.pose_map = poseFrom(json.at("pose_map"));
    waypoint.cost = numberFrom(json.at("cost"));
    waypoint.status = waypointStatusOf(json.at("status").get<std::string>());
    waypoint.takesPhoto = json.value("takes_photo", true);
    waypoint.drive = driveFrom(json.at("drive"));
    return waypoint;
}

PhotoLabel labelFrom(const Json& json) {
    PhotoLabel label;
    label.label = json.at("label").get<std::string>();
    const Json& box = json.at("box");
    if (!box.is_null()) {
        label.box = PixelBox{numberFrom(box.at("left_px")), numberFrom(box.at("top_px")),
                             numberFrom(box.at("width_px")), numberFrom(box.at("height_px"))};
    }
    return label;
}

void collectBlobs(const Json& json, std::vector<BlobName>& names) {
    if (json.is_object() && json.contains("sha256") && json.contains("format") && json.contains("bytes")) {
        names.push_back({json.at("sha256").get<std::string>(), json.at("format").get<std::string>(),
                         json.at("bytes").get<std::size_t>()});
        return;
    }
    if (!json.is_structured()) return;
    for (const auto& item : json) {
        collectBlobs(item, names);
    }
}

}  // namespace

std::vector<BlobName> blobsNamedIn(const Json& payload) {
    std::vector<BlobName> names;
    collectBlobs(payload, names);
    return names;
}

double numberFrom(const Json& json) {
    return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

InspectionHeader headerFrom(const Json& payload) {
    InspectionHeader header;
    header.id = payload.at("id").get<std::string>();
    header.title = payload.at("title").get<std::string>();
    header.ship = payload.at("ship").get<std::string>();
    header.tank = payload.at("tank").get<std::string>();
    header.workOrder = payload.at("work_order").get<std::string>();
    header.inspector = payload.at("inspector").get<std::string>();
    header.robot = payload.at("robot").get<std::string>();
    header.created = timeFrom(payload.at("created_utc").get<std::string>());
    header.softwareVersion = payload.at("software_version").get<std::string>();
    return header;
}

SourceFile sourceFrom(const Json& payload) {
    const Json& source = payload.at("source");
    return {source.at("path").get<std::string>(), source.at("sha256").get<std::string>(),
            source.at("points").get<std::size_t>()};
}

std::optional<PoseUncertainty> uncertaintyFrom(const Json& json) {
    if (json.is_null()) return std::nullopt;
    PoseUncertainty uncertainty;
    uncertainty.centre_reference = pointFrom(json.at("centre_reference_m"));
    const Json& covariance = json.at("covariance");
    for (std::size_t i = 0; i < 36; ++i)
        uncertainty.covariance(static_cast<Eigen::Index>(i / 6), static_cast<Eigen::Index>(i % 6)) =
            numberFrom(covariance.at(i));
    for (const Json& direction : json.at("loose_directions"))
        uncertainty.looseDirections.push_back(pointFrom(direction));
    uncertainty.looseTurn = json.at("loose_turn").get<bool>();
    return uncertainty;
}

RegistrationResult registrationFrom(const Json& json) {
    RegistrationResult registration;
    registration.T_reference_from_map = transformFrom(json.at("T_reference_from_map"));
    registration.quality = qualityOf(json.at("quality").get<std::string>());
    if (!json.at("converged").is_null()) registration.converged = json.at("converged").get<bool>();
    registration.rms_m = numberFrom(json.at("rms_m"));
    registration.overlap = numberFrom(json.at("overlap"));
    registration.summary = json.at("summary").get<std::string>();
    // Sessions of the first version know neither of these.
    if (!json.contains("alternatives")) return registration;
    registration.explained = numberFrom(json.at("explained"));
    if (const Json& start = json.at("start_T_reference_from_map"); !start.is_null())
        registration.start_T_reference_from_map = transformFrom(start);
    for (const Json& other : json.at("alternatives")) {
        registration.alternatives.push_back({transformFrom(other.at("T_reference_from_map")),
                                             numberFrom(other.at("rms_m")), numberFrom(other.at("overlap")),
                                             numberFrom(other.at("explained"))});
    }
    registration.uncertainty = uncertaintyFrom(json.at("uncertainty"));
    return registration;
}

CandidateSet candidateSetFrom(const Json& json) {
    CandidateSet set;
    set.pointsAboveThreshold = json.at("points_above_threshold").get<std::size_t>();
    for (const Json& candidate : json.at("list")) {
        set.candidates.push_back(candidateFrom(candidate));
    }
    return set;
}

OccupancyGrid gridFrom(const Json& json) {
    OccupancyGrid grid;
    grid.width = json.at("width").get<int>();
    grid.height = json.at("height").get<int>();
    grid.resolution_m = numberFrom(json.at("resolution_m"));
    grid.origin_map = poseFrom(json.at("origin_map"));
    return grid;
}

VisitPlan planFrom(const Json& payload) {
    VisitPlan plan;
    plan.start_map = poseFrom(payload.at("start_map"));
    plan.length_m = numberFrom(payload.at("length_m"));
    for (const Json& waypoint : payload.at("waypoints")) {
        plan.waypoints.push_back(waypointFrom(waypoint));
    }
    // Sessions of the first version know none of these.
    if (!payload.contains("views")) return plan;
    plan.nearestNextLength_m = optionalNumber(payload.at("nearest_next_length_m"));
    plan.shortestTourLength_m = optionalNumber(payload.at("shortest_tour_length_m"));
    for (const Json& view : payload.at("views")) {
        plan.views.push_back({view.at("candidate").get<std::string>(), numberFrom(view.at("share")),
                              waypointStatusOf(view.at("rest").get<std::string>())});
    }
    return plan;
}

InspectionRoute routeFrom(const Json& payload) {
    InspectionRoute route;
    route.highestNumber = payload.at("highest_number").get<int>();
    for (const Json& each : payload.at("poses")) {
        route.poses.push_back(
            {each.at("id").get<std::string>(), poseFrom(each.at("pose_map")), each.at("takes_photo").get<bool>()});
    }
    return route;
}

Visit visitFrom(const Json& json) {
    Visit visit;
    visit.waypointId = json.at("waypoint").get<std::string>();
    visit.state = visitStateOf(json.at("state").get<std::string>());
    visit.goalId = json.at("goal").get<std::string>();
    visit.tries = json.at("tries").get<int>();
    const auto reason = json.at("reason").get<std::string>();
    if (json.contains("detail")) {
        visit.reason = visitReasonOf(reason);
        visit.detail = json.at("detail").get<std::string>();
        visit.photoTries = json.at("photo_tries").get<int>();
    } else if (!reason.empty()) {
        // Sessions of the first version knew no closed set of reasons.
        visit.reason = VisitReason::NotRecorded;
        visit.detail = reason;
    }
    return visit;
}

Photo photoFrom(const Json& payload) {
    Photo photo;
    photo.id = payload.at("id").get<std::string>();
    photo.waypointId = payload.at("waypoint").get<std::string>();
    photo.requestId = payload.value("request", std::string());
    photo.candidateIds = payload.at("candidates").get<std::vector<std::string>>();
    photo.taken = timeFrom(payload.at("taken_utc").get<std::string>());
    photo.T_map_from_camera = transformFrom(payload.at("T_map_from_camera"));
    const Json& camera = payload.at("camera");
    photo.intrinsics = {camera.at("width_px").get<int>(), camera.at("height_px").get<int>(),
                        numberFrom(camera.at("fx_px")),   numberFrom(camera.at("fy_px")),
                        numberFrom(camera.at("cx_px")),   numberFrom(camera.at("cy_px"))};
    photo.mediaType = payload.at("image").at("format").get<std::string>();
    photo.sha256 = payload.at("image").at("sha256").get<std::string>();
    return photo;
}

LabelSet labelSetFrom(const Json& payload) {
    LabelSet set;
    set.name = payload.at("name").get<std::string>();
    for (const Json& label : payload.at("labels")) {
        set.labels.push_back({label.at("name").get<std::string>(), static_cast<char>(label.at("key").get<int>()),
                              labelKindOf(label.at("kind").get<std::string>())});
    }
    return set;
}

Decision decisionFrom(const Json& payload) {
    Decision decision;
    decision.photoId = payload.at("photo").get<std::string>();
    decision.labeller = payload.at("labeller").get<std::string>();
    decision.time = timeFrom(payload.at("decided_utc").get<std::string>());
    decision.takesBack = payload.at("takes_back").get<bool>();
    for (const Json& label : payload.at("labels")) {
        decision.labels.push_back(labelFrom(label));
    }
    decision.comment = payload.at("comment").get<std::string>();
    return decision;
}

ReportRecord reportFrom(const Json& payload) {
    ReportRecord report;
    report.issued = timeFrom(payload.at("issued_utc").get<std::string>());
    report.issuedBy = payload.at("issued_by").get<std::string>();
    report.fileName = payload.at("file").get<std::string>();
    report.sha256 = payload.at("sha256").get<std::string>();
    return report;
}

}  // namespace fodscope
