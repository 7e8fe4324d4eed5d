// SPDX-License-Identifier: MIT
#include "ui/session/ReferenceSources.h"

#include "core/cloud/MeshIo.h"
#include "core/cloud/UnitCheck.h"
#include "core/common/Error.h"
#include "core/common/Hash.h"
#include "core/inspection/ReferenceFiles.h"
#include "core/reference/ReferenceMapIo.h"

namespace fodscope {
namespace {

NominalMapsRequest nominalMaps(const ReferenceRequest& request, const std::vector<std::filesystem::path>& files) {
    NominalMapsRequest maps;
    maps.maps = files;
    maps.meshScale = request.meshScale;
    maps.mean = meanReferenceSettings(request.parameters);
    maps.registration = request.parameters.registration;
    return maps;
}

ReferenceMap readReady(const std::filesystem::path& file, Progress& progress) {
    progress.report("reading the reference", 0.0);
    ReferenceMap reference = readReferenceMap(file);
    requireUsableCloud(reference.points, file.filename().string());
    return reference;
}

SourceFile sourceOf(const ReferenceRequest& request, const ReferenceMap& reference) {
    SourceFile source;
    source.points = reference.size();
    source.path = request.files.front().string();
    std::vector<std::filesystem::path> all = request.files;
    all.insert(all.end(), request.covarianceMaps.begin(), request.covarianceMaps.end());
    if (all.size() == 1) {
        source.sha256 = sha256OfFile(all.front());
        return source;
    }
    source.path += " and " + std::to_string(all.size() - 1) + " more nominal maps";
    if (!request.covarianceMaps.empty())
        source.path =
            request.files.front().string() + " with " + std::to_string(request.covarianceMaps.size()) + " nominal maps";
    std::string hashes;
    for (const auto& file : all)
        hashes += sha256OfFile(file) + "\n";
    source.sha256 = sha256(std::string_view(hashes));
    return source;
}

ReferenceMap referenceOf(const ReferenceRequest& request, Progress& progress) {
    CadReferenceSettings cad;
    cad.spacing_m = request.parameters.reference.cadSpacing_m;
    switch (request.kind) {
        case ReferenceKind::Cad:
            return referenceFromMeshFile(request.files.front(), request.meshScale, cad, progress);
        case ReferenceKind::CadAndMaps:
            return referenceFromMeshAndMapFiles(request.files.front(), cad,
                                                nominalMaps(request, request.covarianceMaps), progress);
        case ReferenceKind::NominalMaps:
            return referenceFromMapFiles(nominalMaps(request, request.files), progress);
        case ReferenceKind::Ready:
            break;
    }
    return readReady(request.files.front(), progress);
}

}  // namespace

LoadedReference makeReference(const ReferenceRequest& request, Progress& progress) {
    if (request.files.empty())
        throw Error("reference", "no file was chosen", "choose a mesh, a reference map or nominal maps");
    ReferenceMap reference = referenceOf(request, progress);
    LoadedReference loaded;
    loaded.source = sourceOf(request, reference);
    loaded.reference = std::make_shared<const ReferenceMap>(std::move(reference));
    return loaded;
}

ReferenceRequest requestFor(const std::vector<std::filesystem::path>& files) {
    ReferenceRequest request;
    std::vector<std::filesystem::path> meshes;
    std::vector<std::filesystem::path> maps;
    for (const auto& file : files)
        (isMeshFile(file) ? meshes : maps).push_back(file);
    request.files = files;
    if (meshes.size() == 1 && !maps.empty()) {
        request.kind = ReferenceKind::CadAndMaps;
        request.files = meshes;
        request.covarianceMaps = maps;
    } else if (files.size() > 1) {
        request.kind = ReferenceKind::NominalMaps;
    } else {
        request.kind = meshes.size() == 1 ? ReferenceKind::Cad : ReferenceKind::Ready;
    }
    return request;
}

}  // namespace fodscope
