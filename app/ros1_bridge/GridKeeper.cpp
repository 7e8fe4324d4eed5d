// SPDX-License-Identifier: MIT
#include "app/ros1_bridge/GridKeeper.h"

#include <algorithm>
#include <cmath>

#include "core/common/Error.h"

namespace fodscope::bridge {
namespace {

constexpr std::uint64_t kGreatestCellCount = 100'000'000;

[[noreturn]] void refuse(const std::string& problem) {
    throw Error("grid", problem, "check what publishes it");
}

}  // namespace

void GridKeeper::take(const GridMessage& message) {
    const std::uint64_t count = std::uint64_t{message.width} * message.height;
    if (count == 0) refuse("it has no cells");
    if (count > kGreatestCellCount) refuse("it claims to have " + std::to_string(count) + " cells");
    if (message.cells.size != count) refuse("its cells do not fill it");
    if (!std::isfinite(message.resolution_m) || message.resolution_m <= 0.0) refuse("its cells have no size");
    T_frame_from_origin_ = rowsOfPose(message.origin, "grid");
    frame_ = message.frame;
    grid_.width = message.width;
    grid_.height = message.height;
    grid_.resolution_m = message.resolution_m;
    grid_.cells.assign(message.cells.data, message.cells.data + message.cells.size);
}

void GridKeeper::apply(const GridUpdateMessage& update) {
    if (!isThere()) return;
    const std::uint64_t count = std::uint64_t{update.width} * update.height;
    const bool fits = update.x >= 0 && update.y >= 0 && std::uint64_t(update.x) + update.width <= grid_.width &&
                      std::uint64_t(update.y) + update.height <= grid_.height;
    if (!fits) refuse("an update reaches over its edge");
    if (update.cells.size != count) refuse("an update's cells do not fill it");
    for (std::uint32_t row = 0; row < update.height; ++row) {
        const std::uint8_t* from = update.cells.data + std::size_t{row} * update.width;
        const std::size_t to = (std::size_t(update.y) + row) * grid_.width + std::size_t(update.x);
        std::copy(from, from + update.width, grid_.cells.begin() + static_cast<std::ptrdiff_t>(to));
    }
}

Grid GridKeeper::grid(const std::optional<Rows>& T_map_from_grid) const {
    Grid grid = grid_;
    grid.origin_map =
        planarPartOf(T_map_from_grid ? product(*T_map_from_grid, T_frame_from_origin_) : T_frame_from_origin_);
    return grid;
}

Rows rowsOfPose(const std::array<double, 7>& pose, const std::string& subject) {
    const bool isFinite = std::all_of(pose.begin(), pose.end(), [](double value) { return std::isfinite(value); });
    const double norm = std::sqrt(pose[3] * pose[3] + pose[4] * pose[4] + pose[5] * pose[5] + pose[6] * pose[6]);
    // Some publishers leave the orientation out, which means none.
    const bool isUnset = isFinite && norm == 0.0;
    if (!isFinite || (!isUnset && std::abs(norm - 1.0) > 0.01))
        throw Error(subject, "its pose is no pose", "check what publishes it");
    const double x = isUnset ? 0.0 : pose[3] / norm;
    const double y = isUnset ? 0.0 : pose[4] / norm;
    const double z = isUnset ? 0.0 : pose[5] / norm;
    const double w = isUnset ? 1.0 : pose[6] / norm;
    return {1 - 2 * (y * y + z * z),
            2 * (x * y - z * w),
            2 * (x * z + y * w),
            pose[0],
            2 * (x * y + z * w),
            1 - 2 * (x * x + z * z),
            2 * (y * z - x * w),
            pose[1],
            2 * (x * z - y * w),
            2 * (y * z + x * w),
            1 - 2 * (x * x + y * y),
            pose[2],
            0,
            0,
            0,
            1};
}

Rows product(const Rows& first, const Rows& second) {
    Rows result{};
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column)
            for (std::size_t i = 0; i < 4; ++i)
                result[row * 4 + column] += first[row * 4 + i] * second[i * 4 + column];
    return result;
}

PlanarPose planarPartOf(const Rows& transform) {
    return {transform[3], transform[7], std::atan2(transform[4], transform[0])};
}

}  // namespace fodscope::bridge
