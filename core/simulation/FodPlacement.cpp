// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/common/Error.h"
#include "core/simulation/BuiltinTank.h"
#include "core/simulation/FloorGrid.h"
#include "core/simulation/MeshShapes.h"
#include "core/simulation/Random.h"

namespace fodscope {
namespace {

/// Higher than the floor strips that a tool may lie across.
constexpr double kFlatFloor_m = 0.02;
constexpr double kTallestFod_m = 0.25;
constexpr double kResolution_m = 0.02;

/// Where FOD may lie, kept up as they are put down.
class FloorSpace {
  public:
    FloorSpace(const World& world, const Raycaster& raycaster)
        : raycaster_(raycaster),
          clear_(floorGrid(world, raycaster, Transform::Identity(), {kResolution_m, kFlatFloor_m, kTallestFod_m})) {
        const OccupancyGrid passage = floorGrid(world, raycaster, Transform::Identity(), {kResolution_m, 0.13, 0.45});
        // Inside the tank is the floor that connects with the robot's start past everything a person steps over.
        const std::vector<std::uint8_t> inside = connectedFloor(passage, world.robotStart_world);
        for (std::size_t i = 0; i < clear_.cells.size(); ++i)
            if (!inside[i]) clear_.cells[i] = Cell::Unknown;
    }

    /// @return the place nearest to `wish` where the mesh touches nothing but the floor
    std::optional<Eigen::Vector2d> nearestPlace(const TriangleMesh& mesh, const Eigen::Vector2d& wish) const {
        const std::vector<Eigen::Vector2d> footprint = footprintOf(mesh);
        std::vector<std::size_t> order(clear_.cells.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::vector<double> distance(order.size());
        for (const std::size_t i : order)
            distance[i] = (centre(i) - wish).squaredNorm();
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return distance[a] != distance[b] ? distance[a] < distance[b] : a < b;
        });
        if (fits(footprint, wish)) return wish;
        for (const std::size_t i : order)
            if (clear_.cells[i] == Cell::Free && fits(footprint, centre(i))) return centre(i);
        return std::nullopt;
    }

    /// The highest floor under the mesh, on which it comes to rest.
    double restHeight(const TriangleMesh& mesh, const Eigen::Vector2d& place) const {
        double height = -1.0;
        for (const Eigen::Vector2d& offset : footprintOf(mesh)) {
            const Eigen::Vector2d at = place + offset;
            const auto hit = raycaster_.cast({at.x(), at.y(), kTallestFod_m}, -Eigen::Vector3d::UnitZ(), 0.5);
            if (hit) height = std::max(height, kTallestFod_m - hit->distance_m);
        }
        return height > -0.5 ? height : 0.0;
    }

    void occupy(const TriangleMesh& mesh, const Eigen::Vector2d& place) {
        for (const Eigen::Vector2d& offset : footprintOf(mesh)) {
            const CellIndex index = clear_.cellAt(place + offset);
            if (clear_.contains(index)) clear_.cells[clear_.offset(index)] = Cell::Occupied;
        }
    }

  private:
    Eigen::Vector2d centre(std::size_t cell) const {
        const auto width = static_cast<std::size_t>(clear_.width);
        return clear_.centreOf({static_cast<int>(cell % width), static_cast<int>(cell / width)});
    }

    /// Cells under the mesh, seen from its origin.
    static std::vector<Eigen::Vector2d> footprintOf(const TriangleMesh& mesh) {
        std::vector<Eigen::Vector2d> points;
        for (const auto& t : mesh.triangles) {
            const Eigen::Vector2d a = mesh.vertices[t[0]].head<2>(), b = mesh.vertices[t[1]].head<2>(),
                                  c = mesh.vertices[t[2]].head<2>();
            const double longest = std::max({(a - b).norm(), (b - c).norm(), (c - a).norm()});
            const int steps = static_cast<int>(std::ceil(longest / (0.5 * kResolution_m)));
            for (int i = 0; i <= steps; ++i)
                for (int j = 0; i + j <= steps; ++j) {
                    const double u = steps ? static_cast<double>(i) / steps : 0.0;
                    const double v = steps ? static_cast<double>(j) / steps : 0.0;
                    points.emplace_back(a + u * (b - a) + v * (c - a));
                }
        }
        const auto cellOf = [](const Eigen::Vector2d& p) {
            return std::pair{std::llround(p.x() / (0.5 * kResolution_m)), std::llround(p.y() / (0.5 * kResolution_m))};
        };
        std::sort(points.begin(), points.end(), [&](const auto& a, const auto& b) { return cellOf(a) < cellOf(b); });
        points.erase(std::unique(points.begin(), points.end(),
                                 [&](const auto& a, const auto& b) { return cellOf(a) == cellOf(b); }),
                     points.end());
        return points;
    }

    bool fits(const std::vector<Eigen::Vector2d>& footprint, const Eigen::Vector2d& place) const {
        return std::all_of(footprint.begin(), footprint.end(), [&](const Eigen::Vector2d& offset) {
            const CellIndex index = clear_.cellAt(place + offset);
            return clear_.contains(index) && clear_.at(index) == Cell::Free;
        });
    }

    const Raycaster& raycaster_;
    OccupancyGrid clear_;
};

}  // namespace

void placeFod(World& world, std::uint64_t seed) {
    Random random(streamSeed(seed, 3));
    std::vector<std::string> types = fodTypes();
    const std::uint64_t count = 2 + random.below(4);
    const Raycaster raycaster(world);
    FloorSpace space(world, raycaster);
    const Eigen::AlignedBox3d bounds = boundsOf(world.structure);
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::size_t pick = random.below(types.size());
        const std::string type = types[pick];
        types.erase(types.begin() + static_cast<std::ptrdiff_t>(pick));
        const Eigen::Vector2d wish(random.uniform(bounds.min().x(), bounds.max().x()),
                                   random.uniform(bounds.min().y(), bounds.max().y()));
        Transform turn = Transform::Identity();
        turn.linear() = Eigen::AngleAxisd(random.uniform(-std::numbers::pi, std::numbers::pi), Eigen::Vector3d::UnitZ())
                            .toRotationMatrix();
        WorldObject object;
        object.type = type;
        object.fod = true;
        object.mesh = transformed(fodMesh(type, random.next()), turn);
        const auto place = space.nearestPlace(object.mesh, wish);
        if (!place)
            throw Error(world.name.empty() ? "world" : world.name, "no free floor is left to put a " + type + " on",
                        "choose a world with open floor round the robot's start");
        const double floor = space.restHeight(object.mesh, *place);
        space.occupy(object.mesh, *place);
        object.mesh = translated(std::move(object.mesh), {place->x(), place->y(), floor});
        object.centroid_world = surfaceCentroid(object.mesh);
        world.objects.push_back(std::move(object));
    }
}

}  // namespace fodscope
