// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <functional>
#include <vector>

namespace fodscope {

/// An act that can be taken back and done again. Both may throw Error, and then count as not done.
struct UndoableAct {
    /// In words, after "undo ": "threshold 2.75 to 3.10".
    QString name;
    std::function<void()> undo;
    std::function<void()> redo;
};

/// The acts since the inspection was opened, newest last.
class UndoHistory {
  public:
    void add(UndoableAct act);
    void clear();

    bool canUndo() const { return done_ > 0; }
    bool canRedo() const { return done_ < acts_.size(); }
    QString undoName() const { return canUndo() ? acts_[done_ - 1].name : QString(); }
    QString redoName() const { return canRedo() ? acts_[done_].name : QString(); }

    void undo();
    void redo();

  private:
    std::vector<UndoableAct> acts_;
    std::size_t done_ = 0;
};

}  // namespace fodscope
