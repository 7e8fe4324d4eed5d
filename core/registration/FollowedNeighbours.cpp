// SPDX-License-Identifier: MIT
#include "core/registration/FollowedNeighbours.h"

#include <cmath>
#include <limits>

#include "core/registration/OrderedSum.h"

namespace fodscope {
namespace {

/// Of the distances: far more than their rounding.
constexpr double kRounding = 1e-12;
constexpr std::size_t kMostToSearchAlone = 20'000;

double slack_m2(std::span<const Neighbour> nearestTwo) {
    if (nearestTwo.size() < 2) return std::numeric_limits<double>::infinity();
    const double second_m = std::sqrt(nearestTwo[1].squaredDistance_m2);
    const double slack_m = (second_m - std::sqrt(nearestTwo[0].squaredDistance_m2)) / 2.0 - kRounding * second_m;
    return slack_m > 0.0 ? slack_m * slack_m : -1.0;
}

/// With NeighbourIndex's operations in its order, for its bits.
double squaredDistance_m2(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const double x = a.x() - b.x();
    const double y = a.y() - b.y();
    const double z = a.z() - b.z();
    return x * x + y * y + z * z;
}

}  // namespace

std::span<const Neighbour> FollowedNeighbours::nearestOf(std::span<const Eigen::Vector3d> queries, Progress& progress) {
    known_.resize(queries.size());
    nearest_.resize(queries.size());
    search(queries, followed(queries), progress);
    return nearest_;
}

/// @return the queries that moved too far, ascending
std::vector<std::uint32_t> FollowedNeighbours::followed(std::span<const Eigen::Vector3d> queries) {
    std::vector<std::vector<std::uint32_t>> lostOfParts((queries.size() + kPart - 1) / kPart);
    forEachPart(queries.size(), [&](std::size_t begin, std::size_t end, std::size_t part) {
        for (std::size_t i = begin; i < end; ++i) {
            if (squaredDistance_m2(queries[i], known_[i].place) < known_[i].slack_m2) {
                nearest_[i].squaredDistance_m2 = squaredDistance_m2(targets_[nearest_[i].index], queries[i]);
            } else {
                lostOfParts[part].push_back(static_cast<std::uint32_t>(i));
            }
        }
    });
    std::vector<std::uint32_t> lost;
    for (const std::vector<std::uint32_t>& some : lostOfParts)
        lost.insert(lost.end(), some.begin(), some.end());
    return lost;
}

void FollowedNeighbours::search(std::span<const Eigen::Vector3d> queries, std::span<const std::uint32_t> lost,
                                Progress& progress) {
    const auto keep = [&](std::uint32_t i, std::span<const Neighbour> found) {
        known_[i] = {queries[i], slack_m2(found)};
        nearest_[i] = found.front();
    };
    // Few points lie far apart: searching them in groups of neighbours would gain nothing.
    if (lost.size() <= kMostToSearchAlone) {
        forEachPart(lost.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
            for (const std::uint32_t i : lost.subspan(begin, end - begin))
                keep(i, index_.kNearest(queries[i], 2));
        });
        return;
    }
    std::vector<Eigen::Vector3d> places;
    places.reserve(lost.size());
    for (const std::uint32_t i : lost)
        places.push_back(queries[i]);
    index_.forEachKNearest(
        places, 2, [&](std::size_t k, std::span<const Neighbour> found) { keep(lost[k], found); }, progress);
}

}  // namespace fodscope
