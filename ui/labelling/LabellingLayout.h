// SPDX-License-Identifier: MIT
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <functional>
#include <vector>

#include "ui/labelling/LabellerPrompt.h"
#include "ui/labelling/LabellingModel.h"
#include "ui/labelling/PhotoCanvas.h"
#include "ui/labelling/ThumbnailStrip.h"
#include "ui/widgets/KeyCap.h"
#include "ui/widgets/StatusChip.h"
#include "ui/widgets/Toast.h"

namespace fodscope {

/// The widgets of the labelling view, placed, and what they say; what they do is the view's. All belong to the view.
struct LabellingLayout {
    explicit LabellingLayout(QWidget* view);

    using LabelTaken = std::function<void(const Label& label, bool addAnother)>;
    void makeKeys(const LabelSet& labelSet, const LabelTaken& taken);
    void showHeader(const LabelPhoto& photo, PhotoState state, const Decision* decision);
    void showKeys(const std::vector<PhotoLabel>& given);
    /// @param done what was decided last, shown while nothing is begun
    void showDraft(const LabelDraft& draft, bool addingAnother, const QString& done);
    void showTools();
    void showLabeller(const QString& name);

    QWidget* header = nullptr;
    QLabel* title = nullptr;
    QLabel* detail = nullptr;
    StatusChip* state = nullptr;
    QLabel* progress = nullptr;
    QPushButton* next = nullptr;

    PhotoCanvas* canvas = nullptr;
    QWidget* tools = nullptr;
    QToolButton* outline = nullptr;
    QToolButton* contrast = nullptr;
    QToolButton* zoom = nullptr;
    Toast* toast = nullptr;

    LabellerPrompt* prompt = nullptr;
    QWidget* keyRow = nullptr;
    std::vector<KeyCap*> keys;
    QPushButton* addAnother = nullptr;
    QLabel* draftText = nullptr;
    QPushButton* finish = nullptr;
    QLineEdit* comment = nullptr;
    QPushButton* undo = nullptr;
    QLabel* labeller = nullptr;
    ThumbnailStrip* thumbnails = nullptr;

  private:
    QWidget* makeHeader(QWidget* view);
    void makeTools();
    QWidget* makeDecisionPanel(QWidget* view);
};

}  // namespace fodscope
