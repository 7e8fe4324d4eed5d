// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/robot_simulator/RobotModel.h"
#include "core/planning/CostMap.h"
#include "core/simulation/DepthMapping.h"
#include "core/simulation/MapVoxels.h"
#include "core/simulation/Raycaster.h"

namespace fodscope::robot_simulator {

/// A map that is there from the start.
struct FinishedMap {
    PointCloud cloud_map;
    std::vector<Pose2> path_map;
};

/// What the SLAM has of the world: a cloud, the grid of what was seen, and where it was seen from. It grows by a depth
/// image each time the robot has moved a little.
class SiteMap {
  public:
    /// @param floor_map the true occupancy of what the robot can reach, which is uncovered as it is seen
    SiteMap(std::shared_ptr<const World> world, std::shared_ptr<const Raycaster> raycaster, OccupancyGrid floor_map,
            const DepthMappingSettings& settings);

    void begin(FinishedMap map);
    /// Looks from there when that is far enough from the last view. Without `learn` the view is only compared.
    void see(const Pose2& robot_map, bool learn);

    std::uint64_t updates() const { return updates_; }
    std::uint64_t version() const { return version_; }
    std::vector<ColouredPoint> cloud() const;
    PercentGrid grid() const;
    PercentGrid costMap() const;
    const std::vector<Pose2>& path_map() const { return path_map_; }

  private:
    bool isNewView(const Pose2& robot_map) const;
    void learnFrom(const Pose2& robot_map);
    void uncoverLine(const Eigen::Vector2d& from_map, const Eigen::Vector2d& to_map);
    void uncoverAround(const Pose2& robot_map);
    OccupancyGrid knownPart() const;

    std::shared_ptr<const World> world_;
    std::shared_ptr<const Raycaster> raycaster_;
    DepthMappingSettings settings_;
    OccupancyGrid floor_map_;
    std::vector<bool> isKnown_;
    PointCloud finished_;
    MapVoxels voxels_;
    /// As they were, and as the SLAM believes them.
    std::vector<Transform> seenFrom_map_;
    std::vector<Pose2> path_map_;
    std::optional<Pose2> lastView_map_;
    std::uint64_t updates_ = 0;
    std::uint64_t version_ = 1;
};

}  // namespace fodscope::robot_simulator
