// SPDX-License-Identifier: MIT
#include "ui/session/UndoHistory.h"

#include <utility>

namespace fodscope {

void UndoHistory::add(UndoableAct act) {
    acts_.resize(done_);
    acts_.push_back(std::move(act));
    done_ = acts_.size();
}

void UndoHistory::clear() {
    acts_.clear();
    done_ = 0;
}

void UndoHistory::undo() {
    if (!canUndo()) return;
    // A copy, as the act may add to the history or clear it.
    const auto act = acts_[done_ - 1].undo;
    act();
    if (done_ > 0) --done_;
}

void UndoHistory::redo() {
    if (!canRedo()) return;
    const auto act = acts_[done_].redo;
    act();
    if (done_ < acts_.size()) ++done_;
}

}  // namespace fodscope
