// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace fodscope {

/// What a FOD in a trial without candidates is charged in the cost, in place of a distance.
inline constexpr double kNoCandidateDistance_m = 7.5;
/// A candidate farther than this from every FOD is false.
inline constexpr double kFalseCandidateDistance_m = 0.3;
/// The paper's weight of an unassociated candidate, λ.
inline constexpr double kUnassociatedWeight_m = 0.05;

struct AssociatedFod {
    /// To its nearest candidate, 3-D; empty without candidates.
    std::optional<double> distance_m;
    /// Index of that candidate; a tie goes to the lower index.
    std::optional<std::size_t> nearest;
};

/// Which candidates belong to the FOD of a trial, and what the trial costs.
struct Association {
    std::vector<AssociatedFod> fods;
    /// Per candidate: 1 when it is the nearest one of at least one FOD, however far it lies.
    std::vector<std::uint8_t> isAssociated;
    std::size_t unassociatedCandidates = 0;
    /// Farther than 0.3 m from every FOD: the honest count, since the nearest candidate of a missed FOD is associated.
    std::size_t falseCandidates = 0;
    /// Mean distance over the FOD + lambda · unassociated candidates (paper: "Parameter Search"); without candidates
    /// 7.5 m. Without FOD there is no distance, and the second term remains.
    double cost = 0.0;
};

/// Associates candidates with FOD by nearest centroid. All centroids are in one frame.
/// @param lambda cost of an unassociated candidate, metres
/// @throws Error for a centroid that is not finite, or a lambda that is not finite or negative
Association associate(std::span<const Eigen::Vector3d> fods, std::span<const Eigen::Vector3d> candidates,
                      double lambda);

}  // namespace fodscope
