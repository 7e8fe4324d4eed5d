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

ReferenceMap fromNominalMaps(const ReferenceRequest& request, Progress& progress) {
    NominalMapsRequest maps;
    maps.maps = request.files;
    maps.mean = request.mean;
    return referenceFromMapFiles(maps, progress);
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
    if (request.files.size() == 1) {
        source.sha256 = sha256OfFile(request.files.front());
        return source;
    }
    source.path += " and " + std::to_string(request.files.size() - 1) + " more nominal maps";
    std::string hashes;
    for (const auto& file : request.files)
        hashes += sha256OfFile(file) + "\n";
    source.sha256 = sha256(std::string_view(hashes));
    return source;
}

ReferenceMap referenceOf(const ReferenceRequest& request, Progress& progress) {
    switch (request.kind) {
        case ReferenceKind::Cad:
            return referenceFromMeshFile(request.files.front(), request.meshScale, request.cad, progress);
        case ReferenceKind::NominalMaps:
            return fromNominalMaps(request, progress);
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
    request.files = files;
    if (files.size() > 1)
        request.kind = ReferenceKind::NominalMaps;
    else if (files.size() == 1 && isMeshFile(files.front()))
        request.kind = ReferenceKind::Cad;
    else
        request.kind = ReferenceKind::Ready;
    return request;
}

}  // namespace fodscope
