// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/cloud/PointCloud.h"
#include "core/inspection/InspectionState.h"

namespace fodscope {

/// The map of an inspection, while its file is at hand (a reopened session has its voxels, not its points).
struct LoadedMap {
    std::shared_ptr<const PointCloud> cloud;
    /// Median distance of a point to its nearest neighbour.
    double spacing_m = 0.0;
};

struct MapFile {
    SourceFile source;
    LoadedMap map;
};

/// Reads a map and measures its spacing. For a worker thread.
/// @throws Error; Cancelled
MapFile readMapFile(const std::filesystem::path& file, Progress& progress);

/// What an occupancy grid for planning can be made from, best first.
struct GridSources {
    /// From a file or from the robot itself.
    std::optional<OccupancyGrid> ready;
    std::shared_ptr<const PointCloud> map;
    DetectionRecord detection;
};

/// @throws Error when there is nothing to make it from
OccupancyGrid makeGrid(const GridSources& sources);

/// Reads 4 bare rows of 4 numbers, separated by commas or blanks.
/// @throws Error for another shape or no rigid transform
Transform readTransformCsv(const std::filesystem::path& file);

}  // namespace fodscope
