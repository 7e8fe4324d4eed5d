// SPDX-License-Identifier: MIT
#include "core/planning/PlanChecks.h"

#include <cmath>

#include "core/common/Error.h"

namespace fodscope {

void requireInRange(const WaypointSettings& settings) {
    const bool ring = settings.minimumDistance_m > 0.0 && settings.minimumDistance_m <= settings.maximumDistance_m &&
                      settings.maximumDistance_m <= 100.0 && settings.closestDistance_m >= 0.0 &&
                      settings.candidateClearance_m >= 0.0 && settings.candidateClearance_m <= 100.0;
    const bool widening = settings.widening >= 0.0 && settings.widening < 1.0 && settings.maximumTries >= 1 &&
                          settings.maximumTries <= 1000;
    const bool steps = settings.angleStep_rad >= 1e-3 && settings.distanceStep_m >= 1e-3 &&
                       settings.rayStep_cells >= 1e-3 && std::isfinite(settings.rayStep_cells) &&
                       std::isfinite(settings.angleStep_rad) && std::isfinite(settings.distanceStep_m);
    const bool threshold = settings.costThresholdPercent > 0.0 && settings.costThresholdPercent <= 99.0;
    const bool picture = settings.coarsestPixel_m > 0.0 && std::isfinite(settings.coarsestPixel_m) &&
                         settings.edgeMargin >= 0.0 && settings.edgeMargin < 0.5;
    if (!ring || !widening || !steps || !threshold || !picture) {
        throw Error(
            "waypoint settings", "a value is out of range",
            "give a ring within 100 m whose least distance is not over its greatest, steps of at least 0.001, a "
            "widening from 0 to under 1, 1 to 1000 tries, a cost threshold over 0 up to 99, a coarsest pixel over 0 m "
            "and an edge margin from 0 to under 0.5");
    }
}

void requireSameLattice(const CostMap& collision, const CostMap& sight) {
    requireUsable(collision.grid);
    requireUsable(sight.grid);
    const OccupancyGrid& a = collision.grid;
    const OccupancyGrid& b = sight.grid;
    if (a.width != b.width || a.height != b.height || a.resolution_m != b.resolution_m ||
        !(a.origin_map == b.origin_map)) {
        throw Error("sight cost map", "its lattice differs from the collision cost map's",
                    "make both from the same grid");
    }
    if (collision.costs.size() != a.cells.size() || sight.costs.size() != b.cells.size() ||
        collision.reachable.size() != a.cells.size()) {
        throw Error("collision cost map", "it was not inflated and flood filled from the robot's place",
                    "inflate the grid and flood fill it before planning");
    }
}

std::string waypointId(std::size_t number) {
    const std::string digits = std::to_string(number);
    return "W-" + std::string(digits.size() < 2 ? 1 : 0, '0') + digits;
}

}  // namespace fodscope
