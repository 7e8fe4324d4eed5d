// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/simulation/World.h"

namespace fodscope {

/// −1 is the structure; n ≥ 0 the n-th object of the world.
struct RayHit {
    double distance_m = 0.0;
    int object = -1;
    Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();
    Rgb colour;
};

/// Ray casting in a world (Embree). Safe to use from several threads.
class Raycaster {
  public:
    explicit Raycaster(const World& world);
    ~Raycaster();
    Raycaster(Raycaster&&) noexcept;

    std::optional<RayHit> cast(const Eigen::Vector3d& origin_world, const Eigen::Vector3d& direction_world,
                               double range_m) const;

  private:
    struct Scene;
    std::unique_ptr<Scene> scene_;
};

}  // namespace fodscope
