// SPDX-License-Identifier: MIT
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/inspection/Inspection.h"
#include "core/inspection/JsonNumbers.h"

namespace fodscope {
namespace {

using Json = nlohmann::ordered_json;

/// The name without its folder: the same input gives the same text wherever it lies.
Json sourceJson(const SourceFile& source) {
    return {{"file", std::filesystem::path(source.path).filename().string()},
            {"points", source.points},
            {"sha256", source.sha256}};
}

Json settingsJson(const Parameters& parameters) {
    const CandidateSettings& candidates = parameters.candidates;
    const DiscrepancySettings& discrepancy = parameters.discrepancy;
    const OutlierRemovalSettings& denoise = parameters.denoise;
    Json cropHeight;
    if (discrepancy.cropHeight_m) cropHeight = rounded(*discrepancy.cropHeight_m);
    return {{"metric", candidates.metric == Metric::Mahalanobis ? "mahalanobis" : "euclidean"},
            {"threshold", rounded(candidates.threshold)},
            {"cluster_cutoff_m", rounded(candidates.clusterCutoff_m)},
            {"minimum_points", candidates.minimumPoints},
            {"centroid", candidates.centroid == CentroidKind::Plain ? "plain" : "discrepancy-weighted"},
            {"voxel_m", rounded(discrepancy.voxelSize_m)},
            {"smoothing_neighbours", discrepancy.smoothingNeighbours},
            {"crop_to_reference", discrepancy.cropToReference},
            {"crop_height_m", cropHeight},
            {"denoise", denoise.enabled},
            {"denoise_neighbours", denoise.neighbours},
            {"denoise_standard_deviations", rounded(denoise.standardDeviations)}};
}

Json registrationJson(const RegistrationResult& registration) {
    Json converged;
    if (registration.converged) converged = *registration.converged;
    return {{"quality", qualityWord(registration.quality)},
            {"converged", converged},
            {"rms_m", rounded(registration.rms_m)},
            {"overlap", rounded(registration.overlap)}};
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
        {"settings", settingsJson(detection.parameters)},
        {"T_reference_from_map", jsonTransform(detection.registration.T_reference_from_map)},
        {"registration", registrationJson(detection.registration)},
        {"points_above_threshold", detection.candidates ? detection.candidates->pointsAboveThreshold : 0},
        {"candidates", candidates}};
    return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace fodscope
