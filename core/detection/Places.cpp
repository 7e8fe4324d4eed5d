// SPDX-License-Identifier: MIT
#include "core/detection/Places.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <string>

#include "core/common/Error.h"

namespace fodscope {
namespace {

std::uint64_t hashOf(const Eigen::Vector3d& point) {
    std::uint64_t hash = 0;
    for (const double coordinate : {point.x(), point.y(), point.z()}) {
        // Negative zero is the same place.
        hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate + 0.0)) * 0x9E3779B97F4A7C15u;
        hash ^= hash >> 32;
    }
    return hash;
}

}  // namespace

void requireFinite(std::span<const Eigen::Vector3d> points) {
    if (points.size() > std::numeric_limits<std::uint32_t>::max()) {
        throw Error("points to cluster", "are more than 4 billion", "raise the threshold");
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].allFinite()) continue;
        throw Error("points to cluster", "number " + std::to_string(i) + " has a coordinate that is not finite",
                    "drop such points first");
    }
}

Places placesOf(std::span<const Eigen::Vector3d> points) {
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    Places places;
    places.clusters.reserve(points.size());
    std::vector<std::uint32_t> table(std::bit_ceil(2 * points.size()), none);
    const std::uint64_t mask = table.size() - 1;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        std::uint64_t at = hashOf(points[i]) & mask;
        while (table[at] != none && places.clusters[table[at]].centroid != points[i])
            at = (at + 1) & mask;
        if (table[at] == none) {
            table[at] = static_cast<std::uint32_t>(places.clusters.size());
            places.clusters.push_back({points[i], i, 1});
        } else {
            LivingCluster& place = places.clusters[table[at]];
            ++place.count;
            places.merges.push_back({place.id, i, 0.0});
        }
    }
    // The pair with the lowest first point goes first.
    std::ranges::stable_sort(places.merges, {}, &Merge::kept);
    return places;
}

}  // namespace fodscope
