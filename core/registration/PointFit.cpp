// SPDX-License-Identifier: MIT
#include "core/registration/PointFit.h"

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

namespace fodscope {
namespace {

constexpr std::size_t kLeastPairs = 10;

struct Pairs {
    Eigen::Matrix3Xd source;
    Eigen::Matrix3Xd target;
    double share = 0.0;
    double rms_m = 0.0;
};

Pairs pairsOf(std::span<const Eigen::Vector3d> moved, std::span<const Eigen::Vector3d> target,
              const NeighbourIndex& index, double maximumDistance_m, Progress& progress) {
    const std::vector<Neighbour> nearest = index.nearestOfEach(moved, progress);
    Pairs pairs;
    const auto room = static_cast<Eigen::Index>(moved.size());
    pairs.source.resize(3, room);
    pairs.target.resize(3, room);
    Eigen::Index count = 0;
    double sum_m2 = 0.0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        if (nearest[i].squaredDistance_m2 > maximumDistance_m * maximumDistance_m) continue;
        pairs.source.col(count) = moved[i];
        pairs.target.col(count) = target[nearest[i].index];
        sum_m2 += nearest[i].squaredDistance_m2;
        ++count;
    }
    pairs.source.conservativeResize(Eigen::NoChange, count);
    pairs.target.conservativeResize(Eigen::NoChange, count);
    if (count > 0) {
        pairs.share = static_cast<double>(count) / static_cast<double>(moved.size());
        pairs.rms_m = std::sqrt(sum_m2 / static_cast<double>(count));
    }
    return pairs;
}

/// Composing many steps wears the rotation out; this makes it one again.
void makeRigid(Transform& transform) {
    transform.linear() = Eigen::Quaterniond(transform.linear()).normalized().toRotationMatrix();
}

}  // namespace

PointFit fitToPoints(std::span<const Eigen::Vector3d> source, std::span<const Eigen::Vector3d> target,
                     const NeighbourIndex& index, const Transform& start, const PointFitSettings& settings,
                     const std::string& stage, Progress& progress) {
    PointFit fit{start, false};
    std::vector<Eigen::Vector3d> moved(source.size());
    double earlierShare = -1.0;
    double earlierRms_m = 0.0;
    for (int iteration = 0; iteration < settings.maximumIterations; ++iteration) {
        progress.report(stage, static_cast<double>(iteration) / settings.maximumIterations);
        for (std::size_t i = 0; i < source.size(); ++i)
            moved[i] = fit.T_target_from_source * source[i];
        Progress inner([&](const std::string&, double) { progress.throwIfCancelled(); });
        const Pairs pairs = pairsOf(moved, target, index, settings.maximumCorrespondence_m, inner);
        if (static_cast<std::size_t>(pairs.source.cols()) < kLeastPairs) return fit;
        fit.converged = std::abs(pairs.share - earlierShare) < settings.tolerance &&
                        std::abs(pairs.rms_m - earlierRms_m) < settings.tolerance;
        if (fit.converged) return fit;
        earlierShare = pairs.share;
        earlierRms_m = pairs.rms_m;
        const Eigen::Matrix4d step = Eigen::umeyama(pairs.source, pairs.target, false);
        fit.T_target_from_source = Transform(step) * fit.T_target_from_source;
        makeRigid(fit.T_target_from_source);
    }
    return fit;
}

}  // namespace fodscope
