// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/coverage/Coverage.h"
#include "core/inspection/Parameters.h"
#include "core/labels/Decision.h"
#include "core/labels/LabelSet.h"
#include "core/planning/Waypoints.h"
#include "core/robot/Photo.h"
#include "core/robot/VisitRunner.h"

namespace fodscope {

/// What was inspected. Empty means "not recorded".
struct InspectionHeader {
    std::string id;  ///< 32 random hexadecimal digits
    std::string title;
    std::string ship;
    std::string tank;
    std::string workOrder;
    std::string inspector;
    std::string robot;
    UtcTime created;
    std::string softwareVersion;
};

/// A file that an inspection rests on.
struct SourceFile {
    std::string path;
    std::string sha256;
    std::size_t points = 0;
};

/// Candidates with all that they rest on. The clouds are shared and never changed.
struct DetectionRecord {
    Parameters parameters;
    RegistrationResult registration;
    double floorHeight_m = 0.0;
    std::shared_ptr<const DiscrepancyField> field;
    std::shared_ptr<const CandidateSet> candidates;
    std::shared_ptr<const Coverage> coverage;
};

/// A report that was issued.
struct ReportRecord {
    UtcTime issued;
    std::string issuedBy;
    std::string fileName;
    std::string sha256;
};

/// Everything about one inspection: what a session file holds and a report tells.
struct InspectionState {
    InspectionHeader header;
    std::optional<SourceFile> referenceSource;
    std::optional<SourceFile> mapSource;
    /// The reference's points and covariances, so that a session opens without the file.
    std::shared_ptr<const ReferenceMap> reference;
    Parameters parameters;
    std::optional<DetectionRecord> detection;
    int highestCandidateNumber = 0;
    /// The grid that the plan was made on, map frame.
    std::optional<OccupancyGrid> grid_map;
    std::optional<VisitPlan> plan;
    std::vector<Visit> visits;
    std::vector<Photo> photos;
    LabelSet labelSet;
    std::vector<Decision> decisions;
    std::vector<ReportRecord> reports;
};

/// @return one verdict for each candidate, in the candidates' order
std::vector<CandidateVerdict> verdictsOf(const InspectionState& state);

}  // namespace fodscope
