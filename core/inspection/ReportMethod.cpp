// SPDX-License-Identifier: MIT
#include "core/inspection/ReportMethod.h"

#include "core/inspection/ReportText.h"

namespace fodscope {
namespace {

std::string thinning(const DiscrepancySettings& settings) {
    if (settings.downSampling == DownSampling::Random) {
        return "thinned to a random " + percent(settings.randomRatio) +
               " of its points, called voxels here. Each voxel's discrepancy";
    }
    return "reduced to voxels of " + length(settings.voxelSize_m) + ". Each voxel's discrepancy";
}

std::string smoothing(const DiscrepancySettings& settings) {
    const SmoothingSettings& smoothing = settings.smoothing;
    const bool isBall = smoothing.neighbourhood == SmoothingNeighbourhood::Ball;
    if (settings.smoothingPasses == 0 || (!isBall && smoothing.neighbours == 1)) return "not smoothed";
    std::string text = "smoothed over ";
    text += isBall ? "a ball of " + length(smoothing.radius_m) : std::to_string(smoothing.neighbours) + " neighbours";
    if (smoothing.weights == SmoothingWeights::Gaussian) {
        text += " with Gaussian weights (sigma " + length(smoothing.sigma_m) + ")";
    }
    if (settings.smoothingPasses > 1) text += ", " + std::to_string(settings.smoothingPasses) + " times";
    return text;
}

std::string discrepancy(const Parameters& parameters) {
    switch (parameters.candidates.metric) {
        case Metric::Euclidean:
            return "Euclidean distance to the nearest reference point, " + smoothing(parameters.discrepancy);
        case Metric::Mahalanobis:
            return "local Mahalanobis distance to the nearest reference point (unitless), " +
                   smoothing(parameters.discrepancy);
        case Metric::ChiSquare:
            break;
    }
    const bool isGauss = parameters.chiSquare.distribution == TestDistribution::Gauss;
    return "chi-square distance (unitless) between the Euclidean distances to the reference at its " +
           std::to_string(parameters.chiSquare.neighbours) + " nearest voxels and the " +
           (isGauss ? "Gauss" : "Weibull") + " distribution fitted to those of the whole map";
}

}  // namespace

std::string methodOf(const Parameters& parameters) {
    const std::string linkage = parameters.candidates.linkage == Linkage::Single ? "single" : "centroid";
    return std::string("The map was ") + (parameters.denoise.enabled ? "denoised, " : "") +
           "aligned with the reference map and " + thinning(parameters.discrepancy) + " is its " +
           discrepancy(parameters) + ". Voxels above the threshold of " +
           discrepancyText(parameters.candidates.threshold, parameters.candidates.metric) +
           " were clustered into candidates (" + linkage + " linkage, cutoff " +
           length(parameters.candidates.clusterCutoff_m) +
           "). Candidates were photographed by the robot and decided by people from the photos; the last decision of "
           "each reader on each photo counts, and a candidate on which readers disagree or are not sure stays open.";
}

}  // namespace fodscope
