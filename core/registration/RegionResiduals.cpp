// SPDX-License-Identifier: MIT
#include "core/registration/RegionResiduals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>

#include "core/common/Error.h"
#include "core/registration/SurfacePatches.h"

namespace fodscope {
namespace {

constexpr const char* kStage = "measuring the residuals";
/// Voxels on an edge of two surfaces show a slope that neither has.
constexpr double kLeastPlanarity = 0.75;
constexpr double kLeastAlignment = 0.7;
/// Normals of level surfaces rise by more than this, 64°; those of upright ones by less than kMostRise, 30°.
constexpr double kLeastLevel = 0.9;
constexpr double kMostRise = 0.5;
constexpr double kReach_voxels = 2.5;

/// Cell, kind, and of walls and slopes the axis and sense of the normal.
using Key = std::array<long, 5>;

double medianOf(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    if (values.size() % 2 == 1) return *middle;
    return (*middle + *std::ranges::max_element(values.begin(), middle)) / 2.0;
}

/// The normal towards the inside.
Eigen::Vector3d inwards(const SurfacePatch& patch, const Eigen::Vector3d& middle) {
    const Eigen::Vector3d& normal = patch.normal;
    const Eigen::Vector3d way = middle - patch.centre;
    const double side = std::abs(normal.z()) > kLeastLevel ? normal.z() * way.z() : normal.dot(way);
    return side < 0.0 ? Eigen::Vector3d(-normal) : normal;
}

SurfaceKind kindOf(const Eigen::Vector3d& normal) {
    if (normal.z() > kLeastLevel) return SurfaceKind::Floor;
    if (normal.z() < -kLeastLevel) return SurfaceKind::Ceiling;
    return std::abs(normal.z()) < kMostRise ? SurfaceKind::Wall : SurfaceKind::Slope;
}

Key keyOf(const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double cellSize_m) {
    Eigen::Index axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    Eigen::Vector3d cell = centre / cellSize_m;
    // Along the normal the cells are centred on the lattice: surfaces often lie right on it, and noise would divide
    // them between two cells.
    cell[axis] += 0.5;
    const Eigen::Vector3d corner = cell.array().floor();
    const SurfaceKind kind = kindOf(normal);
    const bool isLevel = kind == SurfaceKind::Floor || kind == SurfaceKind::Ceiling;
    const long sense = isLevel ? 0 : 1 + 2 * static_cast<long>(axis) + (normal[axis] < 0.0 ? 1 : 0);
    return {static_cast<long>(kind), static_cast<long>(corner.x()), static_cast<long>(corner.y()),
            static_cast<long>(corner.z()), sense};
}

/// The regions that the surfaces of a reference make.
class Regions {
  public:
    Regions(const SurfacePatches& reference, double cellSize_m) {
        Eigen::AlignedBox3d bounds;
        for (const SurfacePatch& patch : reference.all())
            bounds.extend(patch.centre);
        for (const SurfacePatch& patch : reference.all()) {
            if (patch.planarity < kLeastPlanarity) {
                ofPatch_.push_back(-1);
                normals_.push_back(patch.normal);
                continue;
            }
            const Eigen::Vector3d normal = inwards(patch, bounds.center());
            const auto [place, isNew] =
                numbers_.try_emplace(keyOf(patch.centre, normal, cellSize_m), static_cast<std::int32_t>(all_.size()));
            if (isNew) {
                all_.emplace_back();
                all_.back().kind = kindOf(normal);
                all_.back().normal = Eigen::Vector3d::Zero();
            }
            RegionResidual& region = all_[static_cast<std::size_t>(place->second)];
            region.bounds_reference.extend(patch.centre);
            region.normal += normal;
            ofPatch_.push_back(place->second);
            normals_.push_back(normal);
        }
        for (RegionResidual& region : all_) {
            if (region.normal.norm() > 0.0) region.normal.normalize();
        }
    }

    std::vector<RegionResidual>& all() { return all_; }
    std::int32_t ofPatch(std::size_t patch) const { return ofPatch_[patch]; }
    const Eigen::Vector3d& normalOf(std::size_t patch) const { return normals_[patch]; }

  private:
    std::map<Key, std::int32_t> numbers_;
    std::vector<RegionResidual> all_;
    std::vector<std::int32_t> ofPatch_;
    std::vector<Eigen::Vector3d> normals_;
};

void settle(RegionResidual& region, std::vector<double>& offsets_m, const RegionResidualSettings& settings) {
    region.pieces = offsets_m.size();
    region.offset_m = region.spread_m = std::numeric_limits<double>::quiet_NaN();
    if (offsets_m.empty() || offsets_m.size() < settings.leastPieces) return;
    region.offset_m = medianOf(offsets_m);
    for (double& offset_m : offsets_m)
        offset_m = std::abs(offset_m - region.offset_m);
    region.spread_m = 1.4826 * medianOf(offsets_m);
}

void requireUsable(std::span<const Eigen::Vector3d> map, std::span<const Eigen::Vector3d> reference,
                   const RegionResidualSettings& settings) {
    if (map.empty()) throw Error("map", "has no points to compare", "give a map with points");
    if (reference.empty()) throw Error("reference", "has no points to compare with", "give a reference with points");
    if (!(settings.cellSize_m > 0.0) || !(settings.surfaceVoxelSize_m > 0.0) || !(settings.maximumOffset_m > 0.0)) {
        throw Error("residuals", "a size is not positive", "give cells, voxels and offset in metres above zero");
    }
}

}  // namespace

bool RegionResidual::isMeasured() const {
    return !std::isnan(offset_m);
}

std::vector<double> RegionResiduals::offsetOfPoints_m() const {
    std::vector<double> offsets_m;
    offsets_m.reserve(regionOfPoint.size());
    for (const std::int32_t region : regionOfPoint) {
        offsets_m.push_back(region < 0 ? std::numeric_limits<double>::quiet_NaN()
                                       : regions[static_cast<std::size_t>(region)].offset_m);
    }
    return offsets_m;
}

RegionResiduals measureRegionResiduals(std::span<const Eigen::Vector3d> map, const Transform& T_reference_from_map,
                                       std::span<const Eigen::Vector3d> reference,
                                       const RegionResidualSettings& settings, Progress& progress) {
    requireUsable(map, reference, settings);
    progress.report(kStage, 0.0);
    const SurfacePatches mapPatches(map, settings.surfaceVoxelSize_m, progress);
    const SurfacePatches referencePatches(reference, settings.surfaceVoxelSize_m, progress);
    Regions regions(referencePatches, settings.cellSize_m);

    std::vector<Eigen::Vector3d> moved;
    moved.reserve(mapPatches.size());
    for (const SurfacePatch& patch : mapPatches.all())
        moved.push_back(T_reference_from_map * patch.centre);
    const std::vector<Neighbour> nearest = referencePatches.places().index().nearestOfEach(moved, progress, kStage);
    const double reach_m = std::max(settings.maximumOffset_m, kReach_voxels * settings.surfaceVoxelSize_m);
    std::vector<std::vector<double>> offsets_m(regions.all().size());
    for (std::size_t i = 0; i < moved.size(); ++i) {
        const std::size_t patch = nearest[i].index;
        const std::int32_t region = regions.ofPatch(patch);
        if (region < 0 || nearest[i].squaredDistance_m2 > reach_m * reach_m) continue;
        if (mapPatches.all()[i].planarity < kLeastPlanarity) continue;
        const Eigen::Vector3d& normal = regions.normalOf(patch);
        const Eigen::Vector3d mapNormal = T_reference_from_map.linear() * mapPatches.all()[i].normal;
        const double offset_m = normal.dot(moved[i] - referencePatches.all()[patch].centre);
        if (std::abs(normal.dot(mapNormal)) < kLeastAlignment || std::abs(offset_m) > settings.maximumOffset_m)
            continue;
        offsets_m[static_cast<std::size_t>(region)].push_back(offset_m);
    }

    RegionResiduals residuals;
    residuals.regions = std::move(regions.all());
    for (std::size_t i = 0; i < offsets_m.size(); ++i)
        settle(residuals.regions[i], offsets_m[i], settings);
    residuals.regionOfPoint.reserve(reference.size());
    for (const Neighbour& patch : referencePatches.places().index().nearestOfEach(reference, progress, kStage))
        residuals.regionOfPoint.push_back(regions.ofPatch(patch.index));
    return residuals;
}

std::vector<std::size_t> worstRegions(const RegionResiduals& residuals, std::size_t count, double least_m) {
    std::vector<std::size_t> worst;
    for (std::size_t i = 0; i < residuals.regions.size(); ++i) {
        const RegionResidual& region = residuals.regions[i];
        if (region.isMeasured() && std::abs(region.offset_m) >= least_m) worst.push_back(i);
    }
    std::ranges::stable_sort(worst, [&](std::size_t a, std::size_t b) {
        return std::abs(residuals.regions[a].offset_m) > std::abs(residuals.regions[b].offset_m);
    });
    if (worst.size() > count) worst.resize(count);
    return worst;
}

std::string regionInWords(const RegionResidual& region) {
    static constexpr std::array kNames{"floor", "ceiling", "wall", "slope"};
    std::string words = std::string(kNames[static_cast<std::size_t>(region.kind)]) + " at ";
    char text[80];
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const double low_m = region.bounds_reference.min()[axis];
        const double high_m = region.bounds_reference.max()[axis];
        if (axis > 0) words += ", ";
        // Minus zero is zero.
        std::snprintf(text, sizeof text, "%c %.1f", "xyz"[axis], std::round(low_m * 10.0) / 10.0 + 0.0);
        words += text;
        if (std::round(high_m * 10.0) > std::round(low_m * 10.0)) {
            std::snprintf(text, sizeof text, " to %.1f", std::round(high_m * 10.0) / 10.0 + 0.0);
            words += text;
        }
        words += " m";
    }
    if (!region.isMeasured()) return words + ": too little surface to measure";
    const bool inward = region.offset_m >= 0.0;
    const char* side = region.kind == SurfaceKind::Floor     ? (inward ? "upwards" : "downwards")
                       : region.kind == SurfaceKind::Ceiling ? (inward ? "downwards" : "upwards")
                                                             : (inward ? "inwards" : "outwards");
    std::snprintf(text, sizeof text, ": off by %.0f mm %s", std::abs(region.offset_m) * 1000.0, side);
    return words + text;
}

}  // namespace fodscope
