// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace fodscope {

/// Below this ratio of the least to the greatest eigenvalue a covariance is singular for all that a file's float32 can
/// tell, and its inverse would be made of rounding errors.
inline constexpr double kLeastEigenvalueRatio = 1e-6;

/// @return whether the covariance is finite, positive definite and well enough conditioned to be inverted
bool isInvertible(const Eigen::Matrix3d& covariance);

/// @return natural logarithm of the determinant; NaN unless the covariance is invertible
double logDeterminant(const Eigen::Matrix3d& covariance);

/// What stands for a covariance that nothing is known about.
Eigen::Matrix3d unknownCovariance();

}  // namespace fodscope
