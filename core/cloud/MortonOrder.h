// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace fodscope {

/// @return the indices of the points along a Morton (Z-order) curve: neighbours in the list are mostly neighbours in
///         space, so that work done in this order finds its data in the cache. All coordinates must be finite.
std::vector<std::uint32_t> mortonOrder(std::span<const Eigen::Vector3d> points);

}  // namespace fodscope
