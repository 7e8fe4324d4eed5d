// SPDX-License-Identifier: MIT
#include "storage/ActRows.h"

#include <nlohmann/json.hpp>

#include "storage/Payloads.h"

namespace fodscope {
namespace {

using Json = nlohmann::ordered_json;

CellValue real(const Json& json) {
    return json.is_null() ? CellValue() : CellValue(json.get<double>());
}

CellValue whole(const Json& json) {
    return json.get<std::int64_t>();
}

CellValue words(const Json& json) {
    return json.is_string() ? json.get<std::string>() : json.dump();
}

/// Null when the object that should hold the number is null.
CellValue realIn(const Json& object, const char* key) {
    return object.is_null() ? CellValue() : real(object.at(key));
}

ActRow candidateRow(std::int64_t act, std::int64_t position, const Json& c) {
    return {"candidates",
            {{"act", act},
             {"position", position},
             {"id", words(c.at("id"))},
             {"points", whole(c.at("points"))},
             {"centroid_x_reference_m", real(c.at("centroid_reference_m").at(0))},
             {"centroid_y_reference_m", real(c.at("centroid_reference_m").at(1))},
             {"centroid_z_reference_m", real(c.at("centroid_reference_m").at(2))},
             {"centroid_x_map_m", real(c.at("centroid_map_m").at(0))},
             {"centroid_y_map_m", real(c.at("centroid_map_m").at(1))},
             {"centroid_z_map_m", real(c.at("centroid_map_m").at(2))},
             {"length_m", real(c.at("size_m").at(0))},
             {"width_m", real(c.at("size_m").at(1))},
             {"height_m", real(c.at("size_m").at(2))},
             {"height_above_floor_m", real(c.at("height_above_floor_m"))},
             {"discrepancy_max", real(c.at("discrepancy_max"))},
             {"discrepancy_mean", real(c.at("discrepancy_mean"))}}};
}

ActRow waypointRow(std::int64_t act, std::int64_t position, const Json& w) {
    return {"waypoints",
            {{"act", act},
             {"position", position},
             {"id", words(w.at("id"))},
             {"candidates", words(w.at("candidates"))},
             {"x_map_m", realIn(w.at("pose_map"), "x_m")},
             {"y_map_m", realIn(w.at("pose_map"), "y_m")},
             {"yaw_map_rad", realIn(w.at("pose_map"), "yaw_rad")},
             {"cost", real(w.at("cost"))},
             {"status", words(w.at("status"))},
             {"drive_m", real(w.at("drive").at("length_m"))}}};
}

ActRow routeRow(std::int64_t act, std::int64_t position, const Json& w) {
    return {"waypoints",
            {{"act", act},
             {"position", position},
             {"id", words(w.at("id"))},
             {"candidates", std::string("[]")},
             {"x_map_m", realIn(w.at("pose_map"), "x_m")},
             {"y_map_m", realIn(w.at("pose_map"), "y_m")},
             {"yaw_map_rad", realIn(w.at("pose_map"), "yaw_rad")},
             {"cost", CellValue()},
             {"status", std::string("ok")},
             {"drive_m", CellValue()}}};
}

ActRow visitRow(std::int64_t act, std::int64_t position, const Json& v) {
    ActRow row{"visits",
               {{"act", act},
                {"position", position},
                {"waypoint_id", words(v.at("waypoint"))},
                {"state", words(v.at("state"))},
                {"goal_id", words(v.at("goal"))},
                {"reason", words(v.at("reason"))},
                {"tries", whole(v.at("tries"))}}};
    // Acts of the first version say nothing of these, nor had their files the columns.
    if (v.contains("detail")) row.columns.emplace_back("detail", words(v.at("detail")));
    if (v.contains("photo_tries")) row.columns.emplace_back("photo_tries", whole(v.at("photo_tries")));
    return row;
}

ActRow photoRow(std::int64_t act, const Json& p) {
    const Json& camera = p.at("camera");
    ActRow row{"photos",
               {{"act", act},
                {"id", words(p.at("id"))},
                {"waypoint_id", words(p.at("waypoint"))},
                {"candidates", words(p.at("candidates"))},
                {"taken_utc", words(p.at("taken_utc"))},
                {"media_type", words(p.at("image").at("format"))},
                {"width_px", whole(camera.at("width_px"))},
                {"height_px", whole(camera.at("height_px"))},
                {"fx_px", real(camera.at("fx_px"))},
                {"fy_px", real(camera.at("fy_px"))},
                {"cx_px", real(camera.at("cx_px"))},
                {"cy_px", real(camera.at("cy_px"))},
                {"T_map_from_camera", words(p.at("T_map_from_camera"))},
                {"sha256", words(p.at("image").at("sha256"))}}};
    if (p.contains("request")) row.columns.emplace_back("request_id", words(p.at("request")));
    return row;
}

ActRow decisionRow(std::int64_t act, const Json& d) {
    return {"decisions",
            {{"act", act},
             {"photo_id", words(d.at("photo"))},
             {"labeller", words(d.at("labeller"))},
             {"decided_utc", words(d.at("decided_utc"))},
             {"takes_back", std::int64_t{d.at("takes_back").get<bool>() ? 1 : 0}},
             {"comment", words(d.at("comment"))}}};
}

ActRow labelRow(std::int64_t act, std::int64_t position, const Json& l) {
    const Json& box = l.at("box");
    return {"decision_labels",
            {{"act", act},
             {"position", position},
             {"label", words(l.at("label"))},
             {"left_px", realIn(box, "left_px")},
             {"top_px", realIn(box, "top_px")},
             {"width_px", realIn(box, "width_px")},
             {"height_px", realIn(box, "height_px")}}};
}

template <typename MakeRow>
void addEach(std::vector<ActRow>& rows, std::int64_t act, const Json& list, MakeRow makeRow) {
    std::int64_t position = 0;
    for (const Json& item : list) {
        rows.push_back(makeRow(act, position++, item));
    }
}

}  // namespace

const std::vector<std::string>& actRowTables() {
    static const std::vector<std::string> kTables{"candidates", "waypoints", "visits",
                                                  "photos",     "decisions", "decision_labels"};
    return kTables;
}

std::vector<ActRow> rowsOf(std::int64_t sequence, const std::string& kind, const Json& payload) {
    std::vector<ActRow> rows;
    if (kind == act_kind::kDetection && !payload.at("candidates").is_null()) {
        addEach(rows, sequence, payload.at("candidates").at("list"), candidateRow);
    } else if (kind == act_kind::kPlan) {
        addEach(rows, sequence, payload.at("waypoints"), waypointRow);
        addEach(rows, sequence, payload.at("visits"), visitRow);
    } else if (kind == act_kind::kRoute) {
        addEach(rows, sequence, payload.at("poses"), routeRow);
        addEach(rows, sequence, payload.at("visits"), visitRow);
    } else if (kind == act_kind::kVisit) {
        rows.push_back(visitRow(sequence, 0, payload));
    } else if (kind == act_kind::kPhoto) {
        rows.push_back(photoRow(sequence, payload));
    } else if (kind == act_kind::kDecision) {
        rows.push_back(decisionRow(sequence, payload));
        addEach(rows, sequence, payload.at("labels"), labelRow);
    }
    return rows;
}

}  // namespace fodscope
