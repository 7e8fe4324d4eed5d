// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/cloud/VoxelGrid.h"
#include "core/common/Error.h"
#include "core/detection/Candidates.h"

namespace fodscope {

double floorHeight(const ReferenceMap& reference) {
    constexpr double step_m = 0.01;
    // A floor is the largest horizontal surface or nearly so; a few stray points under it are none.
    constexpr double shareOfLargestLayer = 0.25;
    constexpr double mostSteps = 1e6;
    if (reference.size() == 0) throw Error("reference map", "it has no points", "build it anew");
    const double low = minimumCorner(reference.points).z();
    const double high = maximumCorner(reference.points).z();
    if (!((high - low) / step_m < mostSteps)) {
        throw Error("reference map", "it is more than 10 km high", "give it in metres");
    }
    const auto layerOf = [&](double z) { return static_cast<std::size_t>((z - low) / step_m); };
    std::vector<std::size_t> counts(layerOf(high) + 1);
    for (const Eigen::Vector3d& point : reference.points)
        ++counts[layerOf(point.z())];

    // Three layers together, so that a floor on the border of two layers counts in full.
    std::vector<std::size_t> support(counts.size());
    for (std::size_t i = 0; i < counts.size(); ++i)
        support[i] = counts[i] + (i > 0 ? counts[i - 1] : 0) + (i + 1 < counts.size() ? counts[i + 1] : 0);
    const double least = shareOfLargestLayer * static_cast<double>(*std::max_element(support.begin(), support.end()));
    std::size_t layer = 0;
    while (static_cast<double>(support[layer]) < least)
        ++layer;
    // From its lower edge up to where the layer is densest.
    while (layer + 1 < support.size() && support[layer + 1] > support[layer])
        ++layer;

    double sum = 0.0;
    for (const Eigen::Vector3d& point : reference.points) {
        const std::size_t own = layerOf(point.z());
        if (own + 1 >= layer && own <= layer + 1) sum += point.z();
    }
    return sum / static_cast<double>(support[layer]);
}

}  // namespace fodscope
