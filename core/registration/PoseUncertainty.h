// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

namespace fodscope {

/// How well the map's pose is known. All is about `centre_reference`, the middle of the map: moving it by (x, y, z) and
/// turning the map round it by the small angles (roll, pitch, yaw) about the reference's axes.
struct PoseUncertainty {
    using Matrix = Eigen::Matrix<double, 6, 6>;

    Eigen::Vector3d centre_reference = Eigen::Vector3d::Zero();
    /// x, y, z in metres, then roll, pitch, yaw in radians.
    Matrix covariance = Matrix::Zero();
    /// Directions (unit, reference frame) along which the map could slide without being noticed.
    std::vector<Eigen::Vector3d> looseDirections;
    /// The map could turn unnoticed, as in a round tank.
    bool looseTurn = false;

    Eigen::Vector3d positionDeviation_m() const { return covariance.diagonal().head<3>().cwiseSqrt(); }
    Eigen::Vector3d angleDeviation_rad() const { return covariance.diagonal().tail<3>().cwiseSqrt(); }
    bool isLoose() const { return looseTurn || !looseDirections.empty(); }
};

/// One equation of the last step: the residual along the target's normal and how it answers to a small motion.
struct PlaneEquation {
    Eigen::Vector3d point_reference;
    Eigen::Vector3d normal;
    double residual_m = 0.0;
    double weight = 0.0;
};

/// The normal equations of a small motion about a centre, rotations scaled by a length to metres.
struct MotionEquations {
    using Matrix = Eigen::Matrix<double, 6, 6>;
    using Vector = Eigen::Matrix<double, 6, 1>;
    /// Of one equation: the motion of the point along its normal for a unit of each parameter.
    static Vector row(const PlaneEquation& equation, const Eigen::Vector3d& centre, double length_m);

    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double length_m = 1.0;
    Matrix information = Matrix::Zero();
    Vector gradient = Vector::Zero();
    double weight = 0.0;
    Eigen::Matrix<double, 6, 1> eigenvalues = Vector::Zero();  ///< share of the weight, ascending
    Matrix eigenvectors = Matrix::Identity();
};

/// Parts of the weight below which a direction counts as not held.
inline constexpr double kLeastHold = 0.004;

MotionEquations motionEquations(std::span<const PlaneEquation> equations);

/// The covariance of the pose from the last step's equations: the residuals' variance over the information that one
/// equation brings on the average and over the number of independent equations, s² (H/W)⁻¹ / n. Residuals are not
/// independent: drift, and surfaces that are not where the reference has them, move whole stretches together. So only
/// places farther apart than `correlationLength_m` count as independent (n cells of that edge), however many equations
/// each has. Two millimetres that all residuals share are added.
/// Source: Censi 2007 (Hessian); Bayley and Hammersley 1946 (effective number of correlated observations).
PoseUncertainty poseUncertainty(std::span<const PlaneEquation> equations, const MotionEquations& motion,
                                double correlationLength_m);

/// In words: "the position along x" or "the turn about z"; empty when everything is held.
std::string looseInWords(const PoseUncertainty& uncertainty);

}  // namespace fodscope
