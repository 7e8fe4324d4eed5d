// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/inspection/InspectionState.h"

namespace fodscope {

/// A decision with the candidates that each of its labels is about.
struct OwnedDecision {
    const Decision* decision = nullptr;
    /// One list for each label of the decision.
    std::vector<std::vector<std::string>> owners;
};

/// Whom the labels of all decisions are about. A label without a box is about the candidates that its photo was taken
/// for. A FOD box belongs to the one of them whose outline it meets, and to several only where it meets them about
/// equally; when it meets none of theirs, to the candidate nearest to the camera whose outline it does meet: a tool in
/// the background is not a finding where the photo was aimed. A box that meets no outline at all stays with the
/// candidates of the photo, so that nothing a reader saw is lost. The pointers are into `state.decisions`.
std::vector<OwnedDecision> ownDecisions(const InspectionState& state);

/// The photos on which a reader can clear a candidate: those taken for it that show at least half of its voxels. One
/// that several waypoints show in parts is cleared on all of them together, once they show what was planned to be
/// shown of it; until then there are none. All that were taken for it where nothing is known of its place (a record
/// without a field).
std::vector<const Photo*> photosThatShow(const std::string& candidateId, const InspectionState& state);

/// What was said on one candidate: the photos that tell of it, and the decisions with the labels that are about it. A
/// decision on a photo of the candidate whose boxes all belong elsewhere says `no FOD` of it. `No FOD` on a photo that
/// does not show the candidate says nothing of it: a camera that looked past it must not clear it.
std::pair<std::vector<PhotoSubject>, std::vector<Decision>> wordsOn(const std::string& candidateId,
                                                                    const InspectionState& state,
                                                                    const std::vector<OwnedDecision>& owned);

}  // namespace fodscope
