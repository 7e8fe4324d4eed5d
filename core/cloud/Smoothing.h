// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/cloud/NeighbourIndex.h"
#include "core/common/Progress.h"

namespace fodscope {

/// Which points take part. Paper: "k-nearest neighbor and spherical region of interest".
enum class SmoothingNeighbourhood {
    NearestNeighbours,  ///< the k nearest
    Ball                ///< all at most a radius away
};

/// How much each counts. Paper: "mean smoothing and Gaussian smoothing".
enum class SmoothingWeights {
    Mean,     ///< all alike
    Gaussian  ///< w = exp(−r² / σ²), as printed: without a 2 in the denominator
};

/// The neighbourhood over which covariances and discrepancies are smoothed, and its weights.
struct SmoothingSettings {
    SmoothingNeighbourhood neighbourhood = SmoothingNeighbourhood::NearestNeighbours;
    /// k. Paper: 250 for covariances, 50 for discrepancies.
    int neighbours = 50;
    /// r of the ball. Paper's simulation: 4 σ.
    double radius_m = 0.2;
    SmoothingWeights weights = SmoothingWeights::Mean;
    /// σ of the Gaussian. Paper's simulation: 0.05 m.
    double sigma_m = 0.05;

    bool operator==(const SmoothingSettings&) const = default;
};

/// @return what is wrong with the settings, one sentence each; all of them are judged, also those that the chosen
///         neighbourhood and weights leave out
std::vector<std::string> smoothingProblems(const SmoothingSettings& settings);

/// @return w of a neighbour at this distance; 1 for mean smoothing
double smoothingWeight(const SmoothingSettings& settings, double squaredDistance_m2);

/// Calls `use(i, neighbours)` once for every place, in parallel and in any order, with the points of the index that are
/// its neighbourhood. The order of the neighbours is the same every time, and nearest first for the k nearest.
/// @throws Error naming `subject` for settings out of range; Cancelled
void forEachNeighbourhood(const NeighbourIndex& index, std::span<const Eigen::Vector3d> places,
                          const SmoothingSettings& settings, const std::string& subject,
                          const std::function<void(std::size_t, std::span<const Neighbour>)>& use, Progress& progress,
                          const std::string& stage = {});

}  // namespace fodscope
