// SPDX-License-Identifier: MIT
#include "core/evaluation/PhotoTruth.h"

#include <algorithm>

#include "core/inspection/GroundTruthLabeller.h"

namespace fodscope {
namespace {

constexpr const char* kOtherFod = "other FOD";

std::string labelOf(const std::string& type, const LabelSet& labels) {
    if (const Label* label = findByType(labels, type)) return label->name;
    const Label* other = findByType(labels, kOtherFod);
    return other ? other->name : type;
}

}  // namespace

bool isSimulatedLabeller(const std::string& name) {
    return name == GroundTruthLabeller::nameFor(true) || name == GroundTruthLabeller::nameFor(false);
}

ActualLabels actualLabelsIn(const std::filesystem::path& worldFile, const InspectionState& state, Progress& progress) {
    const auto world = std::make_shared<const World>(readWorld(worldFile));
    const GroundTruthLabeller truth(world, false);
    ActualLabels actual;
    for (const Photo& photo : state.photos) {
        progress.report("looking at the photos",
                        static_cast<double>(actual.size()) / static_cast<double>(state.photos.size()));
        std::set<std::string>& labels = actual[photo.id];
        for (const VisibleFod& fod : truth.fodOn(photo))
            labels.insert(labelOf(world->objects[fod.object].type, state.labelSet));
    }
    return actual;
}

std::optional<ActualLabels> recordedActualLabels(const InspectionState& state) {
    ActualLabels actual;
    for (const Photo& photo : state.photos) {
        for (const Decision* decision : countingDecisions(state.decisions, photo.id)) {
            if (!isSimulatedLabeller(decision->labeller)) continue;
            std::set<std::string>& labels = actual[photo.id];
            for (const PhotoLabel& label : decision->labels) {
                // It says `not sure` of FOD that its label set has no word for.
                if (label.label != kNoFod) labels.insert(label.label == kNotSure ? kOtherFod : label.label);
            }
        }
    }
    if (actual.empty()) return std::nullopt;
    return actual;
}

}  // namespace fodscope
