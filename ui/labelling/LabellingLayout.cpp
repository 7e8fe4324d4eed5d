// SPDX-License-Identifier: MIT
#include "ui/labelling/LabellingLayout.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/labelling/FlowLayout.h"
#include "ui/theme/Icons.h"
#include "ui/theme/Theme.h"

namespace fodscope {

namespace {

StatusKind statusOf(LabelKind kind) {
    switch (kind) {
        case LabelKind::Fod:
            return StatusKind::Finding;
        case LabelKind::NoFod:
            return StatusKind::Clear;
        case LabelKind::NotSure:
            return StatusKind::Attention;
    }
    return StatusKind::Neutral;
}

QToolButton* makeTool(QWidget* parent, const char* name, Icon picture, const QString& tip) {
    auto* button = new QToolButton(parent);
    button->setObjectName(QLatin1String(name));
    button->setIcon(icon(picture));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setFocusPolicy(Qt::NoFocus);
    button->setToolTip(tip);
    button->setFixedHeight(metrics::kControlHeight_px);
    return button;
}

}  // namespace

LabellingLayout::LabellingLayout(QWidget* view) {
    setSurface(view, SurfaceRole::Surface0);
    canvas = new PhotoCanvas(view);
    makeTools();
    toast = new Toast(canvas);
    toast->setBottomMargin(metrics::kPanelMargin_px);
    toast->setDuration(4000);
    thumbnails = new ThumbnailStrip(view);

    auto* column = new QVBoxLayout(view);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(makeHeader(view));
    column->addWidget(canvas, 1);
    column->addWidget(makeDecisionPanel(view));
    column->addWidget(thumbnails);
}

QWidget* LabellingLayout::makeHeader(QWidget* view) {
    header = new QWidget(view);
    setSurface(header, SurfaceRole::Surface1);
    title = new QLabel(header);
    title->setObjectName(QStringLiteral("photoTitle"));
    setTextRole(title, TextRole::Heading);
    detail = new QLabel(header);
    detail->setObjectName(QStringLiteral("photoDetail"));
    setTextRole(detail, TextRole::Muted);
    // The words may be cut rather than widen the window.
    detail->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    state = new StatusChip(header);
    state->setObjectName(QStringLiteral("photoState"));
    labeller = new QLabel(header);
    labeller->setObjectName(QStringLiteral("labeller"));
    setTextRole(labeller, TextRole::Muted);
    progress = new QLabel(header);
    progress->setObjectName(QStringLiteral("labellingProgress"));
    next = new QPushButton(QObject::tr("Next undecided  N"), header);
    next->setObjectName(QStringLiteral("nextUndecided"));
    next->setFocusPolicy(Qt::NoFocus);
    setButtonRole(next, ButtonRole::Normal);

    auto* row = new QHBoxLayout(header);
    row->setContentsMargins(metrics::kPanelMargin_px, 6, metrics::kPanelMargin_px, 6);
    row->setSpacing(metrics::kPanelMargin_px);
    row->addWidget(title);
    row->addWidget(state);
    row->addWidget(detail, 1);
    row->addWidget(labeller);
    row->addWidget(progress);
    row->addWidget(next);
    return header;
}

void LabellingLayout::makeTools() {
    tools = new QWidget(canvas);
    outline = makeTool(tools, "toggleOutline", Icon::Outline, QObject::tr("Where the candidate lies (O)"));
    contrast = makeTool(tools, "toggleContrast", Icon::Contrast,
                        QObject::tr("Stretch the contrast for looking; the photo itself stays as it is (C)"));
    zoom = makeTool(tools, "cycleZoom", Icon::Search,
                    QObject::tr("Fit, 1:1, 2:1 (Z); the wheel zooms at the cursor, the right button drags"));
    outline->setCheckable(true);
    contrast->setCheckable(true);
    outline->setText(QObject::tr("Outline  O"));
    contrast->setText(QObject::tr("Contrast  C"));
    // Wide enough for the longest text, so that the row does not jump while zooming.
    zoom->setMinimumWidth(zoom->fontMetrics().horizontalAdvance(QStringLiteral("1600 %  Z")) + 44);
    setSurface(tools, SurfaceRole::Surface1);
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(metrics::kStep_px, metrics::kStep_px, metrics::kStep_px, metrics::kStep_px);
    row->setSpacing(metrics::kStep_px);
    row->addWidget(outline);
    row->addWidget(contrast);
    row->addWidget(zoom);

    auto* over = new QVBoxLayout(canvas);
    over->setContentsMargins(metrics::kPanelMargin_px, metrics::kPanelMargin_px, metrics::kPanelMargin_px, 0);
    over->addWidget(tools, 0, Qt::AlignTop | Qt::AlignRight);
    over->addStretch(1);
    showTools();
}

QWidget* LabellingLayout::makeDecisionPanel(QWidget* view) {
    auto* panel = new QWidget(view);
    setSurface(panel, SurfaceRole::Surface1);
    prompt = new LabellerPrompt(panel);
    keyRow = new QWidget(panel);
    new FlowLayout(keyRow, 6);
    addAnother = new QPushButton(QObject::tr("Add another  A"), panel);
    addAnother->setObjectName(QStringLiteral("addAnother"));
    addAnother->setIcon(icon(Icon::Plus));
    addAnother->setCheckable(true);
    addAnother->setFocusPolicy(Qt::NoFocus);
    addAnother->setToolTip(
        QObject::tr("More than one thing on the photo: label keys add until Enter (or Shift + key)"));
    draftText = new QLabel(panel);
    draftText->setObjectName(QStringLiteral("draftText"));
    draftText->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    finish = new QPushButton(QObject::tr("Done  Enter"), panel);
    finish->setObjectName(QStringLiteral("finishDraft"));
    finish->setFocusPolicy(Qt::NoFocus);
    setButtonRole(finish, ButtonRole::Primary);
    comment = new QLineEdit(panel);
    comment->setObjectName(QStringLiteral("comment"));
    comment->setPlaceholderText(QObject::tr("Comment  M"));
    comment->setMaxLength(2000);
    comment->setFocusPolicy(Qt::ClickFocus);
    comment->setMinimumWidth(140);
    comment->setToolTip(QObject::tr("Kept with the decision. Enter goes back to the photo."));
    undo = new QPushButton(QObject::tr("Undo  Ctrl+Z"), panel);
    undo->setObjectName(QStringLiteral("undoDecision"));
    undo->setIcon(icon(Icon::Undo));
    undo->setFocusPolicy(Qt::NoFocus);
    setButtonRole(undo, ButtonRole::Normal);
    auto* row = new QHBoxLayout;
    row->setSpacing(2 * metrics::kStep_px);
    row->addWidget(addAnother);
    row->addWidget(draftText, 3);
    row->addWidget(finish);
    row->addWidget(comment, 3);
    row->addWidget(undo);
    auto* column = new QVBoxLayout(panel);
    column->setContentsMargins(metrics::kPanelMargin_px, 2 * metrics::kStep_px, metrics::kPanelMargin_px,
                               2 * metrics::kStep_px);
    column->setSpacing(2 * metrics::kStep_px);
    column->addWidget(prompt);
    column->addWidget(keyRow);
    column->addLayout(row);
    return panel;
}

void LabellingLayout::makeKeys(const LabelSet& labelSet, const LabelTaken& taken) {
    qDeleteAll(keys);
    keys.clear();
    for (const Label& label : labelSet.labels) {
        auto* key = new KeyCap(keyCapText(label), QString::fromStdString(label.name), keyRow);
        key->setObjectName(QStringLiteral("label:") + QString::fromStdString(label.name));
        key->setStatus(statusOf(label.kind));
        key->setFocusPolicy(Qt::NoFocus);
        QObject::connect(key, &KeyCap::clicked, keyRow, [taken, label] {
            taken(label, QApplication::keyboardModifiers().testFlag(Qt::ShiftModifier));
        });
        keyRow->layout()->addWidget(key);
        keys.push_back(key);
    }
}

void LabellingLayout::showHeader(const LabelPhoto& photo, PhotoState photoState, const Decision* decision) {
    title->setText(QString::fromStdString(photo.id));
    QStringList words = shownInWords(photo);
    if (!photo.waypointId.empty()) words << QObject::tr("from %1").arg(QString::fromStdString(photo.waypointId));
    if (photo.taken.milliseconds > 0) {
        words << QObject::tr("%1 UTC").arg(QString::fromStdString(toIso8601(photo.taken)).mid(11, 8));
    }
    detail->setText(words.join(QStringLiteral(" · ")));
    detail->setToolTip(detail->text());
    state->setStatus(fodscope::statusOf(photoState),
                     decision ? labelsInWords(decision->labels) : toWords(PhotoState::Undecided));
}

void LabellingLayout::showKeys(const std::vector<PhotoLabel>& given) {
    for (KeyCap* key : keys) {
        key->setChecked(std::any_of(given.begin(), given.end(), [key](const PhotoLabel& label) {
            return QString::fromStdString(label.label) == key->text();
        }));
    }
}

void LabellingLayout::showDraft(const LabelDraft& draft, bool addingAnother, const QString& done) {
    QString text;
    if (draft.openBox) {
        text = QObject::tr("Press its label");
    } else if (!draft.labels.empty()) {
        text = QObject::tr("So far: %1").arg(labelsInWords(draft.labels));
    } else if (addingAnother) {
        text = QObject::tr("A label for each thing, then Enter");
    }
    if (text.isEmpty()) text = done;
    draftText->setText(text);
    draftText->setToolTip(text);
    finish->setVisible(!draft.labels.empty());
}

void LabellingLayout::showTools() {
    outline->setChecked(canvas->outlineShown());
    contrast->setChecked(canvas->contrast());
    zoom->setText(QObject::tr("%1  Z").arg(canvas->zoomInWords()));
}

void LabellingLayout::showLabeller(const QString& name) {
    prompt->setVisible(name.isEmpty());
    keyRow->setVisible(true);
    labeller->setText(name.isEmpty() ? QString() : QObject::tr("by %1").arg(name));
    labeller->setVisible(!name.isEmpty());
}

}  // namespace fodscope
