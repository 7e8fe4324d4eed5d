// SPDX-License-Identifier: MIT
#include "core/registration/PoseUncertainty.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

namespace fodscope {
namespace {

using Vector6 = MotionEquations::Vector;
using Matrix6 = MotionEquations::Matrix;

/// The reference's surfaces are not truer than this as a whole: thickness of plates, voxels, bias of the sensor.
constexpr double kModelDeviation_m = 0.001;

using Cell = std::array<long, 3>;

/// The equations of one cell, as one.
struct Group {
    Vector6 gradient = Vector6::Zero();
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    double weight = 0.0;
};

Cell cellOf(const Eigen::Vector3d& point, double cellSize_m) {
    const Eigen::Vector3d cell = (point / cellSize_m).array().floor();
    return {static_cast<long>(cell.x()), static_cast<long>(cell.y()), static_cast<long>(cell.z())};
}

std::vector<Group> groupsOf(std::span<const PlaneEquation> equations, const MotionEquations& motion,
                            double cellSize_m) {
    std::map<Cell, Group> byCell;
    for (const PlaneEquation& equation : equations) {
        if (!(equation.weight > 0.0)) continue;
        Group& group = byCell[cellOf(equation.point_reference, cellSize_m)];
        const Vector6 row = MotionEquations::row(equation, motion.centre, motion.length_m);
        group.gradient += equation.weight * equation.residual_m * row;
        group.place += equation.weight * equation.point_reference;
        group.weight += equation.weight;
    }
    std::vector<Group> groups;
    for (auto& [cell, group] : byCell) {
        group.place /= group.weight;
        groups.push_back(group);
    }
    return groups;
}

/// Σ Σ K(distance) g gᵀ over all pairs of groups.
Matrix6 spreadOf(const std::vector<Group>& groups, double correlationLength_m) {
    Matrix6 spread = Matrix6::Zero();
    const double scale = 0.5 / (correlationLength_m * correlationLength_m);
    for (const Group& a : groups) {
        Vector6 together = Vector6::Zero();
        for (const Group& b : groups)
            together += std::exp(-scale * (a.place - b.place).squaredNorm()) * b.gradient;
        spread.noalias() += a.gradient * together.transpose();
    }
    return (spread + spread.transpose()) / 2.0;
}

}  // namespace

Vector6 MotionEquations::row(const PlaneEquation& equation, const Eigen::Vector3d& centre, double length_m) {
    Vector6 row;
    row.head<3>() = equation.normal;
    row.tail<3>() = (equation.point_reference - centre).cross(equation.normal) / length_m;
    return row;
}

MotionEquations motionEquations(std::span<const PlaneEquation> equations) {
    MotionEquations motion;
    for (const PlaneEquation& equation : equations) {
        motion.centre += equation.weight * equation.point_reference;
        motion.weight += equation.weight;
    }
    if (!(motion.weight > 0.0)) return motion;
    motion.centre /= motion.weight;
    double squares_m2 = 0.0;
    for (const PlaneEquation& equation : equations)
        squares_m2 += equation.weight * (equation.point_reference - motion.centre).squaredNorm();
    motion.length_m = std::max(std::sqrt(squares_m2 / motion.weight), 1e-6);
    for (const PlaneEquation& equation : equations) {
        const Vector6 row = MotionEquations::row(equation, motion.centre, motion.length_m);
        motion.information.noalias() += equation.weight * row * row.transpose();
        motion.gradient -= equation.weight * equation.residual_m * row;
    }
    const Eigen::SelfAdjointEigenSolver<Matrix6> solver(motion.information / motion.weight);
    motion.eigenvalues = solver.eigenvalues();
    motion.eigenvectors = solver.eigenvectors();
    return motion;
}

PoseUncertainty poseUncertainty(std::span<const PlaneEquation> equations, const MotionEquations& motion,
                                double correlationLength_m) {
    const std::vector<Group> groups = groupsOf(equations, motion, correlationLength_m / 2.0);
    Matrix6 spread = spreadOf(groups, correlationLength_m);
    const auto count = static_cast<double>(groups.size());
    // With no more groups than unknowns nothing is left to tell the spread by; the sum itself is then the least it is.
    if (count > 6.0) spread *= count / (count - 6.0);

    PoseUncertainty uncertainty;
    uncertainty.centre_reference = motion.centre;
    Vector6 inverse;
    for (Eigen::Index i = 0; i < 6; ++i) {
        inverse[i] = 1.0 / (motion.weight * std::max(motion.eigenvalues[i], kLeastHold / 4.0));
        if (motion.eigenvalues[i] >= kLeastHold) continue;
        const Vector6 direction = motion.eigenvectors.col(i);
        if (direction.head<3>().norm() >= direction.tail<3>().norm()) {
            uncertainty.looseDirections.emplace_back(direction.head<3>().normalized());
        } else {
            uncertainty.looseTurn = true;
        }
    }
    const Matrix6 inverseInformation = motion.eigenvectors * inverse.asDiagonal() * motion.eigenvectors.transpose();
    Vector6 units;
    units << 1.0, 1.0, 1.0, 1.0 / motion.length_m, 1.0 / motion.length_m, 1.0 / motion.length_m;
    uncertainty.covariance =
        units.asDiagonal() * (inverseInformation * spread * inverseInformation) * units.asDiagonal();
    // What all residuals share is in none of them.
    Vector6 model;
    model.head<3>().setConstant(kModelDeviation_m);
    model.tail<3>().setConstant(kModelDeviation_m / motion.length_m);
    uncertainty.covariance.diagonal() += model.cwiseAbs2();
    uncertainty.covariance = (uncertainty.covariance + uncertainty.covariance.transpose()).eval() / 2.0;
    return uncertainty;
}

std::string looseInWords(const PoseUncertainty& uncertainty) {
    std::string words;
    for (const Eigen::Vector3d& direction : uncertainty.looseDirections) {
        if (!words.empty()) words += " and ";
        Eigen::Index axis = 0;
        if (direction.cwiseAbs().maxCoeff(&axis) > 0.95) {
            words += std::string("the position along ") + "xyz"[axis];
        } else {
            char text[64];
            const double sign = direction[axis] < 0.0 ? -1.0 : 1.0;
            std::snprintf(text, sizeof text, "the position along (%.2f, %.2f, %.2f)", sign * direction.x(),
                          sign * direction.y(), sign * direction.z());
            words += text;
        }
    }
    if (uncertainty.looseTurn) words += words.empty() ? "its turn" : " and its turn";
    return words;
}

}  // namespace fodscope
