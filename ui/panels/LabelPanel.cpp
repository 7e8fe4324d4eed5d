// SPDX-License-Identifier: MIT
#include "ui/panels/LabelPanel.h"

#include <QLineEdit>
#include <algorithm>

#include "ui/commands/CommandSet.h"
#include "ui/panels/Format.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/NumberReadout.h"

namespace fodscope {
namespace {

struct LabelCounts {
    int undecided = 0;
    int notSure = 0;
    int noFod = 0;
    int fod = 0;
};

bool holds(const Decision& decision, const LabelSet& labels, LabelKind kind) {
    return std::ranges::any_of(decision.labels, [&](const PhotoLabel& given) {
        const Label* label = labels.find(given.label);
        return label != nullptr && label->kind == kind;
    });
}

LabelCounts countsOf(const InspectionState& state, const std::string& labeller) {
    LabelCounts counts;
    for (const Photo& photo : state.photos) {
        const Decision* decision = lastDecision(state.decisions, photo.id, labeller);
        if (decision == nullptr)
            ++counts.undecided;
        else if (holds(*decision, state.labelSet, LabelKind::Fod))
            ++counts.fod;
        else if (holds(*decision, state.labelSet, LabelKind::NotSure))
            ++counts.notSure;
        else
            ++counts.noFod;
    }
    return counts;
}

}  // namespace

LabelPanel::LabelPanel(InspectionController& controller, const CommandSet& commands, QWidget* parent)
    : PanelColumn(parent), controller_(controller) {
    setObjectName(QStringLiteral("panel.label"));
    auto* progress = new Card(tr("Photos"), this);
    left_ = new NumberReadout(tr("still to label"), progress);
    left_->setObjectName(QStringLiteral("label.left"));
    counts_ = new FieldList(progress);
    progress->body()->addWidget(left_);
    progress->body()->addWidget(counts_);
    progress->body()->addWidget(commands.makeButton(QStringLiteral("label.next"), progress));
    column()->addWidget(progress);

    auto* who = new Card(tr("Labeller"), this);
    labeller_ = new QLineEdit(who);
    labeller_->setObjectName(QStringLiteral("label.labeller"));
    labeller_->setPlaceholderText(tr("Your name, kept with each decision"));
    who->body()->addWidget(labeller_);
    who->body()->addWidget(makeText(tr("You see your own decisions only. Another reader enters another name and starts "
                                       "with nothing decided."),
                                    TextRole::Caption, who));
    column()->addWidget(who);

    auto* labels = new Card(tr("Label set"), this);
    set_ = new FieldList(labels);
    labels->body()->addWidget(set_);
    labels->body()->addWidget(commands.makeButton(QStringLiteral("label.set"), labels));
    column()->addWidget(labels);
    column()->addStretch();

    connect(labeller_, &QLineEdit::editingFinished, this,
            [this] { controller_.setLabeller(labeller_->text().trimmed()); });
    for (const auto signal : {&InspectionController::sessionChanged, &InspectionController::photosChanged,
                              &InspectionController::decisionsChanged, &InspectionController::labelSetChanged,
                              &InspectionController::labellerChanged})
        connect(&controller, signal, this, &LabelPanel::refresh);
    refresh();
}

void LabelPanel::refresh() {
    const InspectionState& state = controller_.state();
    if (!labeller_->hasFocus()) labeller_->setText(controller_.labeller());
    const LabelCounts counts = countsOf(state, controller_.labeller().toStdString());
    left_->setNumber(QString::number(counts.undecided), tr("of %1").arg(state.photos.size()));
    counts_->setFields({{tr("FOD"), QString::number(counts.fod)},
                        {tr("No FOD"), QString::number(counts.noFod)},
                        {tr("Not sure"), QString::number(counts.notSure)}});
    set_->setFields(
        {{tr("Name"), state.labelSet.name.empty() ? tr("none") : QString::fromStdString(state.labelSet.name)},
         {tr("Labels"), QString::number(state.labelSet.labels.size())}});
}

}  // namespace fodscope
