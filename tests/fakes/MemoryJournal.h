// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/common/Error.h"
#include "core/inspection/Journal.h"

namespace fodscope::test {

/// Notes the kind of each act, or fails as a full disk does.
class MemoryJournal : public Journal {
  public:
    std::vector<std::string> acts;
    bool diskIsFull = false;

    void recordHeader(const InspectionHeader&) override { note("header"); }
    void recordReference(const SourceFile&, const ReferenceMap&) override { note("reference"); }
    void recordMap(const SourceFile&) override { note("map"); }
    void recordParameters(const Parameters&) override { note("parameters"); }
    void recordDetection(const DetectionRecord&, int) override { note("detection"); }
    void recordPlan(const OccupancyGrid&, const VisitPlan&, const std::vector<Visit>&) override { note("plan"); }
    void recordRoute(const InspectionRoute&, const std::vector<Visit>&) override { note("route"); }
    void recordVisit(const Visit&) override { note("visit"); }
    void recordPhoto(const Photo&) override { note("photo"); }
    void recordLabelSet(const LabelSet&) override { note("label set"); }
    void recordDecision(const Decision&) override { note("decision"); }
    void recordReport(const ReportRecord&) override { note("report"); }

  private:
    void note(const std::string& kind) {
        if (diskIsFull) throw Error("session", "the disk is full", "make room");
        acts.push_back(kind);
    }
};

}  // namespace fodscope::test
