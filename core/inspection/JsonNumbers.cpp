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

std::string qualityWord(RegistrationQuality quality) {
    switch (quality) {
        case RegistrationQuality::Given:
            return "given";
        case RegistrationQuality::Good:
            return "good";
        case RegistrationQuality::Bad:
            return "bad";
    }
    return "unknown";
}

}  // namespace fodscope
