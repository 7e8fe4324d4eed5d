// SPDX-License-Identifier: MIT
#include "core/simulation/BuiltinTank.h"

#include <cmath>

#include "core/common/Error.h"
#include "core/simulation/TankParts.h"

namespace fodscope {
namespace {

void requireRange(const char* what, double value, double low, double high) {
    if (value >= low && value <= high) return;
    throw Error("built-in tank", std::string(what) + " of " + std::to_string(value) + " m is out of range",
                "choose " + std::to_string(low) + " to " + std::to_string(high) + " m");
}

TriangleMesh structureOf(const BuiltinTankSettings& settings, double deviation_m) {
    requireRange("a length", settings.length_m, 2.0, 12.0);
    requireRange("a width", settings.width_m, 2.0, 12.0);
    requireRange("a height", settings.height_m, 0.7, 4.0);
    requireRange("an as-built deviation", deviation_m, 0.0, 0.05);
    TankPlan plan(settings, deviation_m);
    TriangleMesh mesh = tankHull(plan);
    append(mesh, tankFraming(plan));
    append(mesh, tankFittings(plan));
    if (plan.asBuilt) append(mesh, tankAdditions(plan));
    return mesh;
}

}  // namespace

TriangleMesh builtinTankCad(const BuiltinTankSettings& settings) {
    TriangleMesh mesh = structureOf(settings, 0.0);
    mesh.colours.clear();
    return mesh;
}

World builtinWorld(const BuiltinTankSettings& settings) {
    World world;
    world.name = "built-in tank";
    world.structure = structureOf(settings, settings.asBuiltDeviation_m);
    // Under the access hole, where the robot is let down, looking along the tank.
    world.robotStart_world = {0.22 * settings.length_m, 0.23 * settings.width_m, radiansFromDegrees(60.0)};
    return world;
}

}  // namespace fodscope
