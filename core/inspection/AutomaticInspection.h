// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/inspection/DetectionPipeline.h"
#include "core/inspection/GroundTruthLabeller.h"
#include "core/inspection/Inspection.h"
#include "core/robot/RobotLink.h"

namespace fodscope {

/// What an inspection without a window sets out from.
struct AutomaticInspectionInput {
    SourceFile referenceSource;
    std::shared_ptr<const ReferenceMap> reference;
    SourceFile mapSource;
    Parameters parameters;
    /// A finished detection on reference and map with these parameters, well aligned.
    DetectionResult detection;
    OccupancyGrid grid_map;
    Pose2 robotStart_map;
    LabelSet labelSet;
};

/// Who labels the photos: a name for the record, and an answer for each photo. Empty labels leave it undecided.
struct AutomaticLabeller {
    std::string name;
    std::function<PhotoAnswer(const Photo&)> answer;
};

/// Carries a whole inspection out: adopts the detection, plans, drives the robot by a clock of its own (as fast as the
/// robot answers, nothing waits), has each photo labelled as it arrives. Every act goes through `inspection` to its
/// journal. Without candidates nothing is driven.
/// @throws Error when a stage fails or the robot does not finish; Cancelled (the goals are then cancelled)
void inspectAutomatically(const AutomaticInspectionInput& input, RobotLink& robot, const AutomaticLabeller& labeller,
                          Inspection& inspection, Progress& progress);

/// Goes on with the plan of an inspection at the first visit not done, as inspectAutomatically() drives it.
/// @throws Error as above, and without a plan
void resumeAutomatically(RobotLink& robot, const AutomaticLabeller& labeller, Inspection& inspection,
                         Progress& progress);

/// Drives the inspection route at the first pose not done. Photos of it are kept, and nobody labels them.
/// @throws Error when the robot holds, or the route has no poses; Cancelled (the goals are then cancelled)
void driveRoute(RobotLink& robot, Inspection& inspection, Progress& progress);

/// Asks the robot for its map.
/// @throws Error when none comes; Cancelled
std::shared_ptr<const PointCloud> fetchMap(RobotLink& robot, Progress& progress);

}  // namespace fodscope
