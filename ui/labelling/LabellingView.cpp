// SPDX-License-Identifier: MIT
#include "ui/labelling/LabellingView.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "ui/labelling/LabellingParts.h"

namespace fodscope {

LabellingView::LabellingView(QWidget* parent) : QWidget(parent), parts_(std::make_unique<Parts>()) {
    qRegisterMetaType<std::vector<PhotoLabel>>("std::vector<fodscope::PhotoLabel>");
    setObjectName(QStringLiteral("labellingView"));
    setFocusPolicy(Qt::StrongFocus);
    parts_->layout = std::make_unique<LabellingLayout>(this);
    LabellingLayout& layout = *parts_->layout;

    connect(layout.canvas, &PhotoCanvas::boxDrawn, this, &LabellingView::takeBox);
    connect(layout.canvas, &PhotoCanvas::zoomChanged, this, [&layout] { layout.showTools(); });
    connect(layout.outline, &QToolButton::clicked, this, &LabellingView::toggleOutline);
    connect(layout.contrast, &QToolButton::clicked, this, &LabellingView::toggleContrast);
    connect(layout.zoom, &QToolButton::clicked, layout.canvas, &PhotoCanvas::cycleZoom);
    connect(layout.next, &QPushButton::clicked, this, &LabellingView::goToNextUndecided);
    connect(layout.undo, &QPushButton::clicked, this, &LabellingView::requestUndo);
    connect(layout.finish, &QPushButton::clicked, this, &LabellingView::finish);
    connect(layout.addAnother, &QPushButton::clicked, this, [this] { parts_->showDraft(); });
    connect(layout.thumbnails, &ThumbnailStrip::clicked, this, &LabellingView::goTo);
    connect(layout.prompt, &LabellerPrompt::named, this, &LabellingView::takeName);
    layout.comment->installEventFilter(this);
    parts_->showNothing();
    setLabeller({});
}

LabellingView::~LabellingView() = default;

void LabellingView::setLabelSet(const LabelSet& labelSet) {
    parts_->labelSet = labelSet;
    parts_->layout->makeKeys(labelSet, [this](const Label& label, bool addAnother) { take(label, addAnother); });
    parts_->recomputeStates();
    if (parts_->photo()) {
        parts_->showHeader();
        parts_->showDraft();
    }
}

void LabellingView::setPhotos(std::vector<LabelPhoto> photos) {
    const std::string shown = parts_->photo() ? parts_->photo()->id : std::string();
    parts_->leavePhoto();
    parts_->current = -1;
    const std::vector<LabelPhoto> before = std::exchange(parts_->photos, std::move(photos));
    parts_->forgetAllBut(before);
    parts_->layout->thumbnails->setPhotos(&parts_->photos);
    parts_->recomputeStates();
    const int kept = parts_->indexOf(shown);
    if (parts_->photos.empty()) {
        parts_->decoded.clear();
        parts_->showNothing();
    } else if (kept >= 0) {
        parts_->enterPhoto(kept);
    } else {
        goTo(nextUndecided(parts_->states, -1).value_or(0));
    }
}

void LabellingView::setDecisions(std::vector<Decision> decisions) {
    const std::vector<Decision> before = std::exchange(parts_->decisions, std::move(decisions));
    parts_->recomputeStates();
    if (parts_->saving) {
        finishSaving(before.size());
    } else if (const auto undone = takenBack(before, parts_->decisions, parts_->labeller)) {
        finishUndo(*undone);
    }
    if (!parts_->photo()) return;
    parts_->showHeader();
    parts_->showDraft();
}

void LabellingView::finishSaving(std::size_t decisionsBefore) {
    const auto isIt = [this](const Decision& act) {
        return act.photoId == *parts_->saving && act.labeller == parts_->labeller;
    };
    const auto first =
        parts_->decisions.begin() + static_cast<std::ptrdiff_t>(std::min(decisionsBefore, parts_->decisions.size()));
    const auto act = std::find_if(first, parts_->decisions.end(), isIt);
    if (act == parts_->decisions.end()) return;
    const QString photo = QString::fromStdString(act->photoId);
    parts_->saving.reset();
    parts_->unfinished.erase(act->photoId);
    parts_->draft = {};
    parts_->layout->addAnother->setChecked(false);
    const auto next = nextUndecided(parts_->states, parts_->current);
    parts_->done = tr("Kept: %1 %2").arg(photo, labelsInWords(act->labels));
    if (!next) parts_->layout->toast->showMessage(StatusKind::Clear, tr("All photos are decided."));
    if (parts_->goOnAfterSaving && next) goTo(*next);
}

void LabellingView::finishUndo(const TakenBack& undone) {
    parts_->done.clear();
    // What was begun on the photo that is left stays; what the undone decision said must not come back by itself.
    parts_->unfinished.erase(undone.photoId);
    const int index = parts_->indexOf(undone.photoId);
    if (index == parts_->current && index >= 0) {
        parts_->enterPhoto(index);
    } else if (index >= 0) {
        goTo(index);
    }
    const Decision* now = lastDecision(parts_->decisions, undone.photoId, parts_->labeller);
    parts_->layout->toast->showMessage(
        StatusKind::Neutral,
        tr("Took back “%1” on %2. %3")
            .arg(labelsInWords(undone.labels), QString::fromStdString(undone.photoId),
                 now ? tr("It is “%1” again.").arg(labelsInWords(now->labels)) : tr("It is undecided again.")));
}

void LabellingView::setLabeller(const QString& name) {
    parts_->labeller = name.toStdString();
    parts_->layout->showLabeller(name);
    parts_->recomputeStates();
    if (parts_->photo()) parts_->enterPhoto(parts_->current);
}

void LabellingView::takeName(const QString& name) {
    setLabeller(name);
    setFocus();
    emit labellerNamed(name);
}

void LabellingView::setCurrent(const QString& photoId) {
    const int index = parts_->indexOf(photoId.toStdString());
    if (index < 0 || index == parts_->current) return;
    parts_->leavePhoto();
    parts_->enterPhoto(index);
}

void LabellingView::setCandidate(const QString& candidateId) {
    const std::string id = candidateId.toStdString();
    const auto shows = [&](const LabelPhoto& photo) {
        return std::find(photo.candidateIds.begin(), photo.candidateIds.end(), id) != photo.candidateIds.end();
    };
    if (parts_->photo() && shows(*parts_->photo())) return;
    const auto photo = std::find_if(parts_->photos.begin(), parts_->photos.end(), shows);
    if (photo != parts_->photos.end()) setCurrent(QString::fromStdString(photo->id));
}

void LabellingView::decisionFailed(const QString& message) {
    parts_->saving.reset();
    parts_->layout->toast->showMessage(StatusKind::Finding, message);
    if (parts_->photo()) parts_->showDraft();
}

QString LabellingView::currentPhoto() const {
    return parts_->photo() ? QString::fromStdString(parts_->photo()->id) : QString();
}

QString LabellingView::labeller() const {
    return QString::fromStdString(parts_->labeller);
}

void LabellingView::goTo(int index) {
    if (index < 0 || index >= static_cast<int>(parts_->photos.size()) || index == parts_->current) return;
    parts_->leavePhoto();
    parts_->enterPhoto(index);
    // The photo that a label key would lead to is decoded beforehand, so that it shows at once.
    QTimer::singleShot(0, this, [this] {
        const auto next = nextUndecided(parts_->states, parts_->current);
        if (next) parts_->decode(parts_->photos[static_cast<std::size_t>(*next)]);
    });
    emit photoSelected(currentPhoto());
}

void LabellingView::goToNextUndecided() {
    const auto next = nextUndecided(parts_->states, parts_->current);
    if (next && *next != parts_->current) {
        goTo(*next);
    } else if (!next && !parts_->photos.empty()) {
        parts_->layout->toast->showMessage(StatusKind::Clear, tr("All photos are decided."));
    }
}

void LabellingView::goToNext() {
    goTo(parts_->current + 1);
}

void LabellingView::goToPrevious() {
    goTo(parts_->current - 1);
}

void LabellingView::toggleOutline() {
    parts_->layout->canvas->setOutlineShown(!parts_->layout->canvas->outlineShown());
    parts_->layout->showTools();
}

void LabellingView::toggleContrast() {
    parts_->layout->canvas->setContrast(!parts_->layout->canvas->contrast());
    parts_->layout->showTools();
}

void LabellingView::requestUndo() {
    if (parts_->saving) return;
    if (!hasDecisions(parts_->decisions, parts_->labeller)) {
        parts_->layout->toast->showMessage(StatusKind::Neutral, tr("There is no decision of yours to take back."));
        return;
    }
    emit undoRequested();
}

bool LabellingView::mayDecide() {
    if (!parts_->photo() || parts_->saving) return false;
    if (!parts_->labeller.empty()) return true;
    parts_->layout->toast->showMessage(StatusKind::Attention, tr("Say first who you are: a decision carries a name."));
    parts_->layout->prompt->takeFocus();
    return false;
}

void LabellingView::take(const Label& label, bool addAnother) {
    if (!mayDecide()) return parts_->showDraft();
    if (!parts_->pictureShown && label.kind != LabelKind::NotSure) {
        parts_->layout->toast->showMessage(StatusKind::Attention,
                                           tr("This photo cannot be shown: only “not sure” is an answer."));
        return parts_->showDraft();
    }
    apply(giveLabel(parts_->draft, label, addAnother || parts_->layout->addAnother->isChecked()));
}

void LabellingView::takeBox(const PixelBox& box) {
    if (!mayDecide()) return;
    parts_->draft.openBox = box;
    parts_->showDraft();
    setFocus();
}

void LabellingView::finish() {
    if (!mayDecide()) return;
    if (!parts_->draft.isEmpty()) return apply(finishDraft(parts_->draft));
    const Decision* counts = parts_->decision();
    if (!counts || parts_->layout->comment->text() == parts_->commentOfDecision()) return;
    // A comment added later is a later decision with the same labels.
    decide(counts->labels);
}

void LabellingView::apply(const DraftStep& step) {
    parts_->draft = step.draft;
    if (!step.refusal.isEmpty()) parts_->layout->toast->showMessage(StatusKind::Attention, step.refusal);
    if (step.decision) {
        decide(*step.decision);
    } else {
        parts_->showDraft();
    }
}

void LabellingView::decide(const std::vector<PhotoLabel>& labels) {
    // A correction leaves the labeller where they are; a first answer leads on.
    parts_->goOnAfterSaving = parts_->decision() == nullptr;
    parts_->saving = parts_->photo()->id;
    emit decided(currentPhoto(), labels, parts_->layout->comment->text().trimmed());
}

bool LabellingView::eventFilter(QObject* watched, QEvent* event) {
    if (watched != parts_->layout->comment || event->type() != QEvent::KeyPress) {
        return QWidget::eventFilter(watched, event);
    }
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Escape) {
        parts_->layout->comment->setText(parts_->commentOfDecision());
        setFocus();
        return true;
    }
    if (key != Qt::Key_Return && key != Qt::Key_Enter) return false;
    setFocus();
    if (parts_->draft.isEmpty() && parts_->decision()) finish();
    return true;
}

bool LabellingView::takeBack() {
    if (parts_->saving) return true;
    parts_->draft = dropLast(parts_->draft);
    if (parts_->photo()) parts_->showDraft();
    return true;
}

void LabellingView::resizeEvent(QResizeEvent* event) {
    constexpr int kLow_px = 660;
    QWidget::resizeEvent(event);
    parts_->layout->thumbnails->setCompact(height() < kLow_px);
}

void LabellingView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    parts_->labeller.empty() ? parts_->layout->prompt->takeFocus() : setFocus();
}

}  // namespace fodscope
