// SPDX-License-Identifier: MIT
#include <cmath>

#include "core/inspection/ReportCandidates.h"
#include "core/inspection/ReportText.h"

namespace fodscope {
namespace {

/// RFC 4180: a field with a comma, a quote or a line break stands in quotes, and its quotes are doubled.
std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) {
        result += c;
        if (c == '"') result += c;
    }
    return result + "\"";
}

/// Empty when it is not known: a reader of the table expects a number or nothing.
std::string numberText(double value) {
    return std::isfinite(value) ? fixed(value, 4) : std::string();
}

std::string line(const std::vector<std::string>& fields) {
    std::string text;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (i > 0) text += ',';
        text += quoted(fields[i]);
    }
    return text + "\r\n";
}

}  // namespace

std::string reportCsv(const InspectionState& state) {
    std::string text =
        line({"candidate", "verdict", "labels", "x_reference_m", "y_reference_m", "z_reference_m", "x_map_m", "y_map_m",
              "z_map_m", "length_m", "width_m", "height_m", "height_above_floor_m", "points", "discrepancy_max",
              "discrepancy_mean", "photos", "no_photo_reason", "decisions"});
    const std::vector<ReportCandidate> told = reportCandidates(state);
    for (std::size_t i = 0; i < told.size(); ++i) {
        const Candidate& candidate = state.detection->candidates->candidates[i];
        std::vector<std::string> fields{told[i].id, toString(told[i].verdict), told[i].labels};
        for (const Eigen::Vector3d* triple :
             {&candidate.centroid_reference, &candidate.centroid_map, &candidate.size_m}) {
            for (const double value : *triple) {
                fields.push_back(numberText(value));
            }
        }
        fields.push_back(numberText(candidate.heightAboveFloor_m));
        fields.push_back(std::to_string(candidate.voxels.size()));
        fields.push_back(numberText(candidate.discrepancyMax));
        fields.push_back(numberText(candidate.discrepancyMean));
        fields.push_back(joined(told[i].photoIds, "; "));
        fields.push_back(told[i].noPhotoReason);
        fields.push_back(joined(told[i].decisions, "; "));
        text += line(fields);
    }
    return text;
}

}  // namespace fodscope
