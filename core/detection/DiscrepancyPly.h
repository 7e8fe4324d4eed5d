// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "core/detection/Candidates.h"
#include "core/detection/Discrepancy.h"

namespace fodscope {

/// Writes the field as a PLY cloud with the vertex properties of the file contract: x y z (reference frame), weight,
/// euclidean (m), mahalanobis (where the reference has covariances), chi_square (where it was computed), discrepancy
/// (the one of the metric that is thresholded), candidate (the number in its id, −1 none).
/// @throws Error when the field has no discrepancy of the metric, or the file cannot be written
void writeDiscrepancyPly(const std::filesystem::path& file, const DiscrepancyField& field,
                         const CandidateSet& candidates, Metric metric);

/// @return 7 for "C-007"; −1 when the id has no number
int candidateNumber(const std::string& id);

}  // namespace fodscope
