// SPDX-License-Identifier: MIT
#include "core/simulation/MapVoxels.h"

#include <algorithm>
#include <cmath>

namespace fodscope {

Rgb MapVoxels::Voxel::colour() const {
    const auto channel = [&](int i) {
        return static_cast<std::uint8_t>(std::clamp(std::lround(colourSum[i] / count), 0L, 255L));
    };
    return {channel(0), channel(1), channel(2)};
}

void MapVoxels::add(const Eigen::Vector3d& point, Rgb colour, std::int32_t object) {
    constexpr double kFarthest = 1 << 20;
    const Eigen::Vector3d cell = (point / size_m_).array().floor();
    if (!(cell.cwiseAbs().maxCoeff() < kFarthest)) return;
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
        key = (key << 21) | static_cast<std::uint64_t>(static_cast<std::int64_t>(cell[axis]) + (1 << 20));
    const auto [place, isNew] = places_.try_emplace(key, static_cast<std::uint32_t>(voxels_.size()));
    if (isNew) voxels_.emplace_back();
    Voxel& voxel = voxels_[place->second];
    voxel.sum += point;
    voxel.colourSum += Eigen::Vector3d(colour.red, colour.green, colour.blue);
    ++voxel.count;
    if (voxel.votes == 0) voxel.object = object;
    if (voxel.object == object)
        ++voxel.votes;
    else
        --voxel.votes;
}

std::vector<MapVoxels::Voxel> MapVoxels::sorted() const {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order(places_.begin(), places_.end());
    std::sort(order.begin(), order.end());
    std::vector<Voxel> result;
    result.reserve(order.size());
    for (const auto& entry : order)
        result.push_back(voxels_[entry.second]);
    return result;
}

}  // namespace fodscope
