// SPDX-License-Identifier: MIT
#include "ui/panels/PoseList.h"

#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/registration/Registration.h"
#include "ui/panels/Format.h"
#include "ui/panels/PanelParts.h"
#include "ui/session/InspectionController.h"

namespace fodscope {

std::vector<PoseChoice> poseChoices(const RegistrationResult& registration) {
    std::vector<PoseChoice> choices;
    if (registration.alternatives.empty()) return choices;
    choices.push_back({registration.T_reference_from_map, registration.overlap, registration.rms_m});
    for (const PoseAlternative& other : registration.alternatives)
        choices.push_back({other.T_reference_from_map, other.overlap, other.rms_m});
    return choices;
}

PoseList::PoseList(InspectionController& controller, QWidget* parent) : QWidget(parent), controller_(controller) {
    setObjectName(QStringLiteral("map.poses"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(makeText(tr("Which of these is true? Click one to see the map there. Only somebody who knows "
                                  "where the robot started can tell."),
                               TextRole::Body, this));
    list_ = new QListWidget(this);
    list_->setObjectName(QStringLiteral("map.poses.list"));
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
    list_->setWordWrap(true);
    use_ = new QPushButton(tr("Use this one"), this);
    use_->setObjectName(QStringLiteral("map.poses.use"));
    setButtonRole(use_, ButtonRole::Primary);
    column->addWidget(list_);
    column->addWidget(use_);
    connect(list_, &QListWidget::currentRowChanged, this, &PoseList::preview);
    connect(use_, &QPushButton::clicked, this, &PoseList::use);
    hide();
}

void PoseList::setChoices(std::vector<PoseChoice> choices) {
    choices_ = std::move(choices);
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (std::size_t i = 0; i < choices_.size(); ++i) {
        const PoseChoice& choice = choices_[i];
        list_->addItem(tr("%1   %2\n%3 overlap · %4 rms")
                           .arg(i + 1)
                           .arg(originText(poseFromTransform(choice.T_reference_from_map)), percent(choice.overlap),
                                millimetres(choice.rms_m)));
    }
    setVisible(!choices_.empty());
    preview(-1);
}

void PoseList::preview(int row) {
    const bool chosen = row >= 0 && row < static_cast<int>(choices_.size());
    const bool frozen = controller_.candidatesAreFrozen();
    use_->setEnabled(chosen && !frozen);
    use_->setToolTip(frozen    ? tr("Not now: the visits have begun")
                     : !chosen ? tr("Not now: choose one of the poses above")
                               : tr("Aligns the map from this pose and detects"));
    controller_.previewPose(chosen ? std::optional(choices_[static_cast<std::size_t>(row)].T_reference_from_map)
                                   : std::nullopt);
}

void PoseList::use() {
    const int row = list_->currentRow();
    if (row < 0 || row >= static_cast<int>(choices_.size())) return;
    controller_.setStartPose(choices_[static_cast<std::size_t>(row)].T_reference_from_map);
}

}  // namespace fodscope
