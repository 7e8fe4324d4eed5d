// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <QtGlobal>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/labels/Decision.h"
#include "core/labels/LabelSet.h"
#include "ui/labelling/CandidateOutline.h"

namespace fodscope {

/// A photo to be labelled.
struct LabelPhoto {
    std::string id;
    std::vector<std::string> candidateIds;
    std::string waypointId;
    UtcTime taken;
    /// JPEG or PNG as received.
    QByteArray bytes;
    /// Those of its candidates that lie in the picture, when its camera is known.
    std::vector<CandidateOutline> outlines;
    bool isOutlined = false;
};

/// @return the photos of an inspection with their outlines, in order of arrival
std::vector<LabelPhoto> labelPhotos(const InspectionState& state);

/// @return which candidates the photo shows, and which it was taken for but does not show
QStringList shownInWords(const LabelPhoto& photo);

/// What a labeller has said of a photo. Other readers' decisions stay hidden: readers are blind to each other.
enum class PhotoState { Undecided, NotSure, NoFod, Fod };

/// @return the word shown beside the state's colour and shape, e.g. "no FOD"
QString toWords(PhotoState state);

PhotoState photoState(const Decision* decision, const LabelSet& labels);

/// @return one state for each photo, as this labeller sees them
std::vector<PhotoState> photoStates(std::span<const LabelPhoto> photos, std::span<const Decision> decisions,
                                    const std::string& labeller, const LabelSet& labels);

/// @return the index of the next undecided photo after `current`, going round; empty when all are decided. A current
///         photo that is the only undecided one is returned itself.
std::optional<int> nextUndecided(std::span<const PhotoState> states, int current);

/// @return e.g. "12 of 47 decided · 3 not sure"
QString progressText(std::span<const PhotoState> states);

/// @return labels in words, e.g. "hammer, glove"; "nothing" for none
QString labelsInWords(std::span<const PhotoLabel> labels);

/// @return the key as it would be without Shift: on most layouts Shift+1 arrives as another sign, so the place of the
///         key on the keyboard (X11's and Wayland's scan code) decides, then the signs of the US layout
int keyWithoutShift(int qtKey, bool shift, quint32 nativeScanCode);

/// @return the label that a key gives, or null; letters of either case
const Label* labelForKey(const LabelSet& labels, int qtKey);

/// @return what the key cap shows for a label
QString keyCapText(const Label& label);

/// What a labeller has put together on one photo and not yet given as a decision. Starts empty on every photo: nothing
/// is ever carried over or proposed.
struct LabelDraft {
    std::vector<PhotoLabel> labels;
    /// A box that was drawn and waits for its label.
    std::optional<PixelBox> openBox;

    bool isEmpty() const { return labels.empty() && !openBox; }
};

/// What became of a key or a click on a key cap.
struct DraftStep {
    LabelDraft draft;
    /// Set: these labels are now the decision.
    std::optional<std::vector<PhotoLabel>> decision;
    /// A sentence for the labeller when the step was refused.
    QString refusal;
};

/// A label key: labels an open box (and stays); with `addAnother` adds the label (and stays); else adds it and decides.
DraftStep giveLabel(const LabelDraft& draft, const Label& label, bool addAnother);

/// Enter: decides what is in the draft.
DraftStep finishDraft(const LabelDraft& draft);

/// Backspace: drops the open box, else the label added last.
LabelDraft dropLast(LabelDraft draft);

/// What the newest act of a labeller took back.
struct TakenBack {
    std::string photoId;
    std::vector<PhotoLabel> labels;
};

/// @return what was taken back when `after` is `before` and one more act, an undo of this labeller; else empty
std::optional<TakenBack> takenBack(std::span<const Decision> before, std::span<const Decision> after,
                                   const std::string& labeller);

/// @return whether this labeller has a decision that still counts
bool hasDecisions(std::span<const Decision> decisions, const std::string& labeller);

}  // namespace fodscope
