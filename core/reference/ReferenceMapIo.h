// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/reference/ReferenceMap.h"

namespace fodscope {

/// Writes a binary PLY with the vertex properties of the file contract: x y z, and where the map has them occupancy,
/// sample_count, untrained, cov_xx cov_xy cov_xz cov_yy cov_yz cov_zz (float, m²), log_det (natural logarithm of the
/// determinant of the smoothed covariance). Provenance goes into comments.
/// @throws Error when it cannot be written
void writeReferenceMap(const std::filesystem::path& file, const ReferenceMap& reference);

/// Reads such a PLY, or any cloud as a reference without covariances.
/// @throws Error as readPointCloud; also when some but not all covariance properties are there
ReferenceMap readReferenceMap(const std::filesystem::path& file);

}  // namespace fodscope
