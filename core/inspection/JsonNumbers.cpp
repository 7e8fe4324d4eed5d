// SPDX-License-Identifier: MIT
#include "core/inspection/JsonNumbers.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace fodscope {

using Json = nlohmann::ordered_json;

Json rounded(double value, int decimals) {
    if (!std::isfinite(value)) return nullptr;
    const double scale = std::pow(10.0, decimals);
    const double result = std::round(value * scale) / scale;
    // −0 would be written "-0.0".
    return result == 0.0 ? 0.0 : result;
}

Json jsonPoint(const Eigen::Vector3d& point) {
    return Json::array({rounded(point.x()), rounded(point.y()), rounded(point.z())});
}

Json jsonTransform(const Transform& transform) {
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row) {
        Json numbers = Json::array();
        for (int column = 0; column < 4; ++column) {
            numbers.push_back(rounded(transform.matrix()(row, column), 12));
        }
        rows.push_back(numbers);
    }
    return rows;
}

nlohmann::ordered_json jsonAlternatives(const std::vector<PoseAlternative>& alternatives) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const PoseAlternative& alternative : alternatives) {
        list.push_back({{"T_reference_from_map", jsonTransform(alternative.T_reference_from_map)},
                        {"rms_m", rounded(alternative.rms_m)},
                        {"overlap", rounded(alternative.overlap)},
                        {"explained", rounded(alternative.explained)}});
    }
    return list;
}

nlohmann::ordered_json jsonUncertainty(const std::optional<PoseUncertainty>& uncertainty) {
    if (!uncertainty) return nullptr;
    nlohmann::ordered_json covariance = nlohmann::ordered_json::array();
    for (Eigen::Index row = 0; row < 6; ++row) {
        nlohmann::ordered_json numbers = nlohmann::ordered_json::array();
        for (Eigen::Index column = 0; column < 6; ++column)
            numbers.push_back(rounded(uncertainty->covariance(row, column), 12));
        covariance.push_back(numbers);
    }
    nlohmann::ordered_json loose = nlohmann::ordered_json::array();
    for (const Eigen::Vector3d& direction : uncertainty->looseDirections)
        loose.push_back(jsonPoint(direction));
    return {{"centre_reference", jsonPoint(uncertainty->centre_reference)},
            {"position_std_m", jsonPoint(uncertainty->positionDeviation_m())},
            {"angle_std_deg", jsonPoint(uncertainty->angleDeviation_rad() * kDegreesPerRadian)},
            {"covariance", covariance},
            {"loose_directions", loose},
            {"loose_turn", uncertainty->looseTurn}};
}

std::string qualityWord(RegistrationQuality quality) {
    switch (quality) {
        case RegistrationQuality::Given:
            return "given";
        case RegistrationQuality::Good:
            return "good";
        case RegistrationQuality::Ambiguous:
            return "ambiguous";
        case RegistrationQuality::Bad:
            return "bad";
    }
    return "unknown";
}

}  // namespace fodscope
