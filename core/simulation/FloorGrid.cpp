// SPDX-License-Identifier: MIT
#include "core/simulation/FloorGrid.h"

#include <oneapi/tbb/parallel_for.h>

#include <cmath>

#include "core/common/Error.h"
#include "core/simulation/MeshShapes.h"

namespace fodscope {
namespace {

/// A floor lies at most this far below z = 0.
constexpr double kFloorDepth_m = 0.10;
constexpr int kRaysAcrossCell = 3;
constexpr double kMostCells = 16e6;

Eigen::AlignedBox3d boundsInFrame(const World& world, const Transform& T_frame_from_world) {
    Eigen::AlignedBox3d bounds;
    const auto extend = [&](const TriangleMesh& mesh) {
        for (const Eigen::Vector3d& vertex : mesh.vertices)
            bounds.extend(T_frame_from_world * vertex);
    };
    extend(world.structure);
    for (const WorldObject& object : world.objects)
        extend(object.mesh);
    return bounds;
}

OccupancyGrid emptyGrid(const Eigen::AlignedBox3d& bounds, double resolution_m, const std::string& name) {
    if (bounds.isEmpty())
        throw Error(name.empty() ? "world" : name, "it has no surface", "choose a world with a structure");
    const double margin = 2.0 * resolution_m;
    OccupancyGrid grid;
    grid.resolution_m = resolution_m;
    grid.origin_map = {bounds.min().x() - margin, bounds.min().y() - margin, 0.0};
    const double columns = std::ceil((bounds.sizes().x() + 2.0 * margin) / resolution_m);
    const double rows = std::ceil((bounds.sizes().y() + 2.0 * margin) / resolution_m);
    if (!(columns * rows < kMostCells))
        throw Error(name.empty() ? "world" : name, "it is too wide to be driven in (over 16 million grid cells)",
                    "check that its meshes are in metres");
    grid.width = static_cast<int>(columns);
    grid.height = static_cast<int>(rows);
    grid.cells.assign(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height), Cell::Unknown);
    return grid;
}

class FloorProbe {
  public:
    FloorProbe(const Raycaster& raycaster, const Transform& T_frame_from_world, const FloorGridSettings& settings)
        : raycaster_(raycaster), T_world_from_frame_(T_frame_from_world.inverse()), settings_(settings) {}

    Cell lookDown(const OccupancyGrid& grid, CellIndex index) const {
        bool floor = false;
        const Eigen::Vector2d centre = grid.centreOf(index);
        for (int i = 0; i < kRaysAcrossCell * kRaysAcrossCell; ++i) {
            const Eigen::Vector2d offset((i % kRaysAcrossCell + 0.5) / kRaysAcrossCell - 0.5,
                                         (i / kRaysAcrossCell + 0.5) / kRaysAcrossCell - 0.5);
            const Eigen::Vector2d at = centre + grid.resolution_m * offset;
            const auto hit = cast({at.x(), at.y(), settings_.obstacleMaximumHeight_m}, -Eigen::Vector3d::UnitZ(),
                                  settings_.obstacleMaximumHeight_m + kFloorDepth_m);
            if (!hit) continue;
            if (settings_.obstacleMaximumHeight_m - hit->distance_m >= settings_.obstacleMinimumHeight_m)
                return Cell::Occupied;
            floor = true;
        }
        return floor ? Cell::Free : Cell::Unknown;
    }

    /// Marks what a level ray meets; thin plates that stand upright are found by no ray from above.
    void lookAcross(OccupancyGrid& grid, Eigen::Vector3d start, const Eigen::Vector3d& direction,
                    double range_m) const {
        constexpr double kPast_m = 0.002;
        while (range_m > 0.0) {
            const auto hit = cast(start, direction, range_m);
            if (!hit) return;
            const Eigen::Vector3d point = start + hit->distance_m * direction;
            const CellIndex index = grid.cellAt(point.head<2>());
            if (grid.contains(index)) grid.cells[grid.offset(index)] = Cell::Occupied;
            start = point + kPast_m * direction;
            range_m -= hit->distance_m + kPast_m;
        }
    }

  private:
    std::optional<RayHit> cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double range_m) const {
        return raycaster_.cast(T_world_from_frame_ * origin, T_world_from_frame_.linear() * direction, range_m);
    }

    const Raycaster& raycaster_;
    Transform T_world_from_frame_;
    FloorGridSettings settings_;
};

}  // namespace

OccupancyGrid floorGrid(const World& world, const Raycaster& raycaster, const Transform& T_frame_from_world,
                        const FloorGridSettings& settings) {
    if (!(settings.resolution_m > 0.0) || !(settings.obstacleMaximumHeight_m > settings.obstacleMinimumHeight_m))
        throw Error("simulation", "the grid's resolution or obstacle heights are out of range",
                    "set a positive resolution, and heights that rise");
    OccupancyGrid grid = emptyGrid(boundsInFrame(world, T_frame_from_world), settings.resolution_m, world.name);
    const FloorProbe probe(raycaster, T_frame_from_world, settings);
    tbb::parallel_for(0, grid.height, [&](int row) {
        for (int column = 0; column < grid.width; ++column)
            grid.cells[grid.offset({column, row})] = probe.lookDown(grid, {column, row});
    });
    const double step_m = std::min(0.04, 0.5 * (settings.obstacleMaximumHeight_m - settings.obstacleMinimumHeight_m));
    const double width_m = grid.width * grid.resolution_m, height_m = grid.height * grid.resolution_m;
    for (double z = settings.obstacleMinimumHeight_m + 0.25 * step_m; z < settings.obstacleMaximumHeight_m;
         z += step_m) {
        for (int half = 0; half < 2 * grid.height; ++half)
            probe.lookAcross(grid,
                             {grid.origin_map.x_m, grid.origin_map.y_m + (half + 0.5) * 0.5 * grid.resolution_m, z},
                             Eigen::Vector3d::UnitX(), width_m);
        for (int half = 0; half < 2 * grid.width; ++half)
            probe.lookAcross(grid,
                             {grid.origin_map.x_m + (half + 0.5) * 0.5 * grid.resolution_m, grid.origin_map.y_m, z},
                             Eigen::Vector3d::UnitY(), height_m);
    }
    return grid;
}

std::vector<std::uint8_t> connectedFloor(const OccupancyGrid& grid, const Pose2& start) {
    constexpr double kTolerance_m = 0.3;
    std::vector<std::uint8_t> connected(grid.cells.size(), 0);
    const Eigen::Vector2d at(start.x_m, start.y_m);
    double nearest_m = kTolerance_m;
    std::vector<CellIndex> open;
    for (int row = 0; row < grid.height; ++row) {
        for (int column = 0; column < grid.width; ++column) {
            const double distance_m = (grid.centreOf({column, row}) - at).norm();
            if (grid.at({column, row}) != Cell::Free || !(distance_m < nearest_m)) continue;
            nearest_m = distance_m;
            open.assign(1, {column, row});
        }
    }
    if (!open.empty()) connected[grid.offset(open.front())] = 1;
    while (!open.empty()) {
        const CellIndex here = open.back();
        open.pop_back();
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            const CellIndex next{here.column + dx, here.row + dy};
            if (!grid.contains(next) || grid.at(next) != Cell::Free || connected[grid.offset(next)]) continue;
            connected[grid.offset(next)] = 1;
            open.push_back(next);
        }
    }
    return connected;
}

OccupancyGrid explored(OccupancyGrid grid, const Pose2& start) {
    const std::vector<std::uint8_t> floor = connectedFloor(grid, start);
    const auto bordersOnFloor = [&](int column, int row) {
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const CellIndex next{column + dx, row + dy};
                if (grid.contains(next) && floor[grid.offset(next)]) return true;
            }
        return false;
    };
    for (int row = 0; row < grid.height; ++row)
        for (int column = 0; column < grid.width; ++column) {
            Cell& cell = grid.cells[grid.offset({column, row})];
            const bool known =
                cell == Cell::Free ? floor[grid.offset({column, row})] != 0 : bordersOnFloor(column, row);
            if (!known) cell = Cell::Unknown;
        }
    return grid;
}

OccupancyGrid exploredFloor(const World& world) {
    const Pose2 start_map = poseFromTransform(world.T_map_from_world * transformFromPose(world.robotStart_world));
    return explored(floorGrid(world, Raycaster(world), world.T_map_from_world, {}), start_map);
}

}  // namespace fodscope
