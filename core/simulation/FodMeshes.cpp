// SPDX-License-Identifier: MIT
#include <array>
#include <utility>

#include "core/common/Error.h"
#include "core/simulation/BuiltinTank.h"
#include "core/simulation/FodShapes.h"
#include "core/simulation/MeshShapes.h"

namespace fodscope {
namespace {

using Maker = TriangleMesh (*)(Random&);

const std::array<std::pair<const char*, Maker>, 8> kMakers{{{"hammer", hammerMesh},
                                                            {"drill", drillMesh},
                                                            {"tape measure", tapeMeasureMesh},
                                                            {"screwdriver", screwdriverMesh},
                                                            {"sander", sanderMesh},
                                                            {"crimper", crimperMesh},
                                                            {"wrench", wrenchMesh},
                                                            {"level", levelMesh}}};

}  // namespace

TriangleMesh fodMesh(const std::string& type, std::uint64_t seed) {
    for (const auto& [name, make] : kMakers) {
        if (type != name) continue;
        Random random(streamSeed(seed, 0));
        TriangleMesh mesh = make(random);
        const Eigen::Vector3d centroid = surfaceCentroid(mesh);
        return translated(std::move(mesh), {-centroid.x(), -centroid.y(), -boundsOf(mesh).min().z()});
    }
    std::string known;
    for (const std::string& name : fodTypes())
        known += (known.empty() ? "" : ", ") + name;
    throw Error("simulation", "there is no FOD of type \"" + type + "\"", "choose one of " + known);
}

std::vector<std::string> fodTypes() {
    std::vector<std::string> types;
    for (const auto& entry : kMakers)
        types.emplace_back(entry.first);
    return types;
}

}  // namespace fodscope
