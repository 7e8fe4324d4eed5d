// SPDX-License-Identifier: MIT
#include "core/cloud/Smoothing.h"

#include <cmath>

#include "core/common/Error.h"

namespace fodscope {
namespace {

bool isLength(double value_m) {
    return value_m > 0.0 && std::isfinite(value_m);
}

void requireUsable(const SmoothingSettings& settings, const std::string& subject) {
    std::string text;
    for (const std::string& problem : smoothingProblems(settings))
        text += (text.empty() ? "" : ", ") + problem;
    if (!text.empty()) {
        throw Error(subject, text, "give for example 50 neighbours, a radius of 0.2 m and a sigma of 0.05 m");
    }
}

}  // namespace

std::vector<std::string> smoothingProblems(const SmoothingSettings& settings) {
    std::vector<std::string> problems;
    if (settings.neighbours < 1) {
        problems.push_back("the neighbours must be at least 1, not " + std::to_string(settings.neighbours));
    }
    if (!isLength(settings.radius_m)) problems.push_back("the radius must be greater than 0");
    if (!isLength(settings.sigma_m)) problems.push_back("sigma must be greater than 0");
    return problems;
}

double smoothingWeight(const SmoothingSettings& settings, double squaredDistance_m2) {
    if (settings.weights == SmoothingWeights::Mean) return 1.0;
    return std::exp(-squaredDistance_m2 / (settings.sigma_m * settings.sigma_m));
}

void forEachNeighbourhood(const NeighbourIndex& index, std::span<const Eigen::Vector3d> places,
                          const SmoothingSettings& settings, const std::string& subject,
                          const std::function<void(std::size_t, std::span<const Neighbour>)>& use, Progress& progress,
                          const std::string& stage) {
    requireUsable(settings, subject);
    if (settings.neighbourhood == SmoothingNeighbourhood::Ball) {
        index.forEachWithinRadius(places, settings.radius_m, use, progress, stage);
    } else {
        index.forEachKNearest(places, static_cast<std::size_t>(settings.neighbours), use, progress, stage);
    }
}

}  // namespace fodscope
