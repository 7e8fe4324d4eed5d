// SPDX-License-Identifier: MIT
#include "core/inspection/GroundTruthLabeller.h"

#include <algorithm>
#include <utility>

namespace fodscope {
namespace {

constexpr const char* kOtherFod = "other FOD";

/// @return the object's label, and a comment where the set has none for it
std::pair<std::string, std::string> labelFor(const std::string& type, const LabelSet& labels) {
    if (const Label* label = findByType(labels, type)) return {label->name, ""};
    const Label* other = findByType(labels, kOtherFod);
    return {other ? other->name : kNotSure, "shows a " + type + ", for which the label set has no label"};
}

PixelBox boxOf(const VisibleObject& object) {
    return {static_cast<double>(object.left_px), static_cast<double>(object.top_px),
            static_cast<double>(object.right_px - object.left_px),
            static_cast<double>(object.bottom_px - object.top_px)};
}

}  // namespace

GroundTruthLabeller::GroundTruthLabeller(std::shared_ptr<const World> world, bool builtin)
    : world_(std::move(world)), raycaster_(*world_), name_(nameFor(builtin)) {}

std::string GroundTruthLabeller::nameFor(bool builtin) {
    return builtin ? "built-in world's ground truth" : "world's ground truth";
}

std::vector<VisibleFod> GroundTruthLabeller::fodOn(const Photo& photo) const {
    const Transform T_world_from_camera = world_->T_map_from_world.inverse() * photo.T_map_from_camera;
    const auto seen = visibleObjects(*world_, raycaster_, T_world_from_camera, photo.intrinsics);
    std::vector<VisibleFod> fod;
    for (std::size_t i = 0; i < world_->objects.size(); ++i)
        if (world_->objects[i].fod && seen[i].pixels >= kLeastPixels) fod.push_back({i, seen[i]});
    return fod;
}

PhotoAnswer GroundTruthLabeller::answer(const Photo& photo, const LabelSet& labels) const {
    PhotoAnswer answer;
    for (const VisibleFod& fod : fodOn(photo)) {
        const auto [label, comment] = labelFor(world_->objects[fod.object].type, labels);
        if (!comment.empty()) answer.comment += (answer.comment.empty() ? "" : "; ") + comment;
        answer.labels.push_back({label, boxOf(fod.seen)});
    }
    if (answer.labels.empty()) answer.labels.push_back({kNoFod, std::nullopt});
    return answer;
}

}  // namespace fodscope
