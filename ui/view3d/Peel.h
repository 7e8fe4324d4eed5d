// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

namespace fodscope {

/// A tank with a deck over it shows nothing of its inside.
/// @return the height above which to hide a cloud so that one can look into it; empty for a cloud that is open from
/// above
std::optional<double> openingHeight(std::span<const Eigen::Vector3d> points);

}  // namespace fodscope
