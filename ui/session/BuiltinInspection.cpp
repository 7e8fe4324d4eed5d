// SPDX-License-Identifier: MIT
#include "ui/session/BuiltinInspection.h"

#include <span>

#include "core/cloud/Spacing.h"
#include "core/common/Error.h"
#include "core/common/Hash.h"
#include "core/reference/MeanReference.h"
#include "core/simulation/BuiltinDemo.h"

namespace fodscope {
namespace {

std::string fingerprint(const std::vector<Eigen::Vector3d>& points) {
    return sha256(std::as_bytes(std::span(points)));
}

/// The simulation knows where each nominal map lies; an operator's own nominal maps are registered instead.
LoadedReference referenceOf(const std::vector<MappingRun>& nominal, Progress& progress) {
    std::vector<AlignedNominalMap> maps;
    for (const MappingRun& run : nominal)
        maps.push_back({&run.map, run.T_map_from_world.inverse()});
    ReferenceMap reference = meanReference(maps, {}, progress);
    reference.provenance.insert(reference.provenance.begin(),
                                "built-in tank: " + std::to_string(nominal.size()) + " simulated nominal maps");
    LoadedReference loaded;
    loaded.source = {"built-in tank, nominal maps", fingerprint(reference.points), reference.size()};
    loaded.reference = std::make_shared<const ReferenceMap>(std::move(reference));
    return loaded;
}

}  // namespace

BuiltinInspection makeBuiltinInspection(Progress& progress) {
    BuiltinTrials trials = makeBuiltinTrials({}, progress);
    BuiltinInspection builtin;
    builtin.reference = referenceOf(trials.nominal, progress);
    builtin.world = trials.world;
    builtin.grid_map = std::move(trials.trial.grid_map);
    const auto cloud = std::make_shared<const PointCloud>(std::move(trials.trial.map));
    builtin.map.source = {kBuiltinMapName, fingerprint(cloud->points), cloud->size()};
    builtin.map.map = {cloud, medianSpacing_m(cloud->points, progress)};
    return builtin;
}

LoadedMap rereadMap(const SourceFile& source, Progress& progress) {
    const MapFile file =
        source.path == kBuiltinMapName ? makeBuiltinInspection(progress).map : readMapFile(source.path, progress);
    if (file.source.sha256 != source.sha256)
        throw Error(source.path, "it is not the map of this session any more: its content changed",
                    "load the map that is to be inspected");
    return file.map;
}

}  // namespace fodscope
