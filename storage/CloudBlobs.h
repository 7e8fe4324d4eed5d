// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/coverage/Coverage.h"
#include "core/detection/Candidates.h"
#include "core/detection/Discrepancy.h"
#include "core/planning/OccupancyGrid.h"
#include "core/reference/ReferenceMap.h"

namespace fodscope {

/// Bytes with the name of their layout, as the table `blobs` holds them.
struct Blob {
    std::string format;
    std::vector<std::byte> bytes;
};

// Layouts. All numbers are little-endian, without padding; f64 is IEEE 754. Every blob starts with the eight
// characters of its magic and u64 n. Arrays follow one another, n entries each; an array marked [bit b] is there only
// when bit b of the u32 `present`, which then follows n, is set.
//
//   fodscope.reference/1  "FODSREF1" n present
//                         points x y z f64, metres, reference frame; [0] occupancy i32; [1] sample count i32;
//                         [2] covariance xx xy xz yy yz zz f64, m²; [3] untrained u8
//   fodscope.field/1      "FODSFLD1" n present
//                         voxel means x y z f64, metres, reference frame; [0] weight u32; [1] nearest reference point
//                         u32; [2] euclidean f64, m; [3] mahalanobis f64; [4] smoothed euclidean f64, m;
//                         [5] smoothed mahalanobis f64; [6] chi-square f64 (NaN: unknown)
//   fodscope.voxels/1     "FODSVOX1" n; for each candidate u64 m and m voxel indices u32
//   fodscope.coverage/1   "FODSCOV1" n; observed u8 for each reference point
//   fodscope.grid/1       "FODSGRD1" n; cells u8, row-major from the origin: 0 free, 1 occupied, 2 unknown

/// The scatter matrices are left out: they serve to make a reference map, not to use it.
Blob encodeReference(const ReferenceMap& reference);
Blob encodeField(const DiscrepancyField& field);
Blob encodeVoxels(const CandidateSet& candidates);
Blob encodeCoverage(const Coverage& coverage);
Blob encodeGrid(const OccupancyGrid& grid);

// Each throws Error, with `subject` as the file at fault, when the bytes are not what the layout says.
ReferenceMap decodeReference(std::span<const std::byte> bytes, const std::string& subject);
DiscrepancyField decodeField(std::span<const std::byte> bytes, const std::string& subject);
std::vector<std::vector<std::uint32_t>> decodeVoxels(std::span<const std::byte> bytes, const std::string& subject);
std::vector<std::uint8_t> decodeCoverage(std::span<const std::byte> bytes, const std::string& subject);
std::vector<Cell> decodeGrid(std::span<const std::byte> bytes, const std::string& subject);

}  // namespace fodscope
