// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/cloud/TriangleMesh.h"
#include "core/simulation/World.h"

namespace fodscope {

/// A parametric steel tank of about 3 × 2.8 × 1 m: curved side shell, frames, stiffeners, an I-beam, a column, pipes
/// and an access hole. Floor at z = 0; x along the tank, z up.
struct BuiltinTankSettings {
    double length_m = 3.0;
    double width_m = 2.8;
    double height_m = 1.0;
    /// As-built parts are moved by up to this much from the CAD; 0 gives the CAD itself.
    double asBuiltDeviation_m = 0.02;
    std::uint64_t seed = 1;
};

/// The tank as drawn (its CAD mesh, without colours).
TriangleMesh builtinTankCad(const BuiltinTankSettings& settings);

/// The tank as built: moved parts, things the CAD does not have, painted and rusty (vertex colours), without FOD.
World builtinWorld(const BuiltinTankSettings& settings);

/// FOD of the paper at true size, lying on z = 0 with its centroid over the origin: hammer, drill, tape measure,
/// screwdriver, sander, crimper, wrench, level.
/// @throws Error for another type
TriangleMesh fodMesh(const std::string& type, std::uint64_t seed);
std::vector<std::string> fodTypes();

/// Puts 2 to 5 FOD of distinct types into a world by the paper's trial protocol: x and y uniform in the bounding box,
/// on the floor, else at the nearest interior place, random yaw.
void placeFod(World& world, std::uint64_t seed);

}  // namespace fodscope
