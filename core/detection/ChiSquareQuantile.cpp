// SPDX-License-Identifier: MIT
#include "core/detection/ChiSquareQuantile.h"

#include <cmath>
#include <string>

#include "core/common/Error.h"

namespace fodscope {
namespace {

void checkDegrees(int degreesOfFreedom) {
    if (degreesOfFreedom >= 1) return;
    throw Error("chi-square distribution",
                "it has at least 1 degree of freedom, not " + std::to_string(degreesOfFreedom), "use more classes");
}

}  // namespace

double chiSquareSurvival(double x, int degreesOfFreedom) {
    checkDegrees(degreesOfFreedom);
    if (!(x > 0.0)) return std::isnan(x) ? x : 1.0;
    if (std::isinf(x)) return 0.0;
    // Q(ν/2, x/2) for whole ν: repeated integration by parts leaves e^(−h) Σ h^s / Γ(s + 1) with h = x/2, over
    // s = 0, 1, … for even ν, and over s = 1/2, 3/2, … for odd ν, where erfc(√h) is what remains.
    const double half = 0.5 * x;
    const bool isEven = degreesOfFreedom % 2 == 0;
    double sum = isEven ? 0.0 : std::erfc(std::sqrt(half));
    for (double s = isEven ? 0.0 : 0.5; s < 0.5 * degreesOfFreedom - 0.25; s += 1.0)
        sum += std::exp(s * std::log(half) - half - std::lgamma(s + 1.0));
    return sum;
}

double chiSquareQuantile(double exceedingProbability, int degreesOfFreedom) {
    checkDegrees(degreesOfFreedom);
    if (!(exceedingProbability > 0.0 && exceedingProbability < 1.0)) {
        throw Error("p-value", "must be greater than 0 and less than 1", "give for example 0.0005");
    }
    double low = 0.0;
    double high = 1.0;
    while (chiSquareSurvival(high, degreesOfFreedom) > exceedingProbability) {
        low = high;
        high *= 2.0;
    }
    for (double middle = 0.5 * (low + high); low < middle && middle < high; middle = 0.5 * (low + high))
        (chiSquareSurvival(middle, degreesOfFreedom) > exceedingProbability ? low : high) = middle;
    return high;
}

}  // namespace fodscope
