// SPDX-License-Identifier: MIT
#include "ui/session/MapLoading.h"

#include <algorithm>
#include <sstream>

#include "core/cloud/PointCloudIo.h"
#include "core/cloud/Spacing.h"
#include "core/cloud/UnitCheck.h"
#include "core/common/Error.h"
#include "core/common/Files.h"
#include "core/common/Hash.h"

namespace fodscope {
namespace {

std::vector<Eigen::Vector3d> voxelsInMapFrame(const DetectionRecord& detection) {
    std::vector<Eigen::Vector3d> points = detection.field->points;
    const Transform T_map_from_reference = detection.registration.T_reference_from_map.inverse();
    for (Eigen::Vector3d& point : points)
        point = T_map_from_reference * point;
    return points;
}

}  // namespace

MapFile readMapFile(const std::filesystem::path& file, Progress& progress) {
    auto cloud = std::make_shared<const PointCloud>(readPointCloud(file, progress, "reading the map"));
    requireUsableCloud(cloud->points, file.filename().string());
    MapFile loaded;
    loaded.source = {file.string(), sha256OfFile(file), cloud->size()};
    progress.report("measuring its spacing", 0.7);
    loaded.map.spacing_m = medianSpacing_m(cloud->points, progress);
    loaded.map.cloud = std::move(cloud);
    return loaded;
}

OccupancyGrid makeGrid(const GridSources& sources) {
    if (sources.ready) return *sources.ready;
    const DetectionRecord& detection = sources.detection;
    if (!detection.field)
        throw Error("plan", "there is no aligned map to make a grid from", "align the map first, or load a grid file");
    // A reopened session has the voxels of the map; they cover the same floor.
    const auto points = sources.map ? sources.map->points : voxelsInMapFrame(detection);
    return occupancyFromMap(points, detection.registration.T_reference_from_map, detection.floorHeight_m,
                            detection.parameters.occupancy);
}

Transform readTransformCsv(const std::filesystem::path& file) {
    std::string text = readTextFile(file);
    std::replace(text.begin(), text.end(), ',', ' ');
    std::istringstream stream(text);
    std::array<double, 16> rows{};
    std::string surplus;
    for (double& number : rows)
        stream >> number;
    if (!stream || (stream >> surplus))
        throw Error(file.filename().string(), "it does not hold 4 rows of 4 numbers",
                    "choose a CSV with the transform from the map to the reference");
    return transformFromRows(rows, file.filename().string());
}

}  // namespace fodscope
