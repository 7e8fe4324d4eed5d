// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <span>

#include "core/inspection/InspectionState.h"

namespace fodscope {

/// A blob as a payload names it.
struct BlobName {
    std::string sha256;
    std::string format;
    std::size_t bytes = 0;
};

/// @return every blob that a payload names
std::vector<BlobName> blobsNamedIn(const nlohmann::ordered_json& payload);

// Payloads back to values. Each throws nlohmann's exception or std::invalid_argument for a payload that does not hold
// what it should. What stands in blobs is left to the caller.

InspectionHeader headerFrom(const nlohmann::ordered_json& payload);
SourceFile sourceFrom(const nlohmann::ordered_json& payload);
RegistrationResult registrationFrom(const nlohmann::ordered_json& registration);
/// Without voxels.
CandidateSet candidateSetFrom(const nlohmann::ordered_json& candidates);
/// Without cells.
OccupancyGrid gridFrom(const nlohmann::ordered_json& grid);
VisitPlan planFrom(const nlohmann::ordered_json& payload);
InspectionRoute routeFrom(const nlohmann::ordered_json& payload);
Visit visitFrom(const nlohmann::ordered_json& visit);
/// Without the bytes.
Photo photoFrom(const nlohmann::ordered_json& payload);
LabelSet labelSetFrom(const nlohmann::ordered_json& payload);
Decision decisionFrom(const nlohmann::ordered_json& payload);
ReportRecord reportFrom(const nlohmann::ordered_json& payload);

/// @return a number, NaN for null (JSON has no NaN)
double numberFrom(const nlohmann::ordered_json& json);

}  // namespace fodscope
