// SPDX-License-Identifier: MIT
#include "core/inspection/ReferenceFiles.h"

#include <utility>

#include "core/cloud/MeshIo.h"
#include "core/cloud/PointCloudIo.h"
#include "core/cloud/UnitCheck.h"
#include "core/cloud/VoxelGrid.h"
#include "core/common/Error.h"

namespace fodscope {
namespace {

/// Samples of a mesh that maps are aligned with: dense enough that their voxel means lie on its surfaces.
constexpr double kAlignmentSpacing_m = 0.015;
constexpr double kAlignmentVoxel_m = 0.03;

/// A nominal map with what is known of it so far.
struct NominalMap {
    PointCloud cloud;
    std::vector<std::uint32_t> kept;
    Transform T_reference_from_map = Transform::Identity();
    std::string alignment;
};

/// Runs a step whose stages are told with the map that they work on.
template <typename Step>
auto forMap(std::size_t map, std::size_t count, Progress& progress, const Step& step) {
    Progress inner([&](const std::string& stage, double fraction) {
        progress.report("map " + std::to_string(map + 1) + " of " + std::to_string(count) + ": " + stage, fraction);
    });
    progress.throwIfCancelled();
    return step(inner);
}

PointCloud readUsableCloud(const std::filesystem::path& file) {
    PointCloud cloud = readPointCloud(file);
    requireUsableCloud(cloud.points, file.string());
    return cloud;
}

std::vector<Eigen::Vector3d> pointsOf(const NominalMap& map) {
    std::vector<Eigen::Vector3d> points;
    points.reserve(map.kept.size());
    for (const std::uint32_t index : map.kept)
        points.push_back(map.cloud.points[index]);
    return points;
}

std::vector<Eigen::Vector3d> meshPoints(const std::filesystem::path& file, double scale, Progress& progress) {
    const ReferenceMap samples = referenceFromMeshFile(file, scale, {kAlignmentSpacing_m, 1}, progress);
    return voxelGrid(samples.points, minimumCorner(samples.points), {kAlignmentVoxel_m}).points;
}

/// @return the points that all maps are aligned with
std::vector<Eigen::Vector3d> alignmentTarget(const NominalMapsRequest& request, const NominalMap& first,
                                             Progress& progress) {
    if (!request.alignTo) return pointsOf(first);
    if (isMeshFile(*request.alignTo)) return meshPoints(*request.alignTo, request.meshScale, progress);
    return readUsableCloud(*request.alignTo).points;
}

void align(NominalMap& map, const std::filesystem::path& file, std::span<const Eigen::Vector3d> target,
           const std::optional<Transform>& start, const RegistrationSettings& settings, Progress& progress) {
    const RegistrationResult result = registerMap(pointsOf(map), target, start, settings, progress);
    if (!isTrusted(result.quality)) {
        throw Error(file.string(), result.summary.substr(0, result.summary.find("; ")),
                    "leave it out, or give the maps' start poses or transforms");
    }
    map.T_reference_from_map = result.T_reference_from_map;
    map.alignment = result.summary;
}

void alignAll(const NominalMapsRequest& request, std::vector<NominalMap>& maps, Progress& progress) {
    if (!request.given_T_reference_from_map.empty()) {
        for (std::size_t i = 0; i < maps.size(); ++i) {
            maps[i].T_reference_from_map = request.given_T_reference_from_map[i];
            maps[i].alignment = "transform given";
        }
        return;
    }
    const std::vector<Eigen::Vector3d> target = alignmentTarget(request, maps.front(), progress);
    for (std::size_t i = 0; i < maps.size(); ++i) {
        if (!request.alignTo && i == 0) {
            maps[i].alignment = "its frame is the reference's";
            continue;
        }
        std::optional<Transform> start;
        if (!request.start_T_reference_from_map.empty()) start = request.start_T_reference_from_map[i];
        forMap(i, maps.size(), progress,
               [&](Progress& inner) { align(maps[i], request.maps[i], target, start, request.registration, inner); });
    }
}

void requireConsistent(const NominalMapsRequest& request) {
    if (request.maps.empty()) throw Error("reference", "no nominal maps were given", "give at least one map");
    const auto requireOneEach = [&](const std::string& subject, std::size_t given) {
        if (given == 0 || given == request.maps.size()) return;
        throw Error(subject, std::to_string(given) + " are given for " + std::to_string(request.maps.size()) + " maps",
                    "give one for each map, in their order");
    };
    requireOneEach("transforms", request.given_T_reference_from_map.size());
    requireOneEach("start poses", request.start_T_reference_from_map.size());
}

/// Reads, denoises and aligns the maps.
std::vector<NominalMap> readNominalMaps(const NominalMapsRequest& request, Progress& progress) {
    requireConsistent(request);
    std::vector<NominalMap> maps(request.maps.size());
    // All files are read before the long work begins, so that a bad one is told at once.
    for (std::size_t i = 0; i < maps.size(); ++i) {
        progress.report("reading the maps", static_cast<double>(i) / static_cast<double>(maps.size()));
        maps[i].cloud = readUsableCloud(request.maps[i]);
    }
    for (std::size_t i = 0; i < maps.size(); ++i) {
        maps[i].kept = forMap(i, maps.size(), progress, [&](Progress& inner) {
            return keptByOutlierRemoval(maps[i].cloud.points, request.mean.denoise, inner);
        });
        if (maps[i].kept.empty()) {
            throw Error(request.maps[i].string(), "has no points left after outlier removal", "leave it out");
        }
    }
    alignAll(request, maps, progress);
    return maps;
}

std::vector<AlignedNominalMap> aligned(const std::vector<NominalMap>& maps) {
    std::vector<AlignedNominalMap> aligned;
    for (const NominalMap& map : maps)
        aligned.push_back({&map.cloud, map.T_reference_from_map, &map.kept});
    return aligned;
}

void tellAlignment(const NominalMapsRequest& request, const std::vector<NominalMap>& maps, ReferenceMap& reference) {
    for (std::size_t i = 0; i < maps.size(); ++i) {
        reference.provenance.push_back("nominal map " + request.maps[i].filename().string() + ": " + maps[i].alignment);
    }
}

}  // namespace

ReferenceMap referenceFromMapFiles(const NominalMapsRequest& request, Progress& progress) {
    const std::vector<NominalMap> maps = readNominalMaps(request, progress);
    ReferenceMap reference = meanReference(aligned(maps), request.mean, progress);
    if (request.alignTo) reference.provenance.push_back("frame of " + request.alignTo->filename().string());
    tellAlignment(request, maps, reference);
    return reference;
}

ReferenceMap referenceFromMeshAndMapFiles(const std::filesystem::path& mesh, const CadReferenceSettings& settings,
                                          const NominalMapsRequest& given, Progress& progress) {
    NominalMapsRequest request = given;
    request.alignTo = mesh;
    requireUsable(request.mean.covariance);
    ReferenceMap reference = referenceFromMeshFile(mesh, request.meshScale, settings, progress);
    const std::vector<NominalMap> maps = readNominalMaps(request, progress);
    collectScatter(samplesOf(aligned(maps), request.mean.denoise, progress), reference, progress);
    fitCovariances(reference, request.mean.covariance, progress);
    reference.provenance.push_back("covariances from " + std::to_string(maps.size()) + " nominal maps");
    reference.provenance.push_back(provenanceOf(request.mean.denoise));
    reference.provenance.push_back(provenanceOf(request.mean.covariance));
    tellAlignment(request, maps, reference);
    return reference;
}

ReferenceMap referenceFromMeshFile(const std::filesystem::path& mesh, double scale,
                                   const CadReferenceSettings& settings, Progress& progress) {
    progress.report("reading the mesh", 0.0);
    const TriangleMesh triangles = readMesh(mesh, scale);
    requireMetres(triangles, mesh.string());
    ReferenceMap reference = referenceFromCad(triangles, settings, progress);
    if (reference.size() < kFewestPoints) {
        throw Error(mesh.string(), "gives only " + std::to_string(reference.size()) + " samples",
                    "check the scale (metres in one unit of the mesh) and the spacing");
    }
    reference.provenance.push_back("mesh " + mesh.filename().string());
    return reference;
}

}  // namespace fodscope
