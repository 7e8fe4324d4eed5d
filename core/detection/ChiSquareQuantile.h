// SPDX-License-Identifier: MIT
#pragma once

namespace fodscope {

/// @return the probability that a χ² variable with that many degrees of freedom exceeds x
/// @throws Error for fewer than one degree of freedom
double chiSquareSurvival(double x, int degreesOfFreedom);

/// The inverse: what a χ² variable exceeds with that probability.
/// @throws Error for a probability outside (0, 1), or fewer than one degree of freedom
double chiSquareQuantile(double exceedingProbability, int degreesOfFreedom);

}  // namespace fodscope
