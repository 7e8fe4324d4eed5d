// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/cloud/TriangleMesh.h"
#include "core/common/Progress.h"
#include "core/reference/ReferenceMap.h"

namespace fodscope {

struct CadReferenceSettings {
    /// Mean spacing s of the samples: area / s² samples are drawn.
    double spacing_m = 0.01;
    std::uint64_t seed = 1;

    bool operator==(const CadReferenceSettings&) const = default;
};

/// Samples the surface of a CAD mesh uniformly by area. Paper: "the mesh is uniformly sampled to create a dense point
/// cloud". The same mesh and seed give the same points.
/// @return a reference map without covariances
/// @throws Error when the spacing is not positive, the mesh has no area, or more than 200 million samples were asked
/// for
ReferenceMap referenceFromCad(const TriangleMesh& mesh, const CadReferenceSettings& settings, Progress& progress);

}  // namespace fodscope
