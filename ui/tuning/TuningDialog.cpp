// SPDX-License-Identifier: MIT
#include "ui/tuning/TuningDialog.h"

#include <QComboBox>
#include <QDir>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/panels/Format.h"
#include "ui/panels/PanelParts.h"
#include "ui/session/FileDialogs.h"
#include "ui/session/InspectionController.h"
#include "ui/session/ParameterUse.h"
#include "ui/tuning/CostSurface.h"
#include "ui/tuning/TuningValues.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/ValueSlider.h"

namespace fodscope {
namespace {

constexpr int kLeftWidth_px = 320;

AxisStyle thresholdAxis(Metric metric) {
    if (metric == Metric::Euclidean) return {QObject::tr("threshold"), QStringLiteral("mm"), 1000.0, 1};
    return {QObject::tr("threshold"), {}, 1.0, metric == Metric::Mahalanobis ? 2 : 0};
}

QString taskName() {
    return QObject::tr("searching parameters");
}

bool holds(const MeasuredTrials& measured, Metric metric) {
    return std::ranges::all_of(measured.trials,
                               [&](const SearchTrial& trial) { return !trial.field || trial.field->has(metric); });
}

}  // namespace

TuningDialog::TuningDialog(InspectionController& controller, FileDialogs& files, QWidget* parent)
    : QDialog(parent), controller_(controller), files_(files) {
    setObjectName(QStringLiteral("tuning"));
    setWindowTitle(tr("Find parameters from trials"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* row = new QHBoxLayout;
    row->setSpacing(0);
    row->addWidget(makeLeft());
    auto* edge = new QFrame(this);
    edge->setFrameShape(QFrame::VLine);
    row->addWidget(edge);
    row->addWidget(makeRight(), 1);
    column->addLayout(row, 1);
    auto* line = new QFrame(this);
    line->setFrameShape(QFrame::HLine);
    column->addWidget(line);
    column->addWidget(makeBottom());
    resize(1080, 660);
    connect(&controller.tasks(), &TaskRunner::progressed, this, &TuningDialog::showTask);
    connect(&controller.tasks(), &TaskRunner::failed, this, [this](const QString& task, const QString& sentence) {
        if (searching_ && task == taskName()) endTask(sentence, true);
    });
    connect(&controller.tasks(), &TaskRunner::cancelled, this, [this] {
        if (searching_) endTask(tr("Cancelled. What was found before is kept."), false);
    });
    for (const auto signal : {&InspectionController::sessionChanged, &InspectionController::referenceChanged,
                              &InspectionController::parametersChanged, &InspectionController::visitsChanged})
        connect(&controller, signal, this, &TuningDialog::takeInspection);
    takeInspection();
}

TuningDialog::~TuningDialog() = default;

QWidget* TuningDialog::makeLeft() {
    auto* left = new PanelColumn(this, kLeftWidth_px);
    left->setFixedWidth(kLeftWidth_px + 16);
    auto* trials = new Card(tr("Trials"), left);
    auto* folder = new QPushButton(tr("Choose a folder of trials…"), trials);
    folder->setObjectName(QStringLiteral("tuning.folder"));
    folder->setAutoDefault(false);
    folder->setToolTip(tr("Maps NAME.pcd with known FOD in NAME.json, as fodscope-cli simulate writes them"));
    trialsText_ = makeText(tr("Maps of this space whose FOD is known. Every setting is tried on all of them."),
                           TextRole::Muted, trials);
    trialsText_->setObjectName(QStringLiteral("tuning.trials"));
    trials->body()->addWidget(folder);
    trials->body()->addWidget(trialsText_);
    left->column()->addWidget(trials);

    auto* search = new Card(tr("Search"), left);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(12);
    metric_ = new QComboBox(search);
    metric_->setObjectName(QStringLiteral("tuning.metric"));
    lambda_ = new QLineEdit(QString::number(kUnassociatedWeight_m), search);
    lambda_->setObjectName(QStringLiteral("tuning.lambda"));
    lambda_->setToolTip(tr("λ: how many metres of distance one superfluous candidate is worth. The paper has 0.05 m"));
    form->addRow(tr("Metric"), metric_);
    form->addRow(tr("λ (m)"), lambda_);
    search->body()->addLayout(form);
    search_ = new QPushButton(tr("Search"), search);
    search_->setObjectName(QStringLiteral("tuning.search"));
    search_->setAutoDefault(false);
    setButtonRole(search_, ButtonRole::Primary);
    cancel_ = new QPushButton(tr("Cancel the search"), search);
    cancel_->setObjectName(QStringLiteral("tuning.cancel"));
    cancel_->setAutoDefault(false);
    progress_ = new QProgressBar(search);
    progress_->setTextVisible(false);
    stage_ = makeText({}, TextRole::Caption, search);
    stage_->setObjectName(QStringLiteral("tuning.stage"));
    for (QWidget* widget : {static_cast<QWidget*>(search_), static_cast<QWidget*>(cancel_),
                            static_cast<QWidget*>(progress_), static_cast<QWidget*>(stage_)})
        search->body()->addWidget(widget);
    left->column()->addWidget(search);

    auto* values = new Card(tr("Values"), left);
    values_ = new TuningValues(values);
    values->body()->addWidget(values_);
    left->column()->addWidget(values);
    left->column()->addStretch();
    connect(folder, &QPushButton::clicked, this, [this] {
        const QString chosen = files_.chooseFolder(this, tr("Folder of trials"), folder_);
        if (!chosen.isEmpty()) chooseFolder(chosen);
    });
    connect(search_, &QPushButton::clicked, this, &TuningDialog::search);
    connect(cancel_, &QPushButton::clicked, this, [this] { controller_.tasks().cancel(); });
    connect(lambda_, &QLineEdit::textEdited, this, &TuningDialog::refresh);
    connect(metric_, QOverload<int>::of(&QComboBox::activated), this, &TuningDialog::refresh);
    return left;
}

QWidget* TuningDialog::makeRight() {
    auto* right = new QWidget(this);
    setSurface(right, SurfaceRole::Surface1);
    auto* column = new QVBoxLayout(right);
    column->setContentsMargins(metrics::kPanelMargin_px, metrics::kPanelMargin_px, metrics::kPanelMargin_px,
                               metrics::kPanelMargin_px);
    surface_ = new CostSurface(right);
    surface_->setObjectName(QStringLiteral("tuning.surface"));
    reading_ = makeText({}, TextRole::Body, right);
    reading_->setObjectName(QStringLiteral("tuning.reading"));
    leastPoints_ =
        new ValueSlider(tr("Least points of a candidate"), {0.0, 9.0, 1.0, 3.0, tr("voxels"), 1.0, 0}, right);
    leastPoints_->setObjectName(QStringLiteral("tuning.leastPoints"));
    leastPoints_->setHelp(tr("The picture shows the costs at this count; the colours mean the same at every count."));
    column->addWidget(surface_, 1);
    column->addWidget(reading_);
    column->addWidget(leastPoints_);
    connect(surface_, &CostSurface::cellHovered, this, &TuningDialog::read);
    connect(surface_, &CostSurface::cellChosen, this, &TuningDialog::choose);
    connect(leastPoints_, &ValueSlider::valueChanging, this, &TuningDialog::showLeastPoints);
    connect(leastPoints_, &ValueSlider::valueCommitted, this, &TuningDialog::showLeastPoints);
    return right;
}

QWidget* TuningDialog::makeBottom() {
    auto* bottom = new QWidget(this);
    auto* row = new QHBoxLayout(bottom);
    row->setContentsMargins(metrics::kPanelMargin_px, metrics::kPanelMargin_px, metrics::kPanelMargin_px,
                            metrics::kPanelMargin_px);
    row->setSpacing(2 * metrics::kStep_px);
    row->addStretch();
    const auto button = [&](const QString& text, const char* name) {
        auto* made = new QPushButton(text, bottom);
        made->setObjectName(QString::fromLatin1(name));
        made->setAutoDefault(false);
        row->addWidget(made);
        return made;
    };
    auto* close = button(tr("Close"), "tuning.close");
    close->setToolTip(tr("Esc. A search under way goes on"));
    best_ = button(tr("Back to the best"), "tuning.best");
    best_->setToolTip(tr("Chooses the values of least cost again (Home in the picture)"));
    use_ = button(tr("Use these"), "tuning.use");
    setButtonRole(use_, ButtonRole::Primary);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(best_, &QPushButton::clicked, this, [this] {
        if (!outcome_) return;
        chosen_ = outcome_->result.best;
        leastPoints_->setValue(outcome_->result.leastPoints[chosen_.leastPoints]);
        showLeastPoints();
        choose({chosen_.cutoff, chosen_.threshold});
    });
    connect(use_, &QPushButton::clicked, this, &TuningDialog::use);
    return bottom;
}

void TuningDialog::takeInspection() {
    if (!controller_.isOpen()) hide();
    const auto& reference = controller_.state().reference;
    const QVariant kept = metric_->currentData();
    metric_->clear();
    if (reference && reference->hasCovariance())
        metric_->addItem(tr("Mahalanobis"), static_cast<int>(Metric::Mahalanobis));
    metric_->addItem(tr("Euclidean"), static_cast<int>(Metric::Euclidean));
    metric_->addItem(tr("Chi-square"), static_cast<int>(Metric::ChiSquare));
    const int index = metric_->findData(
        kept.isValid() ? kept : QVariant(static_cast<int>(controller_.state().parameters.candidates.metric)));
    metric_->setCurrentIndex(std::max(0, index));
    refresh();
}

void TuningDialog::chooseFolder(const QString& folder) {
    trials_ = 0;
    folder_ = folder;
    bool isProblem = false;
    QString text;
    try {
        const std::vector<Trial> all = readTrials(folder.toStdString());
        const auto nominal = static_cast<std::size_t>(std::ranges::count_if(all, &Trial::isNominal));
        trials_ = all.size() - nominal;
        text = tr("%1: %2 with FOD").arg(QDir(folder).dirName(), counted(trials_, tr("trial"), tr("trials")));
        if (nominal > 0)
            text += tr(", %1 left out").arg(counted(nominal, tr("map without FOD"), tr("maps without FOD")));
    } catch (const std::exception& error) {
        text = sentenceOf(error);
        isProblem = true;
    }
    trialsText_->setText(text);
    trialsText_->setProperty("problem", isProblem);
    trialsText_->style()->unpolish(trialsText_);
    trialsText_->style()->polish(trialsText_);
    refresh();
}

std::optional<double> TuningDialog::lambda_m() const {
    bool isNumber = false;
    const double value = lambda_->text().trimmed().replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&isNumber);
    if (!isNumber || !std::isfinite(value) || value < 0.0) return std::nullopt;
    return value;
}

QString TuningDialog::searchObstacle() const {
    if (!controller_.state().reference) return tr("load a reference first, in step 1");
    if (folder_.isEmpty()) return tr("choose a folder of trials first");
    if (trials_ == 0) return tr("the folder holds no trial with FOD");
    if (!lambda_m()) return tr("λ must be a number of metres, 0 or more");
    if (searching_) return tr("a search is under way");
    return {};
}

QString TuningDialog::useObstacle() const {
    if (!outcome_) return tr("search first");
    if (controller_.candidatesAreFrozen()) return tr("the visits have begun, so candidates keep their ids");
    if (settingsAt(outcome_->result, chosen_) == controller_.state().parameters.candidates)
        return tr("these values are in effect");
    return {};
}

void TuningDialog::refresh() {
    const QString obstacle = searchObstacle();
    search_->setEnabled(obstacle.isEmpty());
    search_->setToolTip(obstacle.isEmpty() ? tr("Tries 30 cutoffs, 20 thresholds and 10 counts of least points on "
                                                "every trial")
                                           : tr("Cannot search: %1").arg(obstacle));
    search_->setVisible(!searching_);
    cancel_->setVisible(searching_);
    progress_->setVisible(searching_);
    lambda_->setProperty("invalid", !lambda_m());
    lambda_->style()->unpolish(lambda_);
    lambda_->style()->polish(lambda_);
    const QString hindrance = useObstacle();
    use_->setEnabled(hindrance.isEmpty());
    use_->setToolTip(hindrance.isEmpty() ? tr("The chosen values become those of the inspection; can be undone")
                                         : tr("Not now: %1").arg(hindrance));
    best_->setEnabled(outcome_ && !(chosen_ == outcome_->result.best));
    leastPoints_->setEnabled(outcome_.has_value());
    if (outcome_) {
        const CandidateSettings& now = controller_.state().parameters.candidates;
        if (now.metric == outcome_->result.settings.metric) surface_->setCurrent(now.clusterCutoff_m, now.threshold);
    }
}

void TuningDialog::search() {
    TuningRequest request;
    request.folder = folder_.toStdString();
    request.reference = controller_.state().reference;
    request.parameters = controller_.state().parameters;
    const CandidateSettings& now = request.parameters.candidates;
    request.search.metric = static_cast<Metric>(metric_->currentData().toInt());
    request.search.linkage = now.linkage;
    request.search.centroid = now.centroid;
    request.search.lambda_m = lambda_m().value_or(kUnassociatedWeight_m);
    Parameters sameCandidates = measuredParameters_;
    sameCandidates.candidates = now;
    if (outcome_ && measuredFolder_ == folder_ && measuredReference_ == request.reference &&
        sameFor(ParameterUse::Detection, sameCandidates, request.parameters) &&
        holds(*outcome_->measured, request.search.metric) && holds(*outcome_->measured, now.metric))
        request.measured = outcome_->measured;
    searching_ = true;
    stage_->clear();
    refresh();
    controller_.tasks().run(taskName(), [this, request](Progress& progress) -> TaskRunner::Adopt {
        const auto outcome = std::make_shared<const TuningOutcome>(runTuning(request, progress));
        return [this, request, outcome] {
            measuredFolder_ = QString::fromStdString(request.folder.string());
            measuredReference_ = request.reference;
            measuredParameters_ = request.parameters;
            endTask({}, false);
            showOutcome(*outcome);
        };
    });
}

void TuningDialog::showTask(const TaskReport& report) {
    if (!searching_ || controller_.tasks().currentTask() != taskName()) return;
    progress_->setRange(0, report.fraction < 0.0 ? 0 : 1000);
    progress_->setValue(static_cast<int>(report.fraction * 1000.0));
    stage_->setText(report.stage);
}

void TuningDialog::endTask(const QString& sentence, bool isProblem) {
    searching_ = false;
    stage_->setText(sentence);
    stage_->setProperty("problem", isProblem);
    stage_->style()->unpolish(stage_);
    stage_->style()->polish(stage_);
    refresh();
}

void TuningDialog::showOutcome(const TuningOutcome& outcome) {
    outcome_ = outcome;
    const ParameterSearchResult& result = outcome_->result;
    chosen_ = result.best;
    QString told =
        tr("%1 settings in %2").arg(count(result.costs.size()), counted(result.trialCount, tr("trial"), tr("trials")));
    for (const auto& [name, reason] : outcome_->measured->failures)
        told += tr(". %1 counts as without candidates: %2")
                    .arg(QString::fromStdString(name), QString::fromStdString(reason));
    stage_->setText(told);
    values_->setInEffect(outcome_->inEffect, outcome_->costInEffect);
    surface_->setAxes({tr("cluster cutoff"), QStringLiteral("cm"), 100.0, 0}, thresholdAxis(result.settings.metric));
    leastPoints_->setRange({static_cast<double>(result.leastPoints.front()),
                            static_cast<double>(result.leastPoints.back()), 1.0, 3.0, tr("voxels"), 1.0, 0});
    leastPoints_->setValue(result.leastPoints[chosen_.leastPoints]);
    showLeastPoints();
    choose({chosen_.cutoff, chosen_.threshold});
}

std::size_t TuningDialog::leastIndex() const {
    const std::vector<int>& counts = outcome_->result.leastPoints;
    const auto wanted = std::ranges::find(counts, static_cast<int>(std::lround(leastPoints_->value())));
    return wanted == counts.end() ? 0 : static_cast<std::size_t>(wanted - counts.begin());
}

void TuningDialog::showLeastPoints() {
    if (!outcome_) return;
    const CostGrid grid = costGridOf(outcome_->result, leastIndex());
    surface_->setGrid(grid, costRangeOf(outcome_->result));
    surface_->setBest(cheapestCell(grid));
    choose({chosen_.cutoff, chosen_.threshold});
    read(std::nullopt);
}

void TuningDialog::choose(const CostCell& cell) {
    if (!outcome_) return;
    const ParameterSearchResult& result = outcome_->result;
    chosen_ = {cell.cutoff, cell.threshold, leastIndex()};
    surface_->setChosen(cell);
    values_->setChosen(chosen_ == result.best ? tr("best") : tr("chosen"), settingsAt(result, chosen_),
                       result.at(chosen_));
    refresh();
}

void TuningDialog::read(const std::optional<CostCell>& cell) {
    if (!outcome_) return;
    const ParameterSearchResult& result = outcome_->result;
    if (!cell) {
        reading_->setText(tr("Point at a place to read it. Dark is good: few metres of cost."));
        return;
    }
    const GridPoint point{cell->cutoff, cell->threshold, leastIndex()};
    const SearchCost& cost = result.at(point);
    reading_->setText(tr("Cutoff %1, threshold %2: cost %3 m, distance %4 m, %5 unassociated of %6 candidates a trial")
                          .arg(centimetres(result.cutoffs_m[point.cutoff]),
                               discrepancyText(result.thresholds[point.threshold], result.settings.metric),
                               QLocale().toString(cost.cost, 'f', 3), QLocale().toString(cost.distance_m, 'f', 3),
                               QLocale().toString(cost.unassociatedCandidates, 'f', 1),
                               QLocale().toString(cost.candidates, 'f', 1)));
}

void TuningDialog::use() {
    if (outcome_) controller_.commitCandidates(settingsAt(outcome_->result, chosen_));
}

}  // namespace fodscope
