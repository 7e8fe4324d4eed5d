// SPDX-License-Identifier: MIT
#include <QKeyEvent>

#include "ui/labelling/LabellingParts.h"
#include "ui/labelling/LabellingView.h"

namespace fodscope {

void LabellingView::keyPressEvent(QKeyEvent* event) {
    const Qt::KeyboardModifiers modifiers = event->modifiers() & ~Qt::KeypadModifier;
    const bool shift = modifiers == Qt::ShiftModifier;
    if (modifiers == Qt::ControlModifier ? takeControlKey(event->key()) : takeMoveKey(event->key())) return;
    if (modifiers != Qt::NoModifier && !shift) return QWidget::keyPressEvent(event);
    const int key = keyWithoutShift(event->key(), shift, event->nativeScanCode());
    if (const Label* label = labelForKey(parts_->labelSet, key)) {
        if (!event->isAutoRepeat()) take(*label, shift);
        return;
    }
    if (!takeCommandKey(key)) QWidget::keyPressEvent(event);
}

bool LabellingView::takeControlKey(int key) {
    constexpr double kPan_px = 60.0;
    PhotoCanvas* canvas = parts_->layout->canvas;
    switch (key) {
        case Qt::Key_Z:
            requestUndo();
            return true;
        case Qt::Key_Left:
            canvas->pan({kPan_px, 0});
            return true;
        case Qt::Key_Right:
            canvas->pan({-kPan_px, 0});
            return true;
        case Qt::Key_Up:
            canvas->pan({0, kPan_px});
            return true;
        case Qt::Key_Down:
            canvas->pan({0, -kPan_px});
            return true;
        default:
            return false;
    }
}

bool LabellingView::takeMoveKey(int key) {
    switch (key) {
        case Qt::Key_Right:
        case Qt::Key_Down:
            goToNext();
            return true;
        case Qt::Key_Left:
        case Qt::Key_Up:
            goToPrevious();
            return true;
        case Qt::Key_Home:
            goTo(0);
            return true;
        case Qt::Key_End:
            goTo(static_cast<int>(parts_->photos.size()) - 1);
            return true;
        default:
            return false;
    }
}

bool LabellingView::takeCommandKey(int key) {
    switch (key) {
        case Qt::Key_N:
            goToNextUndecided();
            return true;
        case Qt::Key_O:
            toggleOutline();
            return true;
        case Qt::Key_C:
            toggleContrast();
            return true;
        case Qt::Key_Z:
            parts_->layout->canvas->cycleZoom();
            return true;
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            parts_->layout->canvas->zoom(1.25);
            return true;
        case Qt::Key_Minus:
            parts_->layout->canvas->zoom(0.8);
            return true;
        case Qt::Key_A:
            parts_->layout->addAnother->toggle();
            if (parts_->photo()) parts_->showDraft();
            return true;
        case Qt::Key_M:
            parts_->layout->comment->setFocus();
            return true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            finish();
            return true;
        case Qt::Key_Backspace:
        case Qt::Key_Delete:
            return takeBack();
        case Qt::Key_Escape:
            return parts_->draft.isEmpty() ? false : takeBack();
        default:
            return false;
    }
}

}  // namespace fodscope
