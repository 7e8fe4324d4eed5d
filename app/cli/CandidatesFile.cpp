// SPDX-License-Identifier: MIT
#include "app/cli/CandidatesFile.h"

#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "core/common/Error.h"
#include "core/common/Files.h"
#include "core/detection/DiscrepancyPly.h"
#include "core/inspection/DiscrepantPoints.h"

namespace fodscope::cli {
namespace {

using nlohmann::json;

Eigen::Vector3d pointOf(const json& value) {
    const auto numbers = value.get<std::array<double, 3>>();
    return {numbers[0], numbers[1], numbers[2]};
}

Transform transformOf(const json& value, const std::string& subject) {
    const auto rows = value.get<std::array<std::array<double, 4>, 4>>();
    std::array<double, 16> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = rows[i / 4][i % 4];
    return transformFromRows(numbers, subject);
}

CandidatesFile parsed(const json& root, const std::string& subject) {
    CandidatesFile file;
    file.T_reference_from_map = transformOf(root.at("T_reference_from_map"), subject);
    file.threshold = root.at("settings").at("candidates").at("threshold").get<double>();
    const json discrepancy = root.at("settings").value("discrepancy", json::object());
    const double voxelSize_m = discrepancy.value("voxel_size_m", PlanTarget().voxelSize_m);
    for (const json& entry : root.at("candidates")) {
        PlanTarget target;
        target.candidateId = entry.at("id").get<std::string>();
        target.centroid_map = pointOf(entry.at("centroid_map"));
        target.size_m = pointOf(entry.at("size"));
        target.voxelSize_m = voxelSize_m;
        if (!file.floorHeight_m) {
            file.floorHeight_m =
                pointOf(entry.at("centroid_reference")).z() - entry.at("height_above_floor").get<double>();
        }
        file.targets.push_back(std::move(target));
    }
    return file;
}

void appendDisc(const PlanTarget& target, std::vector<Eigen::Vector3d>& points_map) {
    constexpr double kStep_m = 0.02;
    const double radius_m = target.size_m.head<2>().maxCoeff() / 2.0;
    const int steps = static_cast<int>(std::ceil(radius_m / kStep_m));
    for (int row = -steps; row <= steps; ++row) {
        for (int column = -steps; column <= steps; ++column) {
            const Eigen::Vector3d offset(column * kStep_m, row * kStep_m, 0.0);
            if (offset.norm() <= radius_m) points_map.push_back(target.centroid_map + offset);
        }
    }
}

}  // namespace

CandidatesFile readCandidatesFile(const std::filesystem::path& file) {
    const std::string subject = file.string();
    const Error otherFile(subject, "is no candidates file (fodscope.candidates/1)", "give the file that detect wrote");
    try {
        const json root = json::parse(readTextFile(file));
        if (root.at("schema") != "fodscope.candidates/1") throw otherFile;
        return parsed(root, subject);
    } catch (const json::exception&) {
        throw otherFile;
    }
}

std::vector<Eigen::Vector3d> addVoxels(CandidatesFile& candidates, const std::filesystem::path& file) {
    std::vector<Eigen::Vector3d> points_map;
    const std::filesystem::path cloud = file.parent_path() / "discrepancy.ply";
    if (!std::filesystem::exists(cloud)) {
        for (PlanTarget& target : candidates.targets) {
            appendDisc(target, points_map);
            // Which way its length points is not in the file, so it may reach as far across.
            target.size_m.y() = target.size_m.x();
        }
        return points_map;
    }
    const Transform T_map_from_reference = candidates.T_reference_from_map.inverse();
    std::map<int, PlanTarget*> targetOf;
    for (PlanTarget& target : candidates.targets)
        targetOf[candidateNumber(target.candidateId)] = &target;
    for (const DiscrepantVoxel& voxel : readDiscrepantVoxels(cloud, candidates.threshold)) {
        points_map.push_back(T_map_from_reference * voxel.point_reference);
        const auto target = targetOf.find(voxel.candidate);
        if (voxel.candidate < 0 || target == targetOf.end()) continue;
        target->second->voxels.emplace_back(points_map.back().x(), points_map.back().y(),
                                            voxel.point_reference.z() - *candidates.floorHeight_m);
    }
    return points_map;
}

}  // namespace fodscope::cli
