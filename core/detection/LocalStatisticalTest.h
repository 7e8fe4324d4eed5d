// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <variant>
#include <vector>

#include "core/common/Progress.h"

namespace fodscope {

// CloudCompare's Local Statistical Test ("a spatial Chi-squared test … for local outlier detection" in the paper, which
// adds that it works well only for clouds of homogeneous density): one distribution is fitted to the scalar values of
// the whole cloud, and each point is judged by how unlike that distribution the values around it are.

enum class TestDistribution { Gauss, Weibull };

struct LocalStatisticalTestSettings {
    TestDistribution distribution = TestDistribution::Gauss;
    /// k: the nearest points whose values form a histogram, the point itself among them. CloudCompare: 16.
    int neighbours = 16;
    /// Share of points of an unremarkable cloud that exceed testThreshold(). CloudCompare: 0.0005.
    double pValue = 0.0005;

    bool operator==(const LocalStatisticalTestSettings&) const = default;
};

struct GaussFit {
    double mean = 0.0;
    double standardDeviation = 0.0;

    /// Cumulative distribution function.
    double below(double value) const;
};

struct WeibullFit {
    double shape = 0.0;
    double scale = 0.0;
    /// The distribution begins here.
    double shift = 0.0;

    double below(double value) const;
};

using FittedDistribution = std::variant<GaussFit, WeibullFit>;

/// Mean and standard deviation (over n). Values that are not finite are left out.
/// @throws Error when all values are equal, or none is finite
GaussFit fitGauss(std::span<const double> values);

/// Shift: the least value. Shape and scale: maximum likelihood for what lies over the shift, where differences under
/// 1.1920929e-07 (the epsilon of float) count as that in the likelihood's logarithms. Values that are not finite are
/// left out.
/// @throws Error when all values are equal, none is finite, or no shape from 1e-7 to 1024 is the likeliest
WeibullFit fitWeibull(std::span<const double> values);

/// @return classes of the histogram: √k, rounded up
int testClasses(int neighbours);

/// @return what a share `pValue` of the points exceeds where all values follow the distribution: the root of the χ²
///         quantile with one degree of freedom less than classes
/// @throws Error for settings out of range
double testThreshold(const LocalStatisticalTestSettings& settings);

/// The root of the χ² distance between the histogram of the values of a point's k nearest neighbours and what the
/// distribution expects of k values. As CloudCompare defines it:
/// - The √k classes are equally wide. Gauss: from 3 σ below to 3 σ above the mean; all neighbours farther below, and
/// all
///   farther above, form one more class each, of which a millionth is expected, so that a single one among 16 weighs
///   250. Weibull: from 0 to the greatest value among the neighbours, so that what is expected above is not counted,
///   and neighbours with values under 0 form one more class of a millionth. Greatest values of 1.1920929e-07 and less
///   put all neighbours into the first class.
/// - Classes are never merged. χ² ends at 1e7, and is 1e7 where a class has the probability 0.
/// - The test has two sides: a place that is quieter than the whole is as remarkable as a restless one.
/// Differences: in double here, in float there (values on a class limit may fall to the other side); of equally distant
/// neighbours those with the lower index are taken; points without a value take no place among the neighbours; and
/// where the cloud has fewer points with values than k, all of them are taken and k is their number.
/// CloudCompare 2.11.3 fills one histogram from all its threads, so that some of its distances are wrong in every run
/// on several processors; these follow what one thread computes.
/// @return per point; NaN where its own value is not finite
/// @throws Error when sizes differ, k is less than 2, or fewer than 2 values are finite; Cancelled
std::vector<double> localChiSquare(std::span<const Eigen::Vector3d> points, std::span<const double> values,
                                   const FittedDistribution& distribution, int neighbours, Progress& progress);

/// Fits the distribution and tests every point against it.
/// @throws Error for settings out of range or values that nothing can be fitted to; Cancelled
std::vector<double> localStatisticalTest(std::span<const Eigen::Vector3d> points, std::span<const double> values,
                                         const LocalStatisticalTestSettings& settings, Progress& progress);

}  // namespace fodscope
