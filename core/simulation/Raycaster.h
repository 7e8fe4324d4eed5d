// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/simulation/World.h"

namespace fodscope {

struct RayHit {
    double distance_m = 0.0;
    /// −1 is the structure; n ≥ 0 the n-th object of the world.
    int object = -1;
    /// Unit, towards the ray's origin; round surfaces are interpolated over their facets.
    Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();
    /// The surface's paint, without light or rust.
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

    /// @return whether anything lies between the two points
    bool blocked(const Eigen::Vector3d& origin_world, const Eigen::Vector3d& target_world) const;

  private:
    struct Scene;
    std::unique_ptr<Scene> scene_;
};

}  // namespace fodscope
