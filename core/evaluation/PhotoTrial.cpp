// SPDX-License-Identifier: MIT
#include "core/evaluation/PhotoTrial.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <system_error>

#include "core/common/Error.h"

namespace fodscope {
namespace {

/// Of the photos that FOD counts as seen on, whatever the size of the robot's own.
constexpr int kCountedWidth_px = 1280;

/// @return the world's objects that are the trial's FOD, in the trial's order
std::vector<std::size_t> objectsOf(const Trial& trial, const World& world, const std::string& subject) {
    std::multimap<std::string, std::size_t> fod;
    for (std::size_t i = 0; i < world.objects.size(); ++i)
        if (world.objects[i].fod) fod.emplace(world.objects[i].type, i);
    std::vector<std::size_t> objects;
    for (const GroundTruthFod& wanted : trial.fods) {
        const auto found = fod.find(wanted.type);
        if (found == fod.end()) {
            throw Error(subject, "holds no " + wanted.type + ", which the trial's ground truth lists",
                        "give the world that this trial was mapped in");
        }
        objects.push_back(found->second);
        fod.erase(found);
    }
    if (!fod.empty())
        throw Error(subject, "holds a " + fod.begin()->first + ", which the trial's ground truth does not list",
                    "give the world that this trial was mapped in");
    return objects;
}

}  // namespace

PhotoTrial::PhotoTrial(const Trial& trial, const std::filesystem::path& file, const CameraSettings& camera)
    : world_(std::make_shared<const World>(readWorld(file))),
      objects_(objectsOf(trial, *world_, file.string())),
      intrinsics_(intrinsicsOf(scaledTo(camera, kCountedWidth_px))),
      truth_(world_, false) {}

Pose2 PhotoTrial::robotStart_map() const {
    return poseFromTransform(world_->T_map_from_world * transformFromPose(world_->robotStart_world));
}

std::vector<std::uint8_t> PhotoTrial::fodSeenFrom(const Transform& T_map_from_camera) const {
    Photo photo;
    photo.T_map_from_camera = T_map_from_camera;
    photo.intrinsics = intrinsics_;
    const std::vector<VisibleFod> seen = truth_.fodOn(photo);
    std::vector<std::uint8_t> isSeen;
    for (const std::size_t object : objects_)
        isSeen.push_back(std::ranges::find(seen, object, &VisibleFod::object) != seen.end() ? 1 : 0);
    return isSeen;
}

/// The same view in another number of pixels.
CameraSettings scaledTo(CameraSettings camera, int width_px) {
    camera.height_px =
        static_cast<int>(std::lround(static_cast<double>(camera.height_px) * width_px / camera.width_px));
    camera.width_px = width_px;
    return camera;
}

std::filesystem::path worldFile(const std::filesystem::path& worlds, const Trial& trial) {
    return worlds / (trial.name + ".json");
}

void requireWorlds(const std::filesystem::path& worlds, std::span<const Trial> trials) {
    std::string missing;
    for (const Trial& trial : trials) {
        std::error_code ignored;
        if (trial.isNominal() || std::filesystem::is_regular_file(worldFile(worlds, trial), ignored)) continue;
        missing += (missing.empty() ? "" : ", ") + trial.name + ".json";
    }
    if (!missing.empty())
        throw Error(worlds.string(), "the worlds of these trials are missing: " + missing,
                    "give the folder that holds a world NAME.json for each trial");
}

OccupancyGrid gridOf(const Trial& trial, const DetectionResult& detection, double floorHeight_m,
                     const OccupancySettings& settings) {
    if (trial.grid) return readMapServerGrid(*trial.grid);
    return occupancyFromMap(detection.denoisedMap->points, detection.registration.T_reference_from_map, floorHeight_m,
                            settings);
}

}  // namespace fodscope
