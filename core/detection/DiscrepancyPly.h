// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/detection/Candidates.h"
#include "core/detection/Discrepancy.h"

namespace fodscope {

/// Writes the field as a PLY cloud with the vertex properties of the file contract: x y z (reference frame), weight,
/// euclidean (m), mahalanobis (where the reference has covariances), discrepancy (the smoothed one of the metric, which
/// is thresholded), candidate (the number in its id, −1 none).
/// @throws Error when Mahalanobis is asked for without covariances, or the file cannot be written
void writeDiscrepancyPly(const std::filesystem::path& file, const DiscrepancyField& field,
                         const CandidateSet& candidates, Metric metric);

}  // namespace fodscope
