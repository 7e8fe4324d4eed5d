// SPDX-License-Identifier: MIT
#include "core/registration/PlaneFit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/registration/OrderedSum.h"

namespace fodscope {
namespace {

constexpr std::size_t kLeastPairs = 30;
/// Paired surfaces lean towards each other by less than acos of this, 45°.
constexpr double kLeastAlignment = 0.7;
/// A patch's nearest neighbour on the same surface lies at most this many target voxels off.
constexpr double kReach_voxels = 2.5;
/// The limit of the residuals shrinks by this factor a step, from the largest correspondence.
constexpr double kShrink = 0.7;
/// Tukey's constant, and standard deviations per median absolute deviation.
constexpr double kTukey = 4.685;
constexpr double kDeviationPerMedian = 1.4826;
/// Sensors and models are not better than this.
constexpr double kLeastScale_m = 0.003;
/// Residuals of places nearer than this go together, see poseUncertainty(): a robot that maps as it drives is off by
/// about the same over so far.
constexpr double kCorrelationLength_m = 3.0;

std::vector<PlaneEquation> equationsOf(const PatchPairs& pairs, const Transform& transform, double reach_m) {
    constexpr double kNone = -1.0;
    std::vector<PlaneEquation> equations(pairs.size());
    forEachPart(pairs.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t i = begin; i < end; ++i) {
            equations[i].weight = kNone;
            if (pairs.squaredDistance_m2(i) > reach_m * reach_m) continue;
            const SurfacePatch& from = pairs.sourcePatch(i);
            const SurfacePatch& to = pairs.targetPatch(i);
            const double alignment = std::abs(to.normal.dot(transform.linear() * from.normal));
            if (alignment < kLeastAlignment) continue;
            equations[i] = {pairs.centre(i), to.normal, to.normal.dot(pairs.centre(i) - to.centre),
                            alignment * from.planarity * to.planarity};
        }
    });
    std::erase_if(equations, [](const PlaneEquation& equation) { return equation.weight < 0.0; });
    return equations;
}

double medianOf(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Applies Tukey's weights with a limit from the residuals, but not under `least_m`.
/// @return the limit
double weigh(std::vector<PlaneEquation>& equations, double least_m) {
    std::vector<double> sizes;
    sizes.reserve(equations.size());
    for (const PlaneEquation& equation : equations)
        sizes.push_back(std::abs(equation.residual_m));
    const double scale_m = std::max(kDeviationPerMedian * medianOf(sizes), kLeastScale_m);
    const double limit_m = std::max(kTukey * scale_m, least_m);
    for (PlaneEquation& equation : equations) {
        const double share = std::min(std::abs(equation.residual_m) / limit_m, 1.0);
        equation.weight *= (1.0 - share * share) * (1.0 - share * share);
    }
    return limit_m;
}

/// The motion that solves the equations in the directions that they hold.
MotionEquations::Vector step(const MotionEquations& motion) {
    MotionEquations::Vector step = MotionEquations::Vector::Zero();
    for (Eigen::Index i = 0; i < 6; ++i) {
        if (motion.eigenvalues[i] < kLeastHold) continue;
        const MotionEquations::Vector direction = motion.eigenvectors.col(i);
        step += direction * (direction.dot(motion.gradient) / (motion.weight * motion.eigenvalues[i]));
    }
    return step;
}

Transform moveBy(const MotionEquations::Vector& step, const MotionEquations& motion) {
    const Eigen::Vector3d turn = step.tail<3>() / motion.length_m;
    const double angle_rad = turn.norm();
    Transform transform = Transform::Identity();
    if (angle_rad > 0.0) transform.linear() = Eigen::AngleAxisd(angle_rad, turn / angle_rad).toRotationMatrix();
    transform.translation() = motion.centre + step.head<3>() - transform.linear() * motion.centre;
    return transform;
}

}  // namespace

void PatchPairs::moveTo(const Transform& T_target_from_source, Progress& progress) {
    forEachPart(chosen_.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t i = begin; i < end; ++i)
            centres_[i] = T_target_from_source * source_.all()[chosen_[i]].centre;
    });
    target_.places().update(centres_, pairs_, progress);
}

PlaneFit fitToPlanes(PatchPairs& pairs, const Transform& start, const PlaneFitSettings& settings,
                     const std::string& stage, Progress& progress) {
    PlaneFit fit;
    fit.T_target_from_source = start;
    const double voxelSize_m = pairs.target().voxelSize_m();
    double least_m = std::min(settings.firstLimit_m, settings.maximumCorrespondence_m);
    std::vector<PlaneEquation> equations;
    MotionEquations motion;
    while (fit.iterations < settings.maximumIterations) {
        progress.report(stage, static_cast<double>(fit.iterations) / settings.maximumIterations);
        const double reach_m = std::min(std::max(least_m, kReach_voxels * voxelSize_m),
                                        std::max(settings.maximumCorrespondence_m, voxelSize_m));
        pairs.moveTo(fit.T_target_from_source, progress);
        equations = equationsOf(pairs, fit.T_target_from_source, reach_m);
        if (equations.size() < kLeastPairs) return fit;
        const double limit_m = weigh(equations, least_m);
        motion = motionEquations(equations);
        if (!(motion.weight > 0.0)) return fit;
        const MotionEquations::Vector delta = step(motion);
        fit.T_target_from_source = moveBy(delta, motion) * fit.T_target_from_source;
        fit.T_target_from_source.linear() =
            Eigen::Quaterniond(fit.T_target_from_source.linear()).normalized().toRotationMatrix();
        ++fit.iterations;
        const bool shrunk = least_m <= limit_m / 2.0;
        fit.converged = shrunk && delta.cwiseAbs().maxCoeff() < settings.tolerance_m;
        if (fit.converged) break;
        least_m *= kShrink;
    }
    if (fit.iterations > 0) fit.uncertainty = poseUncertainty(equations, motion, kCorrelationLength_m);
    return fit;
}

double explainedShare(PatchPairs& pairs, const Transform& T_target_from_source, double tolerance_m,
                      Progress& progress) {
    if (pairs.size() == 0) return 0.0;
    pairs.moveTo(T_target_from_source, progress);
    const double reach_m = std::max(tolerance_m, kReach_voxels * pairs.target().voxelSize_m());
    std::size_t explained = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (pairs.squaredDistance_m2(i) > reach_m * reach_m) continue;
        const SurfacePatch& to = pairs.targetPatch(i);
        const double alignment = std::abs(to.normal.dot(T_target_from_source.linear() * pairs.sourcePatch(i).normal));
        if (alignment < kLeastAlignment) continue;
        if (std::abs(to.normal.dot(pairs.centre(i) - to.centre)) <= tolerance_m) ++explained;
    }
    return static_cast<double>(explained) / static_cast<double>(pairs.size());
}

}  // namespace fodscope
