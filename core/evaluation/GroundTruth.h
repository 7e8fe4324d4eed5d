// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/common/Geometry.h"

namespace fodscope {

/// A FOD that was put into the tank for a trial.
struct GroundTruthFod {
    std::string type;
    /// Whether the map shows enough of it to be found at all.
    bool observed = true;
    /// `gt_centroid_map`: the mean of its own map points where it was observed, else its true centroid.
    Eigen::Vector3d centroid_map = Eigen::Vector3d::Zero();
};

/// A map with known FOD. A map without FOD is nominal: it trains a reference and enters no figure of an evaluation.
struct Trial {
    std::string name;
    std::filesystem::path map;
    std::vector<GroundTruthFod> fods;
    std::optional<Transform> T_cad_from_map;
    /// A known start pose, from which a registration may set out.
    std::optional<Transform> T_cad_from_map_initial;
    /// `NAME.yaml`, a ROS map_server grid.
    std::optional<std::filesystem::path> grid;

    bool isNominal() const { return fods.empty(); }
};

/// Reads a folder of trials: NAME.pcd with NAME.json beside it, sorted by name. Other files are left alone.
/// @throws Error for a missing folder, one without trials, and malformed truth: a map without truth or truth without
///         its map, a missing field, a wrong type, a number that is not finite, a transform that is not rigid. All
///         problems of the folder are listed at once, each with its file and field.
std::vector<Trial> readTrials(const std::filesystem::path& folder);

}  // namespace fodscope
