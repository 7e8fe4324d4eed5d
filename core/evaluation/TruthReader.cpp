// SPDX-License-Identifier: MIT
#include "core/evaluation/TruthReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/common/Error.h"
#include "core/common/Files.h"

namespace fodscope {
namespace {

using nlohmann::json;

/// A trial has a handful of FOD; more is a damaged file.
constexpr std::size_t kMostFods = 10000;
/// No tank reaches this far: such a number is a damaged one, or not in metres.
constexpr double kFarthest_m = 1e6;

/// Reads one file's fields and collects what is wrong with them.
class TruthFields {
  public:
    TruthFields(std::string file, TruthProblems& problems) : file_(std::move(file)), problems_(problems) {}

    void read(const json& root, Trial& trial) {
        if (root.is_discarded() || !root.is_object()) {
            add("this is no JSON object (damaged, truncated or another kind of file)");
            return;
        }
        readFods(root, trial);
        trial.T_cad_from_map = transform(root, "T_cad_from_map");
        trial.T_cad_from_map_initial = transform(root, "T_cad_from_map_initial");
    }

    void add(const std::string& text) { problems_.push_back({file_, text}); }

  private:
    void readFods(const json& root, Trial& trial) {
        const auto fods = root.find("fods");
        if (fods == root.end()) return add("\"fods\" is missing (a nominal map has an empty list)");
        if (!fods->is_array()) return add("\"fods\" is not a list");
        if (fods->size() > kMostFods) return add("\"fods\" holds more than " + std::to_string(kMostFods) + " entries");
        for (std::size_t i = 0; i < fods->size(); ++i)
            trial.fods.push_back(fod((*fods)[i], "fods[" + std::to_string(i) + "]"));
    }

    GroundTruthFod fod(const json& value, const std::string& field) {
        GroundTruthFod result;
        if (!value.is_object()) {
            add('"' + field + "\" is not an object");
            return result;
        }
        const auto type = value.find("type");
        if (type == value.end())
            add('"' + field + ".type\" is missing");
        else if (!type->is_string() || type->get_ref<const std::string&>().empty())
            add('"' + field + ".type\" is not a text");
        else
            result.type = type->get<std::string>();
        const auto observed = value.find("observed");
        if (observed != value.end()) {
            if (observed->is_boolean())
                result.observed = observed->get<bool>();
            else
                add('"' + field + ".observed\" is neither true nor false");
        }
        const auto centroid = value.find("gt_centroid_map");
        if (centroid == value.end())
            add('"' + field + ".gt_centroid_map\" is missing");
        else
            result.centroid_map = point(*centroid, field + ".gt_centroid_map");
        return result;
    }

    Eigen::Vector3d point(const json& value, const std::string& field) {
        Eigen::Vector3d result = Eigen::Vector3d::Zero();
        if (!value.is_array() || value.size() != 3) {
            add('"' + field + "\" is not a list of 3 numbers");
            return result;
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            // JSON knows no NaN; writers leave null, or a number too great for a double.
            if (!value[axis].is_number() || !std::isfinite(value[axis].get<double>())) {
                add('"' + field + "\" holds an entry that is not a finite number");
                return result;
            }
            result[static_cast<Eigen::Index>(axis)] = value[axis].get<double>();
        }
        if (result.cwiseAbs().maxCoeff() > kFarthest_m) add('"' + field + "\" lies beyond 1000 km; give metres");
        return result;
    }

    /// 4×4 rows, nested or flat, or {x, y, z, qx, qy, qz, qw}.
    std::optional<Transform> transform(const json& root, const char* key) {
        const auto value = root.find(key);
        if (value == root.end() || value->is_null()) return std::nullopt;
        const std::string field = key;
        return value->is_object() ? fromPose(*value, field) : fromRows(*value, field);
    }

    std::optional<Transform> fromPose(const json& value, const std::string& field) {
        constexpr std::array<const char*, 7> kKeys = {"x", "y", "z", "qx", "qy", "qz", "qw"};
        std::array<double, 7> numbers{};
        for (std::size_t i = 0; i < kKeys.size(); ++i) {
            const auto entry = value.find(kKeys[i]);
            if (entry == value.end() || !entry->is_number() || !std::isfinite(entry->get<double>())) {
                add('"' + field + "." + kKeys[i] + "\" is not a finite number");
                return std::nullopt;
            }
            numbers[i] = entry->get<double>();
        }
        const Eigen::Quaterniond rotation(numbers[6], numbers[3], numbers[4], numbers[5]);
        if (std::abs(rotation.norm() - 1.0) > 1e-3) {
            add('"' + field + "\" has a quaternion that is not of length 1");
            return std::nullopt;
        }
        Transform result = Transform::Identity();
        result.linear() = rotation.normalized().toRotationMatrix();
        result.translation() = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
        return result;
    }

    std::optional<Transform> fromRows(const json& value, const std::string& field) {
        std::vector<double> numbers;
        if (value.is_array() && value.size() <= 16) {
            for (const json& row : value) {
                const json list = row.is_array() && row.size() == 4 ? row : json::array({row});
                for (const json& entry : list) {
                    if (!entry.is_number() || !std::isfinite(entry.get<double>())) {
                        add('"' + field + "\" holds an entry that is not a finite number");
                        return std::nullopt;
                    }
                    numbers.push_back(entry.get<double>());
                }
            }
        }
        std::array<double, 16> rows{};
        if (numbers.size() != rows.size()) {
            add('"' + field + "\" is not 4 rows of 4 numbers");
            return std::nullopt;
        }
        std::copy(numbers.begin(), numbers.end(), rows.begin());
        try {
            return transformFromRows(rows, field);
        } catch (const Error& error) {
            add('"' + field + "\": " + error.problem());
            return std::nullopt;
        }
    }

    std::string file_;
    TruthProblems& problems_;
};

}  // namespace

void readTruth(const std::filesystem::path& file, Trial& trial, TruthProblems& problems) {
    TruthFields fields(file.filename().string(), problems);
    try {
        fields.read(json::parse(readTextFile(file), nullptr, false), trial);
    } catch (const Error& error) {
        fields.add(error.problem());
    }
}

bool isTruth(const std::filesystem::path& file) {
    try {
        const json root = json::parse(readTextFile(file), nullptr, false);
        return root.is_object() && root.contains("fods");
    } catch (const Error&) {
        return false;
    }
}

}  // namespace fodscope
