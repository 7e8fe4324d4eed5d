// SPDX-License-Identifier: MIT
#include "core/registration/Icp.h"

#include <Eigen/SVD>
#include <cmath>
#include <vector>

namespace fodscope {
namespace {

struct Pairs {
    std::vector<Eigen::Vector3d> source;
    std::vector<Eigen::Vector3d> target;
    double share = 0.0;
    double rms_m = 0.0;
};

Pairs pairsOf(std::span<const Eigen::Vector3d> moved, const IcpTarget& target, double maximumDistance_m,
              Progress& progress) {
    const std::vector<Neighbour> nearest = target.index.nearestOfEach(moved, progress);
    const double limit_m2 = maximumDistance_m * maximumDistance_m;
    Pairs pairs;
    double sum_m2 = 0.0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        if (nearest[i].squaredDistance_m2 > limit_m2) continue;
        pairs.source.push_back(moved[i]);
        pairs.target.push_back(target.points[nearest[i].index]);
        sum_m2 += nearest[i].squaredDistance_m2;
    }
    if (!pairs.source.empty()) {
        pairs.share = static_cast<double>(pairs.source.size()) / static_cast<double>(moved.size());
        pairs.rms_m = std::sqrt(sum_m2 / static_cast<double>(pairs.source.size()));
    }
    return pairs;
}

/// Composing many steps wears the rotation out; this makes it one again.
void makeRigid(Transform& transform) {
    transform.linear() = Eigen::Quaterniond(transform.linear()).normalized().toRotationMatrix();
}

}  // namespace

Transform rigidMotion(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to) {
    Eigen::Vector3d fromMean = Eigen::Vector3d::Zero();
    Eigen::Vector3d toMean = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < from.size(); ++i) {
        fromMean += from[i];
        toMean += to[i];
    }
    fromMean /= static_cast<double>(from.size());
    toMean /= static_cast<double>(to.size());

    Eigen::Matrix3d cross = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < from.size(); ++i)
        cross += (to[i] - toMean) * (from[i] - fromMean).transpose();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(cross, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector3d signs = Eigen::Vector3d::Ones();
    if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0) signs.z() = -1.0;

    Transform motion = Transform::Identity();
    motion.linear() = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
    motion.translation() = toMean - motion.linear() * fromMean;
    return motion;
}

IcpResult icp(std::span<const Eigen::Vector3d> source, const IcpTarget& target, const Transform& start,
              const IcpSettings& settings, const std::string& stage, Progress& progress) {
    constexpr std::size_t kLeastPairs = 10;
    IcpResult result{start, false, 0};
    std::vector<Eigen::Vector3d> moved(source.size());
    double earlierShare = -1.0;
    double earlierRms_m = 0.0;
    while (result.iterations < settings.maximumIterations) {
        progress.report(stage, static_cast<double>(result.iterations) / settings.maximumIterations);
        for (std::size_t i = 0; i < source.size(); ++i)
            moved[i] = result.T_target_from_source * source[i];
        Progress inner([&](const std::string&, double) { progress.throwIfCancelled(); });
        const Pairs pairs = pairsOf(moved, target, settings.maximumCorrespondence_m, inner);
        if (pairs.source.size() < kLeastPairs) return result;
        if (std::abs(pairs.share - earlierShare) < settings.tolerance &&
            std::abs(pairs.rms_m - earlierRms_m) < settings.tolerance) {
            result.converged = true;
            return result;
        }
        earlierShare = pairs.share;
        earlierRms_m = pairs.rms_m;
        result.T_target_from_source = rigidMotion(pairs.source, pairs.target) * result.T_target_from_source;
        makeRigid(result.T_target_from_source);
        ++result.iterations;
    }
    return result;
}

}  // namespace fodscope
