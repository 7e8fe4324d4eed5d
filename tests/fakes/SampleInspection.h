// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/inspection/Inspection.h"
#include "core/inspection/InspectionState.h"

namespace fodscope::test {

/// A folder of its own that is gone when the test ends.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path path() const { return path_; }
    std::filesystem::path file(const std::string& name) const { return path_ / name; }

  private:
    std::filesystem::path path_;
};

InspectionHeader sampleHeader();
ReferenceMap sampleReference();
/// Two candidates on five voxels, with values that are unknown (NaN) among the discrepancies.
DetectionResult sampleDetection();
OccupancyGrid sampleGrid();
VisitPlan samplePlan();
Photo samplePhoto(const std::string& waypointId, const std::string& candidateId, const std::string& content);
LabelSet sampleLabels();

/// Drives an inspection through every kind of act: two photos, three decisions of which one is taken back, a report.
void fillInspection(Inspection& inspection);

/// Fails the test for every part in which the two differ.
void expectEqual(const InspectionState& actual, const InspectionState& expected);

}  // namespace fodscope::test
