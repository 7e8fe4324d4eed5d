// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/cloud/OutlierRemoval.h"
#include "core/common/Camera.h"
#include "core/coverage/Coverage.h"
#include "core/detection/Candidates.h"
#include "core/detection/Discrepancy.h"
#include "core/detection/LocalStatisticalTest.h"
#include "core/planning/CostMap.h"
#include "core/planning/OccupancyGrid.h"
#include "core/planning/Waypoints.h"
#include "core/reference/CadReference.h"
#include "core/reference/MeanReference.h"
#include "core/registration/Registration.h"
#include "core/robot/VisitRunner.h"

namespace fodscope {

/// How a reference map is made. An inspection does not read them: it takes a reference as it is, whose provenance tells
/// how it came about.
struct ReferenceSettings {
    double cadSpacing_m = CadReferenceSettings().spacing_m;
    double voxelSize_m = MeanReferenceSettings().voxelSize_m;
    double occupancyQuantile = MeanReferenceSettings().occupancyQuantile;
    CovarianceFitSettings covariance;

    bool operator==(const ReferenceSettings&) const = default;
};

/// The settings of every stage of an inspection: one record that the window, the command line and the report share.
struct Parameters {
    ReferenceSettings reference;
    OutlierRemovalSettings denoise;
    RegistrationSettings registration;
    DiscrepancySettings discrepancy;
    LocalStatisticalTestSettings chiSquare;
    CandidateSettings candidates;
    CoverageSettings coverage;
    OccupancySettings occupancy;
    CostMapSettings costMap;
    CameraSettings camera;
    WaypointSettings waypoints;
    VisitSettings visits;

    bool operator==(const Parameters&) const = default;
};

/// @return the settings of a mean reference, denoising among them
MeanReferenceSettings meanReferenceSettings(const Parameters& parameters);

/// @return the names that presetParameters() knows
std::vector<std::string> presetNames();

/// @return the parameters of a preset: "paper-physical", the default, are those of the paper's trials with a robot and
///         a mean reference; "paper-simulation" those of its simulated trials with a CAD reference
/// @throws Error for an unknown name, naming the known ones
Parameters presetParameters(const std::string& name);

/// @return the usual values for a metric: paperPhysicalCandidateSettings() with, for chi-square, the threshold of the
///         parameters' own test
CandidateSettings usualCandidateSettings(Metric metric, const Parameters& parameters);

/// Reads YAML, one section per stage, over `base`.
/// @throws Error for an unknown key (naming the nearest known one), a value of the wrong type or out of range; all
///         problems are listed at once
Parameters readParameters(const std::filesystem::path& file, const Parameters& base);
Parameters parseParameters(const std::string& yaml, const std::string& subject, const Parameters& base);

/// @return the whole record as commented YAML, which parseParameters reads back to an equal record
std::string parametersYaml(const Parameters& parameters);

}  // namespace fodscope
