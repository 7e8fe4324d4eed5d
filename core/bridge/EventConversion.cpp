// SPDX-License-Identifier: MIT
#include "core/bridge/EventConversion.h"

#include <bit>
#include <cmath>

#include "core/common/Error.h"

namespace fodscope::bridge {
namespace {

/// As map_saver does it.
constexpr int kOccupiedFrom = 65;
constexpr int kFreeBelow = 25;
constexpr int kLethal = 100;

Cell cellOf(int value, bool isCostMap) {
    if (value < 0) return Cell::Unknown;
    // What is less than an obstacle is its surroundings, which planning makes anew.
    if (isCostMap) return value >= kLethal ? Cell::Occupied : Cell::Free;
    if (value >= kOccupiedFrom) return Cell::Occupied;
    return value < kFreeBelow ? Cell::Free : Cell::Unknown;
}

double floatAt(const Bytes& bytes, std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i)
        word |= std::uint32_t{bytes[at + i]} << (8 * i);
    return std::bit_cast<float>(word);
}

}  // namespace

std::shared_ptr<const PointCloud> pointCloudOf(const MapCloud& map) {
    const std::size_t count = map.points.size() / 12;
    const bool fits =
        map.points.size() % 12 == 0 && count > 0 && (map.colours.empty() || map.colours.size() == count * 3);
    if (!fits) throw Error("map of the robot", "its points and bytes do not match", "fetch it again");
    auto cloud = std::make_shared<PointCloud>();
    cloud->droppedNonFinite = map.dropped;
    cloud->points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Eigen::Vector3d point(floatAt(map.points, 12 * i), floatAt(map.points, 12 * i + 4),
                                    floatAt(map.points, 12 * i + 8));
        if (!point.allFinite()) throw Error("map of the robot", "a point is not finite", "fetch it again");
        cloud->points.push_back(point);
        if (!map.colours.empty())
            cloud->colours.push_back({map.colours[3 * i], map.colours[3 * i + 1], map.colours[3 * i + 2]});
    }
    return cloud;
}

OccupancyGrid occupancyGridOf(const Grid& message) {
    const std::uint64_t count = std::uint64_t{message.width} * message.height;
    if (static_cast<double>(count) > kGreatestCellCount || message.cells.size() != count)
        throw Error("grid of the robot", "its cells do not fill it", "fetch it again");
    OccupancyGrid grid;
    grid.width = static_cast<int>(message.width);
    grid.height = static_cast<int>(message.height);
    grid.resolution_m = message.resolution_m;
    grid.origin_map = {message.origin_map.x_m, message.origin_map.y_m, message.origin_map.yaw_rad};
    grid.cells.reserve(message.cells.size());
    for (const std::uint8_t value : message.cells)
        grid.cells.push_back(cellOf(static_cast<std::int8_t>(value), message.isCostMap));
    requireUsable(grid);
    return grid;
}

fodscope::Photo photoOf(PhotoTaken message) {
    fodscope::Photo photo;
    photo.taken = {message.stamp_ns / 1'000'000};
    photo.T_map_from_camera = transformFromRows(message.T_map_from_camera, "photo of the robot");
    photo.intrinsics = {message.width_px, message.height_px, message.fx_px,
                        message.fy_px,    message.cx_px,     message.cy_px};
    const auto* first = reinterpret_cast<const std::byte*>(message.picture.data());
    photo.bytes.assign(first, first + message.picture.size());
    return photo;
}

RobotState robotStateOf(const State& message, double measuredAgo_s, double now_s) {
    RobotState state;
    switch (message.link) {
        case Link::Connecting:
            state.link = LinkState::Connecting;
            break;
        case Link::Connected:
            state.link = LinkState::Connected;
            break;
        case Link::Lost:
            state.link = LinkState::Lost;
            break;
    }
    if (message.pose_map) {
        state.pose_map = Pose2{message.pose_map->x_m, message.pose_map->y_m, message.pose_map->yaw_rad};
        state.poseMeasured_s = now_s - measuredAgo_s - message.poseAge_s;
    }
    // A goal under way means moving as long as odometry does not say otherwise.
    state.moving = message.moving.value_or(message.goalId.has_value());
    state.goalId = message.goalId;
    state.distanceLeft_m = message.distanceLeft_m;
    state.clockOffset_s = message.clockAhead_s;
    return state;
}

GoalFailure failureOf(GoalProblem problem) {
    switch (problem) {
        case GoalProblem::Rejected:
            return GoalFailure::Rejected;
        case GoalProblem::Aborted:
            return GoalFailure::Aborted;
        case GoalProblem::Preempted:
            return GoalFailure::Preempted;
        case GoalProblem::NotAcknowledged:
            return GoalFailure::NotAcknowledged;
        case GoalProblem::LinkLost:
            return GoalFailure::LinkLost;
        case GoalProblem::StopRequested:
            return GoalFailure::StopRequested;
    }
    return GoalFailure::LinkLost;
}

PhotoFailure failureOf(PhotoProblem problem) {
    switch (problem) {
        case PhotoProblem::Missing:
            return PhotoFailure::Missing;
        case PhotoProblem::Corrupt:
            return PhotoFailure::Corrupt;
        case PhotoProblem::TimedOut:
            return PhotoFailure::TimedOut;
    }
    return PhotoFailure::Missing;
}

}  // namespace fodscope::bridge
