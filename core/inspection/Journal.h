// SPDX-License-Identifier: MIT
#pragma once

#include "core/inspection/InspectionState.h"

namespace fodscope {

/// Where every act of an inspection goes before it counts. A method returns when the act is safe, and throws Error when
/// it is not: the inspection then stays as it was. Implemented by the session file (storage).
class Journal {
  public:
    virtual ~Journal() = default;

    virtual void recordHeader(const InspectionHeader& header) = 0;
    virtual void recordReference(const SourceFile& source, const ReferenceMap& reference) = 0;
    virtual void recordMap(const SourceFile& source) = 0;
    virtual void recordParameters(const Parameters& parameters) = 0;
    virtual void recordDetection(const DetectionRecord& detection, int highestCandidateNumber) = 0;
    virtual void recordPlan(const OccupancyGrid& grid_map, const VisitPlan& plan, const std::vector<Visit>& visits) = 0;
    virtual void recordRoute(const InspectionRoute& route, const std::vector<Visit>& visits) = 0;
    virtual void recordVisit(const Visit& visit) = 0;
    virtual void recordPhoto(const Photo& photo) = 0;
    virtual void recordLabelSet(const LabelSet& labelSet) = 0;
    virtual void recordDecision(const Decision& decision) = 0;
    virtual void recordReport(const ReportRecord& report) = 0;
};

}  // namespace fodscope
