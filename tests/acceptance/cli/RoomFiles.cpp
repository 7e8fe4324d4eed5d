// SPDX-License-Identifier: MIT
#include "tests/acceptance/cli/RoomFiles.h"

#include <stdexcept>

#include "core/cloud/PointCloudIo.h"
#include "tests/unit/registration/SyntheticRoom.h"

namespace fodscope::test {
namespace {

PointCloud roomCloud(std::uint64_t seed) {
    PointCloud cloud;
    cloud.points = sample(roomPanels(), 700.0, 0.003, seed);
    return cloud;
}

}  // namespace

RoomFiles::RoomFiles() {
    std::vector<std::string> arguments{"reference", "--maps"};
    std::uint64_t seed = 11;
    for (const std::string& name : nominalMaps()) {
        writePointCloud(name, roomCloud(seed++));
        arguments.push_back(name);
    }
    arguments.insert(arguments.end(), {"--out", reference()});
    const Outcome outcome = runCli(arguments);
    if (outcome.exitCode != 0) throw std::runtime_error(outcome.err);

    PointCloud bare;
    bare.points = roomReference();
    writePointCloud(bareReference(), bare);
    PointCloud map = roomCloud(21);
    const auto box = sample(boxPanels({2.0, 1.2, 0}, {2.2, 1.4, 0.2}), 3000.0, 0.002, 31);
    map.points.insert(map.points.end(), box.begin(), box.end());
    for (Eigen::Vector3d& point : map.points)
        point = motion(1.0, {0.03, -0.02, 0.0}) * point;
    writePointCloud(this->map(), map);
}

std::vector<std::string> RoomFiles::nominalMaps() const {
    return {file("nominal_0.pcd"), file("nominal_1.pcd"), file("nominal_2.ply")};
}

const RoomFiles& roomFiles() {
    static const RoomFiles files;
    return files;
}

}  // namespace fodscope::test
