// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/detection/Candidates.h"

namespace fodscope {

/// Discrepancies as a map of a tank has them, on given points: noise nearly everywhere, a heavy tail of single voxels,
/// and patches from hand-sized to a metre wide, as foreign objects and drift leave them.
std::shared_ptr<const DiscrepancyField> drawnField(std::span<const Eigen::Vector3d> points, std::uint64_t seed);

/// As an operator drags two sliders to and fro with an unsteady hand: of three moves two go to the threshold and one to
/// the cutoff. A hundred moves take the threshold once through its range, from `fewest` to `most` voxels above it,
/// evenly in the logarithm of their number; the cutoff goes from 5 to 60 cm and back.
std::vector<CandidateSettings> dragPath(const DiscrepancyField& field, std::size_t moves, std::size_t fewest,
                                        std::size_t most, std::uint64_t seed);

/// @param share 0.5 for the median
double quantileOf(std::vector<double> values, double share);

}  // namespace fodscope
