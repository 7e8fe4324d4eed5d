// SPDX-License-Identifier: MIT
#pragma once

#include "core/planning/CameraFit.h"

namespace fodscope {

/// Whether the robot may stand somewhere.
enum class Standing { OutsideGrid, OnUnknown, TooNear, BeyondReach, Reachable };

/// The floor as the search for poses sees it. The maps must outlive it.
class SearchFloor {
  public:
    /// @param targets no pose is on top of their voxels
    SearchFloor(const CostMap& collision, const CostMap& sight, std::span<const PlanTarget> targets,
                const WaypointSettings& settings);

    Standing standingAt(const Eigen::Vector2d& place_map) const;

    /// Cost summed along the line of sight from a place towards a part, one term a step; empty when a lethal cell
    /// interrupts it.
    std::optional<double> costOfSight(const Eigen::Vector2d& place_map, const PhotoPart& part) const;

    /// No place on the grid is farther from another.
    double diagonal_m() const;

  private:
    const CostMap* collision_;
    const CostMap* sight_;
    double costThresholdPercent_;
    double rayStep_cells_;
    /// 1 for cells that a candidate lies on or near.
    std::vector<std::uint8_t> isNearCandidate_;
};

/// A place from which a part is whole in the picture.
struct PhotoPlace {
    Eigen::Vector2d place_map = Eigen::Vector2d::Zero();
    /// Summed along the line of sight.
    double cost = 0.0;
    YawRange yaws;
};

struct PhotoPlaces {
    /// Ok with at least one place, else why there is none.
    WaypointStatus status = WaypointStatus::Unreachable;
    /// Round the ring, then outwards.
    std::vector<PhotoPlace> places;
};

/// Looks round the part's ring, and round wider ones until a place is found.
PhotoPlaces placesFor(const PhotoPart& part, const SearchFloor& floor, const CameraFit& camera,
                      const WaypointSettings& settings);

}  // namespace fodscope
