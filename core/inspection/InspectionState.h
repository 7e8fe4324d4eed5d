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
#include "core/planning/InspectionRoute.h"
#include "core/planning/Waypoints.h"
#include "core/robot/Photo.h"
#include "core/robot/Visit.h"

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

    bool operator==(const InspectionHeader&) const = default;
};

/// @return a header with a random id, the time and this software's version; the rest is for people to fill in
InspectionHeader newInspectionHeader();

/// A file that an inspection rests on.
struct SourceFile {
    std::string path;
    std::string sha256;
    std::size_t points = 0;

    bool operator==(const SourceFile&) const = default;
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

    bool operator==(const ReportRecord&) const = default;
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
    /// Driven before the map is there, and its visits.
    InspectionRoute route;
    std::vector<Visit> routeVisits;
    /// The grid that the plan was made on, map frame.
    std::optional<OccupancyGrid> grid_map;
    std::optional<VisitPlan> plan;
    std::vector<Visit> visits;
    std::vector<Photo> photos;
    LabelSet labelSet;
    std::vector<Decision> decisions;
    std::vector<ReportRecord> reports;
};

/// How acts change the state: the same for an act that happens and for one that is read back from a session file.
/// A reference or map of another content makes detection and plan void, for they rested on the one before.
void applyReference(InspectionState& state, const SourceFile& source, std::shared_ptr<const ReferenceMap> reference);
void applyMap(InspectionState& state, const SourceFile& source);
/// Its parameters become those of the inspection; the plan for earlier candidates is void.
void applyDetection(InspectionState& state, const DetectionRecord& detection, int highestCandidateNumber);
void applyPlan(InspectionState& state, const OccupancyGrid& grid_map, const VisitPlan& plan,
               const std::vector<Visit>& visits);
void applyRoute(InspectionState& state, const InspectionRoute& route, const std::vector<Visit>& visits);
/// Replaces the visit to the same waypoint, or to the same pose of the route.
/// @return false when neither has it
bool applyVisit(InspectionState& state, const Visit& visit);

/// @return whether a visit to a candidate has begun or a photo of one exists: candidate ids may not change from then on
bool visitsHaveBegun(const InspectionState& state);

/// @return the photo with the id, or null
const Photo* findPhoto(const InspectionState& state, const std::string& photoId);

/// @return the visit to a waypoint or to a pose of the route, or null
const Visit* findVisit(const InspectionState& state, const std::string& waypointId);

/// @return what a runner must know of the photos that are kept
std::vector<PhotoMark> photoMarks(const InspectionState& state);

/// Decisions count for the candidates that they are about, see BoxOwners.h.
/// @return one verdict for each candidate, in the candidates' order
std::vector<CandidateVerdict> verdictsOf(const InspectionState& state);

}  // namespace fodscope
