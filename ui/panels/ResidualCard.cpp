// SPDX-License-Identifier: MIT
#include "ui/panels/ResidualCard.h"

#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/commands/CommandSet.h"
#include "ui/panels/Format.h"
#include "ui/panels/PanelParts.h"
#include "ui/session/InspectionController.h"

namespace fodscope {
namespace {

constexpr std::size_t kShownRegions = 6;
/// Less than this is what a depth camera cannot tell.
constexpr double kLeastOffset_m = 0.005;

}  // namespace

ResidualCard::ResidualCard(InspectionController& controller, const CommandSet& commands, QWidget* parent)
    : Card(tr("Residuals by region"), parent), controller_(controller), commands_(commands) {
    setObjectName(QStringLiteral("map.residuals"));
    sentence_ = makeText({}, TextRole::Muted, this);
    sentence_->setObjectName(QStringLiteral("map.residuals.sentence"));
    list_ = new QListWidget(this);
    list_->setObjectName(QStringLiteral("map.residuals.list"));
    list_->setWordWrap(true);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
    list_->setToolTip(tr("Click to fly there"));
    body()->addWidget(commands.makeButton(QStringLiteral("map.residuals"), this));
    body()->addWidget(sentence_);
    body()->addWidget(list_);
    connect(list_, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) { flyTo(list_->row(item)); });
    connect(list_, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) { flyTo(list_->row(item)); });
    connect(&controller, &InspectionController::residualsChanged, this, &ResidualCard::refresh);
    connect(&controller, &InspectionController::sessionChanged, this, &ResidualCard::refresh);
    refresh();
}

void ResidualCard::refresh() {
    list_->clear();
    regions_.clear();
    const auto residuals = controller_.residuals();
    setVisible(residuals != nullptr);
    if (!residuals) return;
    regions_ = worstRegions(*residuals, kShownRegions, kLeastOffset_m);
    for (const std::size_t region : regions_)
        list_->addItem(QString::fromStdString(regionInWords(residuals->regions[region])));
    const auto seen = static_cast<std::size_t>(std::ranges::count_if(residuals->regions, &RegionResidual::isMeasured));
    const QString observed = tr("%1 of %2 regions of half a metre show enough surface to be measured.")
                                 .arg(count(seen), count(residuals->regions.size()));
    sentence_->setText(regions_.empty()
                           ? tr("No region is off by %1 or more. %2").arg(millimetres(kLeastOffset_m), observed)
                           : tr("%1 The farthest off:").arg(observed));
    list_->setVisible(!regions_.empty());
}

void ResidualCard::flyTo(int row) {
    const auto residuals = controller_.residuals();
    if (!residuals || row < 0 || row >= static_cast<int>(regions_.size())) return;
    Command* colours = commands_.find(QStringLiteral("map.residuals"));
    if (!colours->isChecked()) colours->trigger();
    const auto& bounds = residuals->regions[regions_[static_cast<std::size_t>(row)]].bounds_reference;
    controller_.flyToPlace(bounds.center(), std::max(0.6, 0.5 * bounds.diagonal().norm()));
}

}  // namespace fodscope
