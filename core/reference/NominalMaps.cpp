// SPDX-License-Identifier: MIT
#include "core/reference/NominalMaps.h"

#include <algorithm>
#include <sstream>

#include "core/common/Error.h"

namespace fodscope {

std::vector<Eigen::Vector3d> samplesOf(std::span<const AlignedNominalMap> maps, const OutlierRemovalSettings& denoise,
                                       Progress& progress) {
    if (maps.empty()) throw Error("reference", "no nominal maps were given", "give at least one map without FOD");
    std::vector<Eigen::Vector3d> samples;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const std::vector<Eigen::Vector3d>& points = maps[i].map->points;
        const std::string stage =
            "denoising nominal map " + std::to_string(i + 1) + " of " + std::to_string(maps.size());
        std::vector<std::uint32_t> found;
        if (maps[i].kept == nullptr) found = keptByOutlierRemoval(points, denoise, progress, stage);
        for (const std::uint32_t kept : maps[i].kept == nullptr ? found : *maps[i].kept)
            samples.push_back(maps[i].T_reference_from_map * points[kept]);
    }
    if (samples.empty()) {
        throw Error("reference", "the nominal maps hold no points after denoising", "give maps with points");
    }
    requireFiniteSamples(samples);
    return samples;
}

void requireFiniteSamples(std::span<const Eigen::Vector3d> samples) {
    if (std::ranges::all_of(samples, [](const Eigen::Vector3d& sample) { return sample.allFinite(); })) return;
    throw Error("reference", "a coordinate of the nominal maps is not finite", "drop such points first");
}

std::string provenanceOf(const OutlierRemovalSettings& denoise) {
    if (!denoise.enabled) return "denoise off";
    std::ostringstream text;
    text << "denoise neighbours " << denoise.neighbours << " standard_deviations " << denoise.standardDeviations;
    return text.str();
}

}  // namespace fodscope
