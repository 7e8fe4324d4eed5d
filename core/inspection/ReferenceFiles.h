// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/reference/CadReference.h"
#include "core/reference/MeanReference.h"
#include "core/registration/Registration.h"

namespace fodscope {

/// How a mean reference is to be made from files of nominal maps.
struct NominalMapsRequest {
    std::vector<std::filesystem::path> maps;
    /// A mesh or a map into whose frame the nominal maps are moved; empty: that of the first of them.
    std::optional<std::filesystem::path> alignTo;
    /// Metres in one unit of that mesh.
    double meshScale = 1.0;
    /// T_reference_from_map of each map, in their order; they replace the registration. Empty: the maps are registered.
    std::vector<Transform> given_T_reference_from_map;
    /// Known start poses of the registration, one for each map in their order. Empty: all poses are searched.
    std::vector<Transform> start_T_reference_from_map;
    MeanReferenceSettings mean;
    RegistrationSettings registration;
};

/// Reads the maps, moves them into one frame and makes their mean reference. How each map lies goes into the
/// provenance.
/// @throws Error naming the file that cannot be used, among them a map that cannot be aligned; Cancelled
ReferenceMap referenceFromMapFiles(const NominalMapsRequest& request, Progress& progress);

/// The same maps give a CAD reference its covariances: its points are samples of the mesh, and the scatter is that of
/// the maps' points about the nearest of them. The maps are moved onto the mesh, whatever their `alignTo`; the voxels
/// of the mean play no part.
/// @throws Error naming the file; Cancelled
ReferenceMap referenceFromMeshAndMapFiles(const std::filesystem::path& mesh, const CadReferenceSettings& settings,
                                          const NominalMapsRequest& maps, Progress& progress);

/// Reads a mesh and samples it; such a reference has no covariances.
/// @throws Error naming the file; Cancelled
ReferenceMap referenceFromMeshFile(const std::filesystem::path& mesh, double scale,
                                   const CadReferenceSettings& settings, Progress& progress);

}  // namespace fodscope
