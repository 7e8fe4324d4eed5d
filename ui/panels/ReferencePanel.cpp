// SPDX-License-Identifier: MIT
#include "ui/panels/ReferencePanel.h"

#include <QComboBox>
#include <algorithm>
#include <cmath>

#include "core/reference/LogDeterminant.h"
#include "ui/commands/CommandSet.h"
#include "ui/panels/CovarianceCard.h"
#include "ui/panels/Format.h"
#include "ui/widgets/Card.h"

namespace fodscope {
namespace {

constexpr int kShownLines = 9;

std::vector<std::pair<QString, QString>> factsOf(const InspectionState& state) {
    const ReferenceMap& reference = *state.reference;
    std::vector<std::pair<QString, QString>> facts;
    if (state.referenceSource) facts.emplace_back(QObject::tr("From"), fileNameOf(*state.referenceSource));
    facts.emplace_back(QObject::tr("Points"), count(reference.size()));
    if (!reference.hasCovariance()) {
        facts.emplace_back(QObject::tr("Covariances"), QObject::tr("no: only the Euclidean discrepancy is known"));
        return facts;
    }
    std::size_t samples = 0;
    for (const std::int32_t n : reference.sampleCount)
        samples += static_cast<std::size_t>(std::max(n, 0));
    if (samples > 0) facts.emplace_back(QObject::tr("Samples"), count(samples));
    const auto values = logDeterminants(reference);
    const auto untrained =
        static_cast<std::size_t>(std::ranges::count_if(values, [](double value) { return std::isnan(value); }));
    if (const auto range = heatMapRange(values))
        facts.emplace_back(
            QObject::tr("Maps vary by"),
            QObject::tr("%1 to %2 (8 of 10 points)").arg(spreadText(range->low), spreadText(range->high)));
    facts.emplace_back(
        QObject::tr("Without training"),
        untrained == 0 ? QObject::tr("none")
                       : QObject::tr("%1 points (%2): no Mahalanobis there")
                             .arg(count(untrained),
                                  percent(static_cast<double>(untrained) / static_cast<double>(reference.size()), 1)));
    return facts;
}

}  // namespace

ReferencePanel::ReferencePanel(InspectionController& controller, const CommandSet& commands, QWidget* parent)
    : PanelColumn(parent), controller_(controller) {
    setObjectName(QStringLiteral("panel.reference"));
    auto* source = new Card(tr("Reference"), this);
    hint_ = makeText(tr("What the space looks like without debris. Drop files here, or choose one of these."),
                     TextRole::Muted, source);
    source->body()->addWidget(hint_);
    for (const char* id : {"reference.nominal", "reference.meshmaps", "reference.mesh", "reference.load"})
        source->body()->addWidget(commands.makeButton(QString::fromLatin1(id), source));
    auto* unitRow = new QHBoxLayout;
    auto* unitLabel = new QLabel(tr("Meshes are in"), source);
    setTextRole(unitLabel, TextRole::Muted);
    meshUnit_ = new QComboBox(source);
    meshUnit_->setObjectName(QStringLiteral("reference.meshUnit"));
    meshUnit_->addItem(tr("metres"), 1.0);
    meshUnit_->addItem(tr("millimetres"), 0.001);
    meshUnit_->addItem(tr("centimetres"), 0.01);
    meshUnit_->addItem(tr("inches"), 0.0254);
    unitRow->addWidget(unitLabel);
    unitRow->addWidget(meshUnit_, 1);
    source->body()->addLayout(unitRow);
    column()->addWidget(source);

    facts_ = new Card(tr("What it is made of"), this);
    fields_ = new FieldList(facts_);
    fields_->setObjectName(QStringLiteral("reference.facts"));
    facts_->body()->addWidget(fields_);
    made_ = makeText({}, TextRole::Caption, facts_);
    facts_->body()->addWidget(made_);
    facts_->body()->addWidget(commands.makeButton(QStringLiteral("reference.heatmap"), facts_));
    column()->addWidget(facts_);
    column()->addWidget(new CovarianceCard(controller, commands, this));
    column()->addStretch();

    connect(meshUnit_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
            [this] { controller_.setMeshScale(meshUnit_->currentData().toDouble()); });
    connect(&controller, &InspectionController::sessionChanged, this, &ReferencePanel::refresh);
    connect(&controller, &InspectionController::referenceChanged, this, &ReferencePanel::refresh);
    refresh();
}

void ReferencePanel::refresh() {
    const InspectionState& state = controller_.state();
    facts_->setVisible(state.reference != nullptr);
    hint_->setVisible(state.reference == nullptr);
    if (!state.reference) return;
    fields_->setFields(factsOf(state));
    QStringList lines;
    for (const std::string& line : state.reference->provenance)
        lines << QString::fromStdString(line);
    QStringList shown = lines.mid(0, kShownLines);
    if (const int left = lines.size() - shown.size(); left > 0) shown << tr("and %n more", nullptr, left);
    made_->setText(shown.join(QLatin1Char('\n')));
    made_->setToolTip(lines.join(QLatin1Char('\n')));
    made_->setVisible(!lines.isEmpty());
}

}  // namespace fodscope
