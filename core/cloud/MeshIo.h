// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/cloud/TriangleMesh.h"

namespace fodscope {

/// Reads STL (ascii or binary), PLY (ascii or binary, polygons are fanned into triangles) or OBJ (v and f; polygons are
/// fanned), by content. Coordinates are multiplied by `scale` to become metres.
/// @throws Error for a file that is missing, truncated, no mesh, has no triangle, an index out of range or a vertex
/// that
///         is not finite
TriangleMesh readMesh(const std::filesystem::path& file, double scale = 1.0);

/// Writes by the extension: .ply (binary, with colours where there are any), .stl (binary) or .obj.
/// @throws Error when the file cannot be written or the extension is none of these
void writeMesh(const std::filesystem::path& file, const TriangleMesh& mesh);

/// @return whether the file holds triangles (a PLY with faces, STL, OBJ); false also for a file that cannot be read
bool isMeshFile(const std::filesystem::path& file);

}  // namespace fodscope
