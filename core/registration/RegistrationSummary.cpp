// SPDX-License-Identifier: MIT
#include "core/registration/RegistrationSummary.h"

#include <cmath>
#include <cstdio>

namespace fodscope {
namespace {

template <typename... Values>
std::string formatted(const char* format, Values... values) {
    char text[160];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

std::string percent(double share) {
    // Rounded down: 59.7 % must not read as the 60 % that would have been enough.
    return std::to_string(static_cast<int>(std::floor(share * 100.0 + 1e-9))) + " %";
}

std::string millimetres(double length_m) {
    return formatted("%.0f mm", length_m * 1000.0);
}

/// Standard deviations; "known to 3 mm and 0.1°".
std::string knownTo(const PoseUncertainty& uncertainty) {
    const double angle_deg = degreesFromRadians(uncertainty.angleDeviation_rad().maxCoeff());
    const double position_m = uncertainty.positionDeviation_m().maxCoeff();
    return "known to " + millimetres(std::max(position_m, 0.001)) + " and " +
           formatted("%.2g°", std::max(angle_deg, 0.01));
}

/// Minus zero is zero.
double plain(double value) {
    return std::abs(value) < 0.005 ? 0.0 : value;
}

}  // namespace

std::string poseInWords(const Transform& T_reference_from_map) {
    const Eigen::Vector3d& origin = T_reference_from_map.translation();
    const double yaw_deg = degreesFromRadians(poseFromTransform(T_reference_from_map).yaw_rad);
    return formatted("map origin at x %.2f m, y %.2f m, z %.2f m, turned by %.0f°", plain(origin.x()),
                     plain(origin.y()), plain(origin.z()), std::abs(yaw_deg) < 0.5 ? 0.0 : yaw_deg);
}

std::string goodSummary(const RegistrationResult& result) {
    std::string summary = "aligned, " + millimetres(result.rms_m) + " rms, " + percent(result.overlap) + " overlap";
    if (!result.uncertainty) return summary;
    summary += ", " + knownTo(*result.uncertainty);
    const std::string loose = looseInWords(*result.uncertainty);
    if (!loose.empty()) summary += "; the map does not hold " + loose + ", which the start pose tells";
    return summary;
}

std::string ambiguousSummary(const RegistrationResult& result) {
    if (result.alternatives.empty() && result.uncertainty && result.uncertainty->isLoose()) {
        return "the map does not hold " + looseInWords(*result.uncertainty) + "; give a start pose";
    }
    const bool besideStart = result.start_T_reference_from_map.has_value();
    const auto told = [](const Transform& pose, double explained) {
        return "(" + poseInWords(pose) + ": " + percent(explained) + " of the surfaces fit)";
    };
    std::string poses = told(result.T_reference_from_map, result.explained);
    for (const PoseAlternative& other : result.alternatives)
        poses += ", " + told(other.T_reference_from_map, other.explained);
    if (besideStart) {
        return "the map does not fit at the start pose, but elsewhere: " + poses +
               "; check the start pose, or start from one of these";
    }
    static constexpr const char* kNumbers[] = {"two", "three", "four", "five"};
    const std::size_t more = std::min<std::size_t>(result.alternatives.size(), 4);
    return std::string(more == 0 ? "one" : kNumbers[more - 1]) + " poses fit nearly as well: " + poses +
           "; choose one or give a start pose";
}

std::string badSummary(const RegistrationResult& result, const RegistrationSettings& settings, double scale) {
    std::string summary = "not aligned: " + percent(result.overlap) + " overlap";
    if (scale > kAbsurdScale || scale < 1.0 / kAbsurdScale) {
        return summary + "; the map is " + formatted("%.3g", scale) +
               " times the size of the reference, check that both are in metres";
    }
    if (result.overlap < settings.minimumOverlap) {
        return summary + ", at least " + percent(settings.minimumOverlap) +
               " is needed; check that the map shows this space, or give a start pose";
    }
    if (result.explained < settings.minimumExplained) {
        return summary + ", but only " + percent(result.explained) +
               " of the map's surfaces lie in the reference's, at least " + percent(settings.minimumExplained) +
               " is needed; check that the map shows this space, or give a start pose";
    }
    if (result.uncertainty && result.uncertainty->isLoose()) {
        return summary + ", but the map does not hold " + looseInWords(*result.uncertainty) +
               "; map more of the walls, or give the transform";
    }
    return summary + " but the search did not settle within " + std::to_string(settings.maximumIterations) +
           " steps; give a start pose or allow more steps";
}

std::string givenSummary(const RegistrationResult& result, const RegistrationSettings& settings) {
    std::string summary = "transform given, ";
    if (result.overlap > 0.0) summary += millimetres(result.rms_m) + " rms, ";
    summary += percent(result.overlap) + " overlap";
    if (result.overlap < settings.minimumOverlap) summary += ": check the transform";
    return summary;
}

}  // namespace fodscope
