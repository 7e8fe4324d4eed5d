// SPDX-License-Identifier: MIT
#include "core/registration/PoseUncertainty.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>

#include "core/registration/OrderedSum.h"

namespace fodscope {
namespace {

using Vector6 = MotionEquations::Vector;
using Matrix6 = MotionEquations::Matrix;

/// The reference's surfaces are not truer than this as a whole: thickness of plates, voxels, bias of the sensor.
constexpr double kModelDeviation_m = 0.002;

using Cell = std::array<long, 3>;

/// The middle of the map is the middle of a cell, so that floors and walls do not lie on the border of two.
Cell cellOf(const Eigen::Vector3d& point, const Eigen::Vector3d& middle, double cellSize_m) {
    const Eigen::Vector3d cell = ((point - middle) / cellSize_m).array().round();
    return {static_cast<long>(cell.x()), static_cast<long>(cell.y()), static_cast<long>(cell.z())};
}

/// The independent observations among the equations: places farther apart than residuals go together.
double independentPlaces(std::span<const PlaneEquation> equations, const Eigen::Vector3d& middle,
                         double correlationLength_m) {
    std::set<Cell> cells;
    for (const PlaneEquation& equation : equations) {
        if (equation.weight > 0.0) cells.insert(cellOf(equation.point_reference, middle, correlationLength_m));
    }
    return static_cast<double>(std::max<std::size_t>(cells.size(), 1));
}

struct WeightedSum {
    Eigen::Vector3d points = Eigen::Vector3d::Zero();
    double weight = 0.0;

    WeightedSum& operator+=(const WeightedSum& other) {
        points += other.points;
        weight += other.weight;
        return *this;
    }
};

struct NormalEquations {
    Matrix6 information = Matrix6::Zero();
    Vector6 gradient = Vector6::Zero();

    NormalEquations& operator+=(const NormalEquations& other) {
        information += other.information;
        gradient += other.gradient;
        return *this;
    }
};

double meanSquare_m2(std::span<const PlaneEquation> equations, double weight) {
    double sum_m2 = 0.0;
    for (const PlaneEquation& equation : equations)
        sum_m2 += equation.weight * equation.residual_m * equation.residual_m;
    return sum_m2 / weight;
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
    const auto middle = orderedSum(equations.size(), WeightedSum{}, [&](std::size_t begin, std::size_t end) {
        WeightedSum sum;
        for (const PlaneEquation& equation : equations.subspan(begin, end - begin)) {
            sum.points += equation.weight * equation.point_reference;
            sum.weight += equation.weight;
        }
        return sum;
    });
    motion.weight = middle.weight;
    if (!(motion.weight > 0.0)) return motion;
    motion.centre = middle.points / middle.weight;
    const auto squares_m2 = orderedSum(equations.size(), 0.0, [&](std::size_t begin, std::size_t end) {
        double sum_m2 = 0.0;
        for (const PlaneEquation& equation : equations.subspan(begin, end - begin))
            sum_m2 += equation.weight * (equation.point_reference - motion.centre).squaredNorm();
        return sum_m2;
    });
    motion.length_m = std::max(std::sqrt(squares_m2 / motion.weight), 1e-6);
    const auto normal = orderedSum(equations.size(), NormalEquations{}, [&](std::size_t begin, std::size_t end) {
        NormalEquations sum;
        for (const PlaneEquation& equation : equations.subspan(begin, end - begin)) {
            const Vector6 row = MotionEquations::row(equation, motion.centre, motion.length_m);
            sum.information.noalias() += equation.weight * row * row.transpose();
            sum.gradient -= equation.weight * equation.residual_m * row;
        }
        return sum;
    });
    motion.information = normal.information;
    motion.gradient = normal.gradient;
    const Eigen::SelfAdjointEigenSolver<Matrix6> solver(motion.information / motion.weight);
    motion.eigenvalues = solver.eigenvalues();
    motion.eigenvectors = solver.eigenvectors();
    return motion;
}

PoseUncertainty poseUncertainty(std::span<const PlaneEquation> equations, const MotionEquations& motion,
                                double correlationLength_m) {
    PoseUncertainty uncertainty;
    uncertainty.centre_reference = motion.centre;
    Vector6 inverse;
    for (Eigen::Index i = 0; i < 6; ++i) {
        inverse[i] = 1.0 / std::max(motion.eigenvalues[i], kLeastHold / 4.0);
        if (motion.eigenvalues[i] >= kLeastHold) continue;
        const Vector6 direction = motion.eigenvectors.col(i);
        if (direction.head<3>().norm() >= direction.tail<3>().norm()) {
            uncertainty.looseDirections.emplace_back(direction.head<3>().normalized());
        } else {
            uncertainty.looseTurn = true;
        }
    }
    const double variance_m2 =
        meanSquare_m2(equations, motion.weight) / independentPlaces(equations, motion.centre, correlationLength_m);
    Vector6 units;
    units << 1.0, 1.0, 1.0, Eigen::Vector3d::Constant(1.0 / motion.length_m);
    uncertainty.covariance =
        units.asDiagonal() *
        (variance_m2 * motion.eigenvectors * inverse.asDiagonal() * motion.eigenvectors.transpose()) *
        units.asDiagonal();
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
