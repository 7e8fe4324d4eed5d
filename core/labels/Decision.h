// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/common/UtcTime.h"
#include "core/labels/LabelSet.h"

namespace fodscope {

/// Pixels of the photo as received.
struct PixelBox {
    double left_px = 0.0;
    double top_px = 0.0;
    double width_px = 0.0;
    double height_px = 0.0;

    bool operator==(const PixelBox&) const = default;
};

struct PhotoLabel {
    std::string label;
    std::optional<PixelBox> box;

    bool operator==(const PhotoLabel&) const = default;
};

/// A labeller's word on a photo. Decisions are appended, never changed: a correction or an undo is a later decision.
struct Decision {
    std::string photoId;
    std::string labeller;
    UtcTime time;
    /// Empty: the labeller took the earlier decision back (undo). Several: more than one FOD on the photo.
    std::vector<PhotoLabel> labels;
    std::string comment;
    /// An undo: `labels` and `comment` are those of the decision that counts again, or empty. Tells an undo from a
    /// second decision with the same labels, so that the next undo reaches further back.
    bool takesBack = false;

    bool operator==(const Decision&) const = default;
};

enum class Verdict {
    NotPhotographed,  ///< no photo shows it
    Undecided,        ///< photos wait for a decision
    Open,             ///< not sure, or readers disagree
    NoFod,            ///< decided: nothing there
    Finding           ///< decided: FOD
};

std::string toString(Verdict verdict);

/// What the decisions make of a candidate.
struct CandidateVerdict {
    std::string candidateId;
    Verdict verdict = Verdict::NotPhotographed;
    /// Distinct FOD labels, in order of first mention: those of a finding, or those that an open candidate's readers
    /// named.
    std::vector<std::string> fodLabels;
};

/// Which candidates a photo shows.
struct PhotoSubject {
    std::string photoId;
    std::vector<std::string> candidateIds;
};

/// The last decision of each reader on each photo counts; a candidate is a finding when a resolved decision on any of
/// its photos names FOD; disagreement or `not sure` leaves it open. A photo is resolved when all its readers gave the
/// same labels. Of a candidate without FOD, an open photo outweighs one that waits, and that one `no FOD`.
std::vector<CandidateVerdict> resolveVerdicts(std::span<const std::string> candidateIds,
                                              std::span<const PhotoSubject> photos, std::span<const Decision> decisions,
                                              const LabelSet& labels);

/// @return the last decision of a reader on a photo that was not taken back, or null
const Decision* lastDecision(std::span<const Decision> decisions, const std::string& photoId,
                             const std::string& labeller);

/// @return the decision of each reader that counts on a photo, in the order of the readers' first decisions on it
std::vector<const Decision*> countingDecisions(std::span<const Decision> decisions, const std::string& photoId);

/// @return the decision that takes the labeller's latest act back, undos counted; empty when there is none left
std::optional<Decision> undoOf(std::span<const Decision> decisions, const std::string& labeller, UtcTime time);

}  // namespace fodscope
