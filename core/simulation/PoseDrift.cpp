// SPDX-License-Identifier: MIT
#include "core/simulation/PoseDrift.h"

#include <array>
#include <cmath>

#include "core/simulation/Random.h"

namespace fodscope {

std::vector<Transform> withDrift(const std::vector<Transform>& poses_world, const DepthMappingSettings& settings) {
    Random random(streamSeed(settings.seed, 11));
    // x, y, z, roll, pitch, yaw.
    const std::array<double, 6> deviation{settings.driftXy_m,          settings.driftXy_m,
                                          settings.driftZ_m,           settings.driftRollPitch_rad,
                                          settings.driftRollPitch_rad, settings.driftYaw_rad};
    std::array<double, 6> error{};
    for (std::size_t i = 0; i < error.size(); ++i)
        error[i] = deviation[i] * random.normal();
    std::vector<Transform> believed;
    believed.reserve(poses_world.size());
    for (std::size_t k = 0; k < poses_world.size(); ++k) {
        if (k > 0) {
            const double way_m = (poses_world[k].translation() - poses_world[k - 1].translation()).norm();
            const double turn_rad =
                Eigen::AngleAxisd(poses_world[k - 1].linear().transpose() * poses_world[k].linear()).angle();
            // Turning on the spot loses the SLAM as driving does.
            const double kept = std::exp(-(way_m + 0.15 * turn_rad) / settings.driftLength_m);
            for (std::size_t i = 0; i < error.size(); ++i)
                error[i] = kept * error[i] + deviation[i] * std::sqrt(1.0 - kept * kept) * random.normal();
        }
        const Eigen::Matrix3d turn = (Eigen::AngleAxisd(error[5], Eigen::Vector3d::UnitZ()) *
                                      Eigen::AngleAxisd(error[4], Eigen::Vector3d::UnitY()) *
                                      Eigen::AngleAxisd(error[3], Eigen::Vector3d::UnitX()))
                                         .toRotationMatrix();
        Transform pose = poses_world[k];
        pose.linear() = turn * pose.linear();
        pose.translation() += Eigen::Vector3d(error[0], error[1], error[2]);
        believed.push_back(pose);
    }
    return believed;
}

}  // namespace fodscope
