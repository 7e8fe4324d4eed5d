// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "core/cloud/PointCloud.h"
#include "core/inspection/InspectionState.h"
#include "core/reference/CadReference.h"
#include "core/reference/MeanReference.h"

namespace fodscope {

enum class ReferenceKind {
    Cad,         ///< a mesh, sampled
    CadAndMaps,  ///< a mesh, sampled, with covariances from maps without FOD
    Ready,       ///< a reference map made earlier, or any cloud without covariances
    NominalMaps  ///< maps without FOD: their mean, with covariances
};

/// What a reference map is to be made from.
struct ReferenceRequest {
    ReferenceKind kind = ReferenceKind::Ready;
    std::vector<std::filesystem::path> files;
    /// Those that give a mesh its covariances.
    std::vector<std::filesystem::path> covarianceMaps;
    /// Metres in one unit of the mesh.
    double meshScale = 1.0;
    /// How it is made: spacing, voxels, denoising, covariances, registration.
    Parameters parameters;
};

/// @return the request that the files themselves suggest: one mesh, a mesh with maps, one reference, or several maps
ReferenceRequest requestFor(const std::vector<std::filesystem::path>& files);

struct LoadedReference {
    SourceFile source;
    std::shared_ptr<const ReferenceMap> reference;
};

/// Reads the files and makes the reference map. For a worker thread.
/// @throws Error; Cancelled
LoadedReference makeReference(const ReferenceRequest& request, Progress& progress);

}  // namespace fodscope
