// SPDX-License-Identifier: MIT
#include "core/detection/LocalStatisticalTest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "core/cloud/NeighbourIndex.h"
#include "core/common/Error.h"
#include "core/detection/ChiSquareQuantile.h"

namespace fodscope {
namespace {

/// CloudCompare's "zero".
constexpr double kZero = std::numeric_limits<float>::epsilon();
constexpr double kGreatestChiSquare = 1e7;
/// Expected share of the values outside of the classes.
constexpr double kOutsideShare = 1e-6;

void checkNeighbours(int neighbours) {
    if (neighbours >= 2) return;
    throw Error("chi-square neighbours", "must be at least 2, not " + std::to_string(neighbours),
                "give a whole number such as 16");
}

void check(const LocalStatisticalTestSettings& settings) {
    std::string problems;
    if (settings.neighbours < 2)
        problems = "the neighbours must be at least 2, not " + std::to_string(settings.neighbours);
    if (!(settings.pValue > 0.0 && settings.pValue < 1.0)) {
        if (!problems.empty()) problems += ", ";
        problems += "the p-value must be greater than 0 and less than 1";
    }
    if (!problems.empty())
        throw Error("chi-square settings", problems, "the defaults are 16 neighbours and a p-value of 0.0005");
}

std::vector<double> finiteOf(std::span<const double> values) {
    std::vector<double> finite;
    finite.reserve(values.size());
    std::ranges::copy_if(values, std::back_inserter(finite), [](double value) { return std::isfinite(value); });
    const bool differ = std::ranges::any_of(finite, [&](double value) { return value != finite.front(); });
    if (!differ) {
        throw Error("chi-square test",
                    finite.empty() ? "no value is known" : "all values are equal, so that no distribution fits them",
                    "choose another metric");
    }
    return finite;
}

/// The likelihood's derivative by the shape, over positive values with the given logarithms; it grows with the shape.
double likelihoodSlope(const std::vector<double>& logarithms, double greatest, double meanLogarithm, double shape) {
    double powers = 0.0;
    double weighted = 0.0;
    for (const double logarithm : logarithms) {
        // Relative to the greatest value, so that nothing overflows.
        const double power = std::exp(shape * (logarithm - greatest));
        powers += power;
        weighted += power * logarithm;
    }
    return (weighted / powers - meanLogarithm) * shape - 1.0;
}

double likeliestShape(const std::vector<double>& logarithms) {
    const double greatest = *std::ranges::max_element(logarithms);
    double sum = 0.0;
    for (const double logarithm : logarithms)
        sum += logarithm;
    const double mean = sum / static_cast<double>(logarithms.size());
    const auto slope = [&](double shape) { return likelihoodSlope(logarithms, greatest, mean, shape); };
    double low = 1e-7;
    double high = 1024.0;
    if (!(slope(low) < 0.0) || !(slope(high) > 0.0)) {
        throw Error("chi-square test", "no Weibull distribution fits the values", "use the Gauss distribution");
    }
    // In steps of the geometric mean: the bounds span ten powers of ten.
    for (int i = 0; i < 100 && high > low * (1.0 + 1e-14); ++i) {
        const double middle = std::sqrt(low * high);
        (slope(middle) < 0.0 ? low : high) = middle;
    }
    return std::sqrt(low * high);
}

/// Equally wide classes from `low` to `high`, with what is expected in each.
class Histogram {
  public:
    explicit Histogram(int classes)
        : counts_(static_cast<std::size_t>(classes)), probabilities_(static_cast<std::size_t>(classes)) {}

    template <class Distribution>
    void divide(double low, double high, const Distribution& distribution) {
        low_ = low;
        high_ = high;
        const auto classes = static_cast<double>(probabilities_.size());
        double before = distribution.below(low);
        for (std::size_t i = 0; i < probabilities_.size(); ++i) {
            const double after = distribution.below(low + static_cast<double>(i + 1) * (high - low) / classes);
            probabilities_[i] = after - before;
            before = after;
        }
    }

    /// @return χ² between the values and what is expected of so many
    double chiSquare(std::span<const double> values) {
        count(values);
        const auto n = static_cast<double>(values.size());
        double sum = outside(below_, n) + outside(above_, n);
        for (std::size_t i = 0; i < counts_.size(); ++i) {
            const double expected = probabilities_[i] * n;
            if (!(expected > 0.0)) return kGreatestChiSquare;
            const double difference = counts_[i] - expected;
            sum += difference * difference / expected;
        }
        return std::min(sum, kGreatestChiSquare);
    }

  private:
    static double outside(double counted, double n) {
        if (counted == 0.0) return 0.0;
        const double expected = kOutsideShare * n;
        return (counted - expected) * (counted - expected) / expected;
    }

    void count(std::span<const double> values) {
        std::ranges::fill(counts_, 0.0);
        below_ = above_ = 0.0;
        const double width = high_ - low_;
        if (!(width > kZero)) {
            counts_.front() = static_cast<double>(values.size());
            return;
        }
        const auto classes = static_cast<double>(counts_.size());
        for (const double value : values) {
            const double position = std::floor((value - low_) * classes / width);
            if (position < 0.0) {
                below_ += 1.0;
            } else if (position < classes) {
                counts_[static_cast<std::size_t>(position)] += 1.0;
            } else {
                (value > high_ ? above_ : counts_.back()) += 1.0;
            }
        }
    }

    std::vector<double> counts_;
    std::vector<double> probabilities_;
    double low_ = 0.0;
    double high_ = 0.0;
    double below_ = 0.0;
    double above_ = 0.0;
};

/// The classes round the mean are the same for every point.
Histogram histogramFor(const GaussFit& fit, int classes) {
    Histogram histogram(classes);
    histogram.divide(fit.mean - 3.0 * fit.standardDeviation, fit.mean + 3.0 * fit.standardDeviation, fit);
    return histogram;
}

Histogram histogramFor(const WeibullFit&, int classes) {
    return Histogram(classes);
}

void fitClasses(Histogram&, const GaussFit&, std::span<const double>) {}

void fitClasses(Histogram& histogram, const WeibullFit& fit, std::span<const double> values) {
    histogram.divide(0.0, *std::ranges::max_element(values), fit);
}

/// The points whose value is finite.
struct Known {
    std::vector<std::uint32_t> indices;
    std::vector<Eigen::Vector3d> points;
    std::vector<double> values;
};

Known knownOf(std::span<const Eigen::Vector3d> points, std::span<const double> values) {
    if (points.size() != values.size()) {
        throw Error(
            "chi-square test",
            "there are " + std::to_string(values.size()) + " values for " + std::to_string(points.size()) + " points",
            "give one value a point");
    }
    Known known;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i])) continue;
        known.indices.push_back(static_cast<std::uint32_t>(i));
        known.points.push_back(points[i]);
        known.values.push_back(values[i]);
    }
    if (known.values.size() < 2) {
        throw Error("chi-square test", "fewer than 2 values are known", "choose another metric");
    }
    return known;
}

}  // namespace

double GaussFit::below(double value) const {
    return 0.5 * (std::erf((value - mean) / (standardDeviation * std::numbers::sqrt2)) + 1.0);
}

double WeibullFit::below(double value) const {
    return value <= shift ? 0.0 : 1.0 - std::exp(-std::pow((value - shift) / scale, shape));
}

GaussFit fitGauss(std::span<const double> values) {
    const std::vector<double> finite = finiteOf(values);
    const auto n = static_cast<double>(finite.size());
    double sum = 0.0;
    for (const double value : finite)
        sum += value;
    const double mean = sum / n;
    double squares = 0.0;
    for (const double value : finite)
        squares += (value - mean) * (value - mean);
    return {mean, std::sqrt(squares / n)};
}

WeibullFit fitWeibull(std::span<const double> values) {
    std::vector<double> finite = finiteOf(values);
    const double shift = *std::ranges::min_element(finite);
    std::vector<double> logarithms;
    logarithms.reserve(finite.size());
    for (double& value : finite) {
        value -= shift;
        logarithms.push_back(std::log(std::max(value, kZero)));
    }
    const double shape = likeliestShape(logarithms);
    const double greatest = *std::ranges::max_element(finite);
    double powers = 0.0;
    for (const double value : finite)
        powers += std::pow(value / greatest, shape);
    return {shape, greatest * std::pow(powers / static_cast<double>(finite.size()), 1.0 / shape), shift};
}

int testClasses(int neighbours) {
    checkNeighbours(neighbours);
    return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(neighbours))));
}

double testThreshold(const LocalStatisticalTestSettings& settings) {
    check(settings);
    return std::sqrt(chiSquareQuantile(settings.pValue, testClasses(settings.neighbours) - 1));
}

std::vector<double> localChiSquare(std::span<const Eigen::Vector3d> points, std::span<const double> values,
                                   const FittedDistribution& distribution, int neighbours, Progress& progress) {
    checkNeighbours(neighbours);
    const Known known = knownOf(points, values);
    const std::size_t k = std::min(static_cast<std::size_t>(neighbours), known.values.size());
    const int classes = testClasses(static_cast<int>(k));
    std::vector<double> distances(values.size(), std::numeric_limits<double>::quiet_NaN());
    const NeighbourIndex index(known.points, progress);
    std::visit(
        [&](const auto& fit) {
            const Histogram empty = histogramFor(fit, classes);
            index.forEachKNearest(
                known.points, k,
                [&](std::size_t i, std::span<const Neighbour> found) {
                    std::vector<double> around;
                    around.reserve(found.size());
                    for (const Neighbour& neighbour : found)
                        around.push_back(known.values[neighbour.index]);
                    Histogram histogram = empty;
                    fitClasses(histogram, fit, around);
                    distances[known.indices[i]] = std::sqrt(histogram.chiSquare(around));
                },
                progress, "chi-square test");
        },
        distribution);
    return distances;
}

std::vector<double> localStatisticalTest(std::span<const Eigen::Vector3d> points, std::span<const double> values,
                                         const LocalStatisticalTestSettings& settings, Progress& progress) {
    check(settings);
    FittedDistribution distribution;
    if (settings.distribution == TestDistribution::Gauss) {
        distribution = fitGauss(values);
    } else {
        distribution = fitWeibull(values);
    }
    return localChiSquare(points, values, distribution, settings.neighbours, progress);
}

}  // namespace fodscope
