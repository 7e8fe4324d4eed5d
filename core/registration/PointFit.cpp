// SPDX-License-Identifier: MIT
#include "core/registration/PointFit.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <cmath>

#include "core/registration/OrderedSum.h"

namespace fodscope {
namespace {

constexpr double kLeastPairs = 10.0;

/// Sums over pairs, about a place near the points so that nothing cancels.
struct PairSums {
    double count = 0.0;
    double squares_m2 = 0.0;
    Eigen::Vector3d source = Eigen::Vector3d::Zero();
    Eigen::Vector3d target = Eigen::Vector3d::Zero();
    Eigen::Matrix3d targetBySource = Eigen::Matrix3d::Zero();

    PairSums& operator+=(const PairSums& other) {
        count += other.count;
        squares_m2 += other.squares_m2;
        source += other.source;
        target += other.target;
        targetBySource += other.targetBySource;
        return *this;
    }
};

PairSums sumsOf(const PointPairs& pairs, const Eigen::Vector3d& about, double maximumDistance_m) {
    const double limit_m2 = maximumDistance_m * maximumDistance_m;
    return orderedSum(pairs.moved().size(), PairSums{}, [&](std::size_t begin, std::size_t end) {
        PairSums sums;
        for (std::size_t i = begin; i < end; ++i) {
            const Neighbour& nearest = pairs.nearest()[i];
            if (nearest.squaredDistance_m2 > limit_m2) continue;
            const Eigen::Vector3d source = pairs.moved()[i] - about;
            const Eigen::Vector3d target = pairs.target()[nearest.index] - about;
            sums.count += 1.0;
            sums.squares_m2 += nearest.squaredDistance_m2;
            sums.source += source;
            sums.target += target;
            sums.targetBySource.noalias() += target * source.transpose();
        }
        return sums;
    });
}

/// The least-squares rigid motion from the sources to the targets. Source: Umeyama 1991, without scale.
Transform motionOf(const PairSums& sums, const Eigen::Vector3d& about) {
    const Eigen::Vector3d source = sums.source / sums.count;
    const Eigen::Vector3d target = sums.target / sums.count;
    const Eigen::Matrix3d covariance = sums.targetBySource / sums.count - target * source.transpose();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector3d signs = Eigen::Vector3d::Ones();
    if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0.0) signs.z() = -1.0;
    Transform motion = Transform::Identity();
    motion.linear() = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
    motion.translation() = about + target - motion.linear() * (about + source);
    return motion;
}

/// Composing many steps wears the rotation out; this makes it one again.
void makeRigid(Transform& transform) {
    transform.linear() = Eigen::Quaterniond(transform.linear()).normalized().toRotationMatrix();
}

}  // namespace

void PointPairs::moveTo(const Transform& T_target_from_source, Progress& progress) {
    forEachPart(source_.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t i = begin; i < end; ++i)
            moved_[i] = T_target_from_source * source_[i];
    });
    target_.update(moved_, pairs_, progress);
}

PointPairs::Closeness PointPairs::within(double maximumDistance_m) const {
    std::size_t count = 0;
    double sum_m2 = 0.0;
    for (const Neighbour& neighbour : pairs_) {
        if (neighbour.squaredDistance_m2 > maximumDistance_m * maximumDistance_m) continue;
        ++count;
        sum_m2 += neighbour.squaredDistance_m2;
    }
    if (count == 0) return {};
    return {static_cast<double>(count) / static_cast<double>(pairs_.size()),
            std::sqrt(sum_m2 / static_cast<double>(count))};
}

PointFit fitToPoints(PointPairs& pairs, const Transform& start, const PointFitSettings& settings,
                     const std::string& stage, Progress& progress) {
    PointFit fit{start, false};
    double earlierShare = -1.0;
    double earlierRms_m = 0.0;
    for (int iteration = 0; iteration < settings.maximumIterations; ++iteration) {
        progress.report(stage, static_cast<double>(iteration) / settings.maximumIterations);
        pairs.moveTo(fit.T_target_from_source, progress);
        const Eigen::Vector3d about = pairs.target()[pairs.nearest().front().index];
        const PairSums sums = sumsOf(pairs, about, settings.maximumCorrespondence_m);
        if (sums.count < kLeastPairs) return fit;
        const double share = sums.count / static_cast<double>(pairs.source().size());
        const double rms_m = std::sqrt(sums.squares_m2 / sums.count);
        fit.converged =
            std::abs(share - earlierShare) < settings.tolerance && std::abs(rms_m - earlierRms_m) < settings.tolerance;
        if (fit.converged) return fit;
        earlierShare = share;
        earlierRms_m = rms_m;
        fit.T_target_from_source = motionOf(sums, about) * fit.T_target_from_source;
        makeRigid(fit.T_target_from_source);
    }
    return fit;
}

}  // namespace fodscope
