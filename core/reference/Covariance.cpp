// SPDX-License-Identifier: MIT
#include "core/reference/Covariance.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

namespace fodscope {

bool isInvertible(const Eigen::Matrix3d& covariance) {
    if (!covariance.allFinite()) return false;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
    const Eigen::Vector3d& values = solver.eigenvalues();
    return values[0] > 0.0 && values[0] > kLeastEigenvalueRatio * values[2];
}

double logDeterminant(const Eigen::Matrix3d& covariance) {
    if (!isInvertible(covariance)) return std::numeric_limits<double>::quiet_NaN();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
    return solver.eigenvalues().array().log().sum();
}

Eigen::Matrix3d unknownCovariance() {
    return Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace fodscope
