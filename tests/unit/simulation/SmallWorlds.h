// SPDX-License-Identifier: MIT
#pragma once

#include "core/simulation/MeshShapes.h"
#include "core/simulation/World.h"

namespace fodscope::test {

/// A closed room seen from inside, with the floor at z = 0.
inline World room(double length_m = 3.0, double width_m = 2.0, double height_m = 1.0) {
    World world;
    world.name = "room";
    world.structure = boxMesh({0.0, 0.0, 0.0}, {length_m, width_m, height_m}, {200, 200, 190});
    world.robotStart_world = {0.5 * length_m, 0.5 * width_m, 0.0};
    return world;
}

inline WorldObject boxObject(const Eigen::Vector3d& low, const Eigen::Vector3d& high, Rgb colour = {200, 30, 30}) {
    WorldObject object;
    object.type = "box";
    object.fod = true;
    object.mesh = boxMesh(low, high, colour);
    object.centroid_world = 0.5 * (low + high);
    return object;
}

}  // namespace fodscope::test
