// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/inspection/InspectionState.h"
#include "storage/CloudBlobs.h"

namespace fodscope {

/// The kinds of acts, as the column `kind` names them.
namespace act_kind {
inline constexpr const char* kHeader = "header";
inline constexpr const char* kReference = "reference";
inline constexpr const char* kMap = "map";
inline constexpr const char* kParameters = "parameters";
inline constexpr const char* kDetection = "detection";
inline constexpr const char* kPlan = "plan";
inline constexpr const char* kRoute = "route";
inline constexpr const char* kVisit = "visit";
inline constexpr const char* kPhoto = "photo";
inline constexpr const char* kLabelSet = "label set";
inline constexpr const char* kDecision = "decision";
inline constexpr const char* kReport = "report";
}  // namespace act_kind

/// What an act says, and the blobs that it names by their fingerprint.
struct ActContent {
    std::string kind;
    /// Who acted; empty: the inspector.
    std::string author;
    std::string payload;
    std::vector<Blob> blobs;
};

/// What of a detection lies in the file already, and how acts name it there: while candidates are tuned, one detection
/// after the other rests on the same clouds, which need not be written down and fingerprinted each time.
struct StoredClouds {
    std::weak_ptr<const DiscrepancyField> field;
    std::string fieldName;
    std::weak_ptr<const Coverage> coverage;
    std::string coverageName;
};

ActContent headerContent(const InspectionHeader& header);
ActContent referenceContent(const SourceFile& source, const ReferenceMap& reference);
ActContent mapContent(const SourceFile& source);
ActContent parametersContent(const Parameters& parameters);
/// @param stored what is in the file; afterwards what is there once the act is
ActContent detectionContent(const DetectionRecord& detection, int highestCandidateNumber, StoredClouds& stored);
ActContent planContent(const OccupancyGrid& grid_map, const VisitPlan& plan, const std::vector<Visit>& visits);
ActContent routeContent(const InspectionRoute& route, const std::vector<Visit>& visits);
ActContent visitContent(const Visit& visit);
ActContent photoContent(const Photo& photo);
ActContent labelSetContent(const LabelSet& labelSet);
ActContent decisionContent(const Decision& decision);
ActContent reportContent(const ReportRecord& report);

}  // namespace fodscope
