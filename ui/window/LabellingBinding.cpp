// SPDX-License-Identifier: MIT
#include "ui/window/LabellingBinding.h"

namespace fodscope {

LabellingBinding::LabellingBinding(InspectionController& controller, LabellingView& view, QObject* parent)
    : QObject(parent), controller_(controller), view_(view) {
    connect(&controller, &InspectionController::sessionChanged, this, &LabellingBinding::showAll);
    connect(&controller, &InspectionController::photosChanged, this,
            [this] { view_.setPhotos(labelPhotos(controller_.state())); });
    connect(&controller, &InspectionController::decisionsChanged, this,
            [this] { view_.setDecisions(controller_.state().decisions); });
    connect(&controller, &InspectionController::labelSetChanged, this,
            [this] { view_.setLabelSet(controller_.state().labelSet); });
    connect(&controller, &InspectionController::labellerChanged, this,
            [this] { view_.setLabeller(controller_.labeller()); });
    connect(&controller, &InspectionController::photoSelectionChanged, &view, &LabellingView::setCurrent);
    connect(&view, &LabellingView::photoSelected, &controller, &InspectionController::selectPhoto);
    connect(&view, &LabellingView::labellerNamed, &controller, &InspectionController::setLabeller);
    connect(&view, &LabellingView::undoRequested, &controller, &InspectionController::undo);
    connect(&view, &LabellingView::decided, this, &LabellingBinding::keep);
    showAll();
}

void LabellingBinding::showAll() {
    view_.setLabelSet(controller_.state().labelSet);
    view_.setLabeller(controller_.labeller());
    view_.setPhotos(labelPhotos(controller_.state()));
    view_.setDecisions(controller_.state().decisions);
}

void LabellingBinding::keep(const QString& photoId, const std::vector<PhotoLabel>& labels, const QString& comment) {
    if (!controller_.decide(photoId, labels, comment))
        view_.decisionFailed(tr("The decision could not be kept; the photo is still undecided."));
}

}  // namespace fodscope
