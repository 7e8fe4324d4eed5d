// SPDX-License-Identifier: MIT
#include "ui/window/StepNeeds.h"

namespace fodscope {
namespace {

QString words(const char* text) {
    return QObject::tr(text);
}

StepNeed goTo(Icon picture, const QString& sentence, Step step) {
    const int number = static_cast<int>(step) + 1;
    return {picture, sentence, QObject::tr("Go to step %1").arg(number), QStringLiteral("step.%1").arg(number), {}, {}};
}

StepNeed reference() {
    return {Icon::Cube,
            words("What the space looks like without debris: nominal maps, a reference map, or a CAD mesh."),
            words("From a reference map…"),
            QStringLiteral("reference.load"),
            words("From nominal maps…"),
            QStringLiteral("reference.nominal")};
}

StepNeed map() {
    return {Icon::Cloud,
            words("The map under inspection, as the robot made it."),
            words("Load map…"),
            QStringLiteral("map.load"),
            {},
            {}};
}

StepNeed detection() {
    return {Icon::Search,
            words("Reference and map are here, but not compared yet."),
            words("Detect"),
            QStringLiteral("map.detect"),
            {},
            {}};
}

}  // namespace

std::optional<StepNeed> needOf(Step step, const InspectionController& controller) {
    const InspectionState& state = controller.state();
    const bool claimed = state.detection && state.detection->candidates;
    switch (step) {
        case Step::Reference:
            return state.reference ? std::nullopt : std::optional(reference());
        case Step::Map:
            if (controller.isRouteWanted()) return std::nullopt;
            if (!state.reference)
                return goTo(Icon::Cube, words("A map is compared with a reference: load that first."), Step::Reference);
            return state.mapSource ? std::nullopt : std::optional(map());
        case Step::Candidates:
            if (!state.reference)
                return goTo(Icon::Cube, words("Candidates need a reference and a map."), Step::Reference);
            if (!state.mapSource) return goTo(Icon::Cloud, words("Candidates need a map to be found in."), Step::Map);
            if (!state.detection) return detection();
            if (!claimed)
                return goTo(Icon::Warning,
                            words("The map is not aligned with the reference, so no candidates are claimed from it."),
                            Step::Map);
            return std::nullopt;
        case Step::Visit:
            return claimed ? std::nullopt
                           : std::optional(
                                 goTo(Icon::Route, words("There are no candidates to visit yet."), Step::Candidates));
        case Step::Label:
            return !state.photos.empty()
                       ? std::nullopt
                       : std::optional(
                             goTo(Icon::Camera, words("Photos appear here as the robot takes them."), Step::Visit));
        case Step::Report:
            return state.detection ? std::nullopt
                                   : std::optional(goTo(
                                         Icon::Report, words("A report tells what was compared: there is nothing yet."),
                                         firstOpenStep(state)));
    }
    return std::nullopt;
}

}  // namespace fodscope
