// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/common/Geometry.h"
#include "core/common/Progress.h"

namespace fodscope {

struct RegionResidualSettings {
    /// Edge of the cells that the reference is divided into.
    double cellSize_m = 0.5;
    /// Voxels whose surfaces are compared.
    double surfaceVoxelSize_m = 0.05;
    /// A map surface farther than this from the reference's is not that surface.
    double maximumOffset_m = 0.15;
    /// Regions with fewer pieces of the map's surface are not measured: nobody was there, or edges and narrow parts
    /// show no plane.
    std::size_t leastPieces = 6;

    bool operator==(const RegionResidualSettings&) const = default;
};

enum class SurfaceKind { Floor, Ceiling, Wall, Slope };

/// Surfaces of one kind and direction in one cell of the reference, and how far off the map has them.
struct RegionResidual {
    SurfaceKind kind = SurfaceKind::Wall;
    /// What the region's surfaces take up, reference frame.
    Eigen::AlignedBox3d bounds_reference;
    /// Mean direction of its surfaces, towards the inside: up from a floor, down from a ceiling, from a wall towards
    /// the middle of the reference.
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    /// Pieces of the map's surface that were compared.
    std::size_t pieces = 0;
    /// Median offset of the map's surface along the normal, positive inwards; NaN where it was not measured.
    double offset_m = 0.0;
    /// Spread of the offsets: 1.4826 times their median absolute deviation; NaN where it was not measured.
    double spread_m = 0.0;

    bool isMeasured() const;
};

struct RegionResiduals {
    std::vector<RegionResidual> regions;
    /// Of each reference point the number of its region, or −1 where the reference shows no surface.
    std::vector<std::int32_t> regionOfPoint;

    /// For colouring: the offset of each reference point's region, NaN where it is unknown.
    std::vector<double> offsetOfPoints_m() const;
};

/// What is left between an aligned map and the reference, region by region: a wall that is not where the reference has
/// it shows as an offset of all its regions, drift as one that changes from region to region.
/// @throws Error when either cloud is empty or a setting is not positive; Cancelled
RegionResiduals measureRegionResiduals(std::span<const Eigen::Vector3d> map, const Transform& T_reference_from_map,
                                       std::span<const Eigen::Vector3d> reference,
                                       const RegionResidualSettings& settings, Progress& progress);

/// @return indices of the measured regions whose offsets are the largest and at least `least_m`, the worst first
std::vector<std::size_t> worstRegions(const RegionResiduals& residuals, std::size_t count, double least_m = 0.0);

/// "wall at x 3.0 to 3.5 m, y 0.0 to 0.5 m, z 0.0 to 0.5 m: off by 14 mm inwards"
std::string regionInWords(const RegionResidual& region);

}  // namespace fodscope
