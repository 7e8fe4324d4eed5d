// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "core/common/Progress.h"
#include "core/simulation/World.h"
#include "ui/session/MapLoading.h"
#include "ui/session/ReferenceSources.h"

namespace fodscope {

/// What the session file names as the map's file.
inline constexpr const char* kBuiltinMapName = "built-in tank";

/// Everything for an inspection of the built-in tank.
struct BuiltinInspection {
    LoadedReference reference;
    MapFile map;
    std::shared_ptr<const World> world;
    /// The robot's own grid.
    OccupancyGrid grid_map;
};

/// Simulates the built-in tank's maps and makes the reference from the nominal ones, always with the same outcome. Some
/// seconds; for a worker thread.
BuiltinInspection makeBuiltinInspection(Progress& progress);

/// The map of a session again: from its file, or simulated anew for the built-in tank.
/// @throws Error when the file is gone or holds something else now
LoadedMap rereadMap(const SourceFile& source, Progress& progress);

}  // namespace fodscope
