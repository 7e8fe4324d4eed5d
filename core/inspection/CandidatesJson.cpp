// SPDX-License-Identifier: MIT
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/inspection/Inspection.h"
#include "core/inspection/JsonNumbers.h"
#include "core/inspection/ParameterJson.h"

namespace fodscope {
namespace {

using Json = nlohmann::ordered_json;

/// The name without its folder: the same input gives the same text wherever it lies.
Json sourceJson(const SourceFile& source) {
    return {{"file", std::filesystem::path(source.path).filename().string()},
            {"points", source.points},
            {"sha256", source.sha256}};
}

/// Of an ambiguous alignment all poses, the best first: none of them is claimed.
std::vector<PoseAlternative> otherPoses(const RegistrationResult& registration) {
    std::vector<PoseAlternative> poses = registration.alternatives;
    if (registration.quality == RegistrationQuality::Ambiguous) {
        poses.insert(poses.begin(), {registration.T_reference_from_map, registration.rms_m, registration.overlap,
                                     registration.explained});
    }
    return poses;
}

Json registrationJson(const RegistrationResult& registration) {
    Json converged;
    if (registration.converged) converged = *registration.converged;
    return {{"quality", qualityWord(registration.quality)},
            {"converged", converged},
            {"rms_m", rounded(registration.rms_m)},
            {"overlap", rounded(registration.overlap)},
            {"explained", rounded(registration.explained)},
            {"alternatives", jsonAlternatives(otherPoses(registration))},
            {"uncertainty", jsonUncertainty(registration.uncertainty)}};
}

Json candidateJson(const Candidate& candidate) {
    return {{"id", candidate.id},
            {"points", candidate.voxels.size()},
            {"centroid_reference", jsonPoint(candidate.centroid_reference)},
            {"centroid_map", jsonPoint(candidate.centroid_map)},
            {"size", jsonPoint(candidate.size_m)},
            {"height_above_floor", rounded(candidate.heightAboveFloor_m)},
            {"discrepancy_max", rounded(candidate.discrepancyMax)},
            {"discrepancy_mean", rounded(candidate.discrepancyMean)}};
}

std::vector<std::string> settingsThatCount(const Parameters& parameters) {
    std::vector<std::string> sections{"denoise", "registration", "discrepancy", "candidates"};
    if (parameters.candidates.metric == Metric::ChiSquare) sections.insert(sections.end() - 1, "chi_square");
    return sections;
}

}  // namespace

std::string candidatesJson(const SourceFile& reference, const SourceFile& map, const DetectionRecord& detection) {
    Json candidates = Json::array();
    if (detection.candidates) {
        for (const Candidate& candidate : detection.candidates->candidates) {
            candidates.push_back(candidateJson(candidate));
        }
    }
    const Json root = {
        {"schema", "fodscope.candidates/1"},
        {"reference", sourceJson(reference)},
        {"map", sourceJson(map)},
        {"settings", jsonParameters(detection.parameters, settingsThatCount(detection.parameters))},
        {"T_reference_from_map", isTrusted(detection.registration.quality)
                                     ? jsonTransform(detection.registration.T_reference_from_map)
                                     : Json(nullptr)},
        {"registration", registrationJson(detection.registration)},
        {"points_above_threshold", detection.candidates ? detection.candidates->pointsAboveThreshold : 0},
        {"candidates", candidates}};
    return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace fodscope
