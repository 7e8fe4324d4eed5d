// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/cloud/TriangleMesh.h"
#include "core/common/Geometry.h"

namespace fodscope {

/// A thing in the world. Meshes are in the world frame.
struct WorldObject {
    std::string type;
    bool fod = false;
    TriangleMesh mesh;
    Eigen::Vector3d centroid_world = Eigen::Vector3d::Zero();
};

/// What the simulated robot drives in and photographs: a structure and objects, in the world frame (z up, metres).
struct World {
    std::string name;
    TriangleMesh structure;
    std::vector<WorldObject> objects;
    /// Takes world points to the frame of the map under inspection.
    Transform T_map_from_world = Transform::Identity();
    Pose2 robotStart_world;
};

/// Reads `fodscope.world/1`; meshes are found relative to the file.
/// @throws Error for a missing file, another schema, a missing key or mesh
World readWorld(const std::filesystem::path& file);

/// Writes NAME.json and its meshes into a folder NAME beside it.
void writeWorld(const std::filesystem::path& file, const World& world);

}  // namespace fodscope
