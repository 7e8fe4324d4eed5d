// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/reference/ReferenceMap.h"
#include "core/registration/RegionResiduals.h"
#include "ui/view3d/View3D.h"

namespace fodscope {

/// A value at each point of the reference and how it is shown.
struct ReferenceColours {
    std::vector<double> values;
    ScalarStyle style;
};

/// The log determinant of the covariances between its 10th and 90th percentile; points without training are striped.
ReferenceColours covarianceColours(const ReferenceMap& reference);

/// How far off the map has each region: red inwards, blue outwards; what was not observed is striped.
ReferenceColours residualColours(const RegionResiduals& residuals);

}  // namespace fodscope
