// SPDX-License-Identifier: MIT
#include "ui/panels/CovarianceCard.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/inspection/ParameterTable.h"
#include "ui/commands/CommandSet.h"
#include "ui/session/InspectionController.h"
#include "ui/settings/ParameterForm.h"

namespace fodscope {
namespace {

/// What the chosen neighbourhood and weights leave without effect is not asked for.
bool matters(const ParameterField& field, const Parameters& parameters) {
    const SmoothingSettings& smoothing = parameters.reference.covariance.smoothing;
    const bool isBall = smoothing.neighbourhood == SmoothingNeighbourhood::Ball;
    if (field.key == "covariance_neighbours") return !isBall;
    if (field.key == "covariance_radius_m") return isBall;
    if (field.key == "covariance_sigma_m") return smoothing.weights == SmoothingWeights::Gaussian;
    return true;
}

}  // namespace

std::string referencePresetOf(const Parameters& parameters) {
    for (const std::string& name : presetNames())
        if (presetParameters(name).reference == parameters.reference) return name;
    return {};
}

CovarianceCard::CovarianceCard(InspectionController& controller, const CommandSet& commands, QWidget* parent)
    : Card(tr("How covariances are fitted"), parent), controller_(controller) {
    setObjectName(QStringLiteral("reference.covariances"));
    setCaption(tr("For the next reference that is made from maps."));
    auto* row = new QFormLayout;
    preset_ = new QComboBox(this);
    preset_->setObjectName(QStringLiteral("reference.preset"));
    for (const std::string& name : presetNames())
        preset_->addItem(QString::fromStdString(name), QString::fromStdString(name));
    preset_->addItem(tr("own values"), QString());
    preset_->setToolTip(
        tr("paper-physical: mean over the 250 nearest points. paper-simulation: Gaussian of 5 cm in a "
           "ball of 20 cm"));
    row->addRow(tr("Preset"), preset_);
    body()->addLayout(row);
    body()->addWidget(new ParameterForm(controller, kReferenceSection,
                                        {"covariance_weights", "covariance_sigma_m", "covariance_neighbourhood",
                                         "covariance_neighbours", "covariance_radius_m", "covariance_voxel_size_m"},
                                        matters, this));
    body()->addWidget(commands.makeButton(QStringLiteral("reference.again"), this));
    setCollapsible(true);
    setCollapsed(true);
    connect(preset_, QOverload<int>::of(&QComboBox::activated), this, &CovarianceCard::usePreset);
    connect(&controller, &InspectionController::parametersChanged, this, &CovarianceCard::refresh);
    connect(&controller, &InspectionController::sessionChanged, this, &CovarianceCard::refresh);
    refresh();
}

void CovarianceCard::refresh() {
    preset_->setCurrentIndex(
        preset_->findData(QString::fromStdString(referencePresetOf(controller_.state().parameters))));
}

void CovarianceCard::usePreset() {
    const std::string name = preset_->currentData().toString().toStdString();
    Parameters parameters = controller_.state().parameters;
    if (!name.empty()) parameters.reference = presetParameters(name).reference;
    controller_.applyParameters(parameters);
    refresh();
}

}  // namespace fodscope
