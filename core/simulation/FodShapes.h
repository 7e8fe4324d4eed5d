// SPDX-License-Identifier: MIT
#pragma once

#include "core/cloud/TriangleMesh.h"
#include "core/simulation/Random.h"

namespace fodscope {

/// Tools at true size, lying on z = 0 in some place near the origin; colours vary with the generator as makes do.
TriangleMesh hammerMesh(Random& random);
TriangleMesh screwdriverMesh(Random& random);
TriangleMesh wrenchMesh(Random& random);
TriangleMesh crimperMesh(Random& random);
TriangleMesh levelMesh(Random& random);
TriangleMesh drillMesh(Random& random);
TriangleMesh sanderMesh(Random& random);
TriangleMesh tapeMeasureMesh(Random& random);

}  // namespace fodscope
