// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/inspection/DetectionPipeline.h"
#include "core/inspection/InspectionState.h"
#include "core/inspection/Journal.h"
#include "core/planning/PlannedStops.h"

namespace fodscope {

/// One inspection and what may be done to it. Each act goes to the journal first; only when it is safe there does the
/// state change. Long work (detection, planning) is done outside by the stages' functions, in any thread, and its
/// result adopted here. Window, command line and tests drive the same class. Used from one thread.
class Inspection {
  public:
    /// A new inspection, or one read back from a session file.
    /// @param journal must outlive the inspection
    Inspection(InspectionState state, Journal& journal);

    const InspectionState& state() const { return state_; }

    void setHeader(const InspectionHeader& header);
    /// @throws Error once the visits have begun, as setMap() does: the photos show candidates of the ones before
    void setReference(const SourceFile& source, std::shared_ptr<const ReferenceMap> reference);
    void setMap(const SourceFile& source);
    void setParameters(const Parameters& parameters);

    /// Takes over the result of a detection. Candidate ids are carried over from the candidates before, until the
    /// visits have begun.
    /// @throws Error once the visits have begun: candidates are frozen then
    void adoptDetection(const Parameters& parameters, const DetectionResult& result);
    bool candidatesAreFrozen() const;

    /// @throws Error when there are no candidates, or visits have begun
    void adoptPlan(const OccupancyGrid& grid_map, const VisitPlan& plan);
    /// The route to drive before the map is there. A pose keeps its visit with its id; one that was changed after its
    /// visit began gets another id, so that what was said of one pose is never taken for another.
    void setRoute(InspectionRoute route);
    /// Of the plan or the route.
    void updateVisit(const Visit& visit);
    /// Records how the visits go on that were under way when the program ended, see resumedVisits().
    void resumeVisits();
    /// Gives the photo its id and fingerprint, and keeps it.
    /// @return the photo as kept
    const Photo& addPhoto(Photo photo);

    void setLabelSet(const LabelSet& labelSet);
    /// @throws Error for an unknown photo or label, no labels, `no FOD` beside others, or an empty labeller
    void decide(const std::string& photoId, const std::string& labeller, const std::vector<PhotoLabel>& labels,
                const std::string& comment, UtcTime time);
    /// Takes the labeller's latest act back: the decision before it on the same photo counts again, or none.
    /// @return the photo whose decision was taken back, or empty when there is nothing to undo
    std::optional<std::string> undoDecision(const std::string& labeller, UtcTime time);

    void reportIssued(const ReportRecord& report);

  private:
    void requireUnfrozen(const std::string& what) const;

    InspectionState state_;
    Journal& journal_;
};

/// The plan's input from a detection: targets of all candidates, in their order. None without candidates.
std::vector<PlanTarget> planTargets(const DetectionRecord& detection);

/// Every voxel above the threshold, clustered or not: none of them may hide a candidate from the camera.
std::vector<Eigen::Vector3d> discrepantPoints_map(const DetectionRecord& detection);

/// Plans visits for the candidates of a state on a grid: FOD-less sight map, inflation, flood fill, waypoints, order.
VisitPlan planInspection(const InspectionState& state, const OccupancyGrid& grid_map, const Pose2& robot_map,
                         Progress& progress);

/// The plan of a state with the operator's own stops, see planOfStops().
/// @throws Error without a plan, and naming a stop where the robot cannot stand; Cancelled
VisitPlan replanInspection(const InspectionState& state, std::span<const PlannedStop> stops, Progress& progress);

/// `candidates.json` of the file contract: equal input gives an equal text.
std::string candidatesJson(const SourceFile& reference, const SourceFile& map, const DetectionRecord& detection);

}  // namespace fodscope
