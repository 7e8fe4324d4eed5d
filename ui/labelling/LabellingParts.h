// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ui/labelling/LabellingLayout.h"
#include "ui/labelling/LabellingView.h"

namespace fodscope {

/// What was begun on a photo and not decided; kept while the labeller looks at others.
struct Unfinished {
    LabelDraft draft;
    QString comment;
};

/// What the labelling view knows, and how it is shown; what keys and clicks do is in LabellingView.
struct LabellingView::Parts {
    LabelSet labelSet;
    std::vector<LabelPhoto> photos;
    std::vector<Decision> decisions;
    std::string labeller;
    std::vector<PhotoState> states;
    int current = -1;
    LabelDraft draft;
    std::map<std::string, Unfinished> unfinished;
    std::vector<std::pair<std::string, QImage>> decoded;
    /// The photo whose decision is on its way to the disk, and whether it was undecided before.
    std::optional<std::string> saving;
    bool goOnAfterSaving = true;
    bool pictureShown = false;
    /// What was kept last, for the line below the keys.
    QString done;
    std::unique_ptr<LabellingLayout> layout;

    const LabelPhoto* photo() const { return current < 0 ? nullptr : &photos[static_cast<std::size_t>(current)]; }
    const Decision* decision() const { return photo() ? lastDecision(decisions, photo()->id, labeller) : nullptr; }
    int indexOf(const std::string& id) const;
    const QImage& decode(const LabelPhoto& photo);
    QString commentOfDecision() const { return decision() ? QString::fromStdString(decision()->comment) : QString(); }

    void recomputeStates();
    void forgetAllBut(const std::vector<LabelPhoto>& before);
    void leavePhoto();
    void enterPhoto(int index);
    void showPhoto();
    void showDraft();
    void showHeader();
    void showNothing();
};

}  // namespace fodscope
