// SPDX-License-Identifier: MIT
#include "tests/benchmark/DragPath.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace fodscope {
namespace {

constexpr int kPatches = 80;
constexpr double kLowestCutoff_m = 0.05;
constexpr double kHighestCutoff_m = 0.60;
constexpr std::size_t kMovesOfThresholdSweep = 100;
constexpr std::size_t kMovesOfCutoffSweep = 74;
constexpr double kUnsteadiness = 0.02;

struct Patch {
    Eigen::Vector3d centre;
    double radius_m;
    double height;
};

/// There and back, 0 to 1 to 0.
double sweep(std::size_t move, std::size_t movesOneWay) {
    const double way = static_cast<double>(move % (2 * movesOneWay)) / static_cast<double>(movesOneWay);
    return way <= 1.0 ? way : 2.0 - way;
}

}  // namespace

std::shared_ptr<const DiscrepancyField> drawnField(std::span<const Eigen::Vector3d> points, std::uint64_t seed) {
    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::exponential_distribution<double> tail(3.0);
    std::normal_distribution<double> noise(0.9, 0.25);
    std::vector<Patch> patches(kPatches);
    for (Patch& patch : patches) {
        const auto middle = static_cast<std::size_t>(unit(generator) * static_cast<double>(points.size()));
        patch = {points[middle], 0.03 * std::pow(20.0, unit(generator)), 1.0 + 7.0 * unit(generator)};
    }
    auto field = std::make_shared<DiscrepancyField>();
    field->points.assign(points.begin(), points.end());
    for (const Eigen::Vector3d& point : points) {
        double value = std::abs(noise(generator)) + tail(generator);
        for (const Patch& patch : patches)
            value += patch.height * std::exp(-(point - patch.centre).squaredNorm() / (patch.radius_m * patch.radius_m));
        field->smoothedMahalanobis.push_back(value);
        field->smoothedEuclidean_m.push_back(0.01 * value);
    }
    field->mahalanobis = field->smoothedMahalanobis;
    field->euclidean_m = field->smoothedEuclidean_m;
    field->weights.assign(points.size(), 1);
    field->nearest.assign(points.size(), 0);
    return field;
}

std::vector<CandidateSettings> dragPath(const DiscrepancyField& field, std::size_t moves, std::size_t fewest,
                                        std::size_t most, std::uint64_t seed) {
    std::vector<double> descending = field.smoothed(Metric::Mahalanobis);
    std::ranges::sort(descending, std::greater<>());
    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const double low = std::log(static_cast<double>(fewest));
    const double high = std::log(static_cast<double>(std::min(most, descending.size())));
    const auto unsteady = [&](std::size_t move, std::size_t movesOneWay) {
        return std::clamp(sweep(move, movesOneWay) + kUnsteadiness * (2.0 * unit(generator) - 1.0), 0.0, 1.0);
    };
    const std::size_t begin = generator() % (2 * kMovesOfThresholdSweep);
    double logarithm = low + (high - low) * sweep(begin, kMovesOfThresholdSweep);
    double cutoff_m = CandidateSettings().clusterCutoff_m;
    std::vector<CandidateSettings> path;
    for (std::size_t i = 0; i < moves; ++i) {
        if (i % 3 != 2) {
            logarithm = low + (high - low) * unsteady(begin + i, kMovesOfThresholdSweep);
        } else {
            cutoff_m =
                kLowestCutoff_m + (kHighestCutoff_m - kLowestCutoff_m) * unsteady(begin + i, kMovesOfCutoffSweep);
        }
        const auto above = static_cast<std::size_t>(std::exp(logarithm));
        CandidateSettings settings;
        settings.threshold = above < descending.size() ? descending[above] : 0.0;
        settings.clusterCutoff_m = cutoff_m;
        path.push_back(settings);
    }
    return path;
}

double quantileOf(std::vector<double> values, double share) {
    std::ranges::sort(values);
    const auto index = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5);
    return values.at(index);
}

}  // namespace fodscope
