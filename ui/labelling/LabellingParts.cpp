// SPDX-License-Identifier: MIT
#include "ui/labelling/LabellingParts.h"

#include <algorithm>

#include "ui/labelling/PhotoDecoder.h"

namespace fodscope {

namespace {

constexpr std::size_t kDecodedKept = 4;

}  // namespace

int LabellingView::Parts::indexOf(const std::string& id) const {
    for (std::size_t index = 0; index < photos.size(); ++index) {
        if (photos[index].id == id) return static_cast<int>(index);
    }
    return -1;
}

const QImage& LabellingView::Parts::decode(const LabelPhoto& photo) {
    for (const auto& [id, image] : decoded) {
        if (id == photo.id) return image;
    }
    if (decoded.size() >= kDecodedKept) decoded.erase(decoded.begin());
    decoded.emplace_back(photo.id, decodePhoto(photo.bytes));
    return decoded.back().second;
}

void LabellingView::Parts::recomputeStates() {
    states = photoStates(photos, decisions, labeller, labelSet);
    layout->thumbnails->setStates(states);
}

/// Ids begin anew in every inspection: what is kept under an id holds only for the same bytes.
void LabellingView::Parts::forgetAllBut(const std::vector<LabelPhoto>& before) {
    const auto isSame = [&](const std::string& id) {
        const int now = indexOf(id);
        return now >= 0 && std::any_of(before.begin(), before.end(), [&](const LabelPhoto& photo) {
                   return photo.id == id && photo.bytes == photos[static_cast<std::size_t>(now)].bytes;
               });
    };
    std::erase_if(decoded, [&](const auto& entry) { return !isSame(entry.first); });
    std::erase_if(unfinished, [&](const auto& entry) { return !isSame(entry.first); });
    if (saving && !isSame(*saving)) saving.reset();
}

void LabellingView::Parts::leavePhoto() {
    if (!photo()) return;
    const QString comment = layout->comment->text();
    if (draft.isEmpty() && comment == commentOfDecision()) {
        unfinished.erase(photo()->id);
    } else {
        unfinished[photo()->id] = {draft, comment};
    }
}

void LabellingView::Parts::enterPhoto(int index) {
    current = index;
    const auto begun = unfinished.find(photo()->id);
    draft = begun == unfinished.end() ? LabelDraft{} : begun->second.draft;
    layout->comment->setText(begun == unfinished.end() ? commentOfDecision() : begun->second.comment);
    layout->addAnother->setChecked(!draft.labels.empty());
    layout->thumbnails->setCurrent(index);
    showPhoto();
    showHeader();
    showDraft();
}

void LabellingView::Parts::showPhoto() {
    const QImage& image = decode(*photo());
    pictureShown = !image.isNull();
    if (pictureShown) {
        layout->canvas->showPhoto(image, photo()->outlines);
    } else {
        const QString waypoint = QString::fromStdString(photo()->waypointId);
        layout->canvas->showSentence(
            tr("%1 cannot be shown").arg(QString::fromStdString(photo()->id)),
            tr("The %1 bytes that arrived are not a readable picture. Answer “not sure”, or photograph again%2.")
                .arg(photo()->bytes.size())
                .arg(waypoint.isEmpty() ? QString() : tr(" from %1 in step 4").arg(waypoint)),
            true);
    }
    layout->canvas->setBoxDrawing(pictureShown);
    layout->tools->setVisible(pictureShown);
}

void LabellingView::Parts::showHeader() {
    layout->header->setVisible(true);
    layout->showHeader(*photo(), states[static_cast<std::size_t>(current)], decision());
    layout->progress->setText(progressText(states));
    layout->next->setEnabled(nextUndecided(states, current).has_value());
}

void LabellingView::Parts::showDraft() {
    const Decision* counts = decision();
    layout->canvas->setBoxes(counts ? counts->labels : std::vector<PhotoLabel>{}, draft);
    layout->showKeys(draft.isEmpty() ? (counts ? counts->labels : std::vector<PhotoLabel>{}) : draft.labels);
    layout->showDraft(draft, layout->addAnother->isChecked(), done);
    layout->undo->setEnabled(hasDecisions(decisions, labeller));
}

void LabellingView::Parts::showNothing() {
    current = -1;
    draft = {};
    pictureShown = false;
    layout->header->setVisible(false);
    layout->tools->setVisible(false);
    layout->canvas->setBoxes({}, {});
    layout->canvas->showSentence(tr("No photos yet"),
                                 tr("Photos arrive while the robot visits the candidates: start the visits in step 4."),
                                 false);
    layout->canvas->setBoxDrawing(false);
}

}  // namespace fodscope
