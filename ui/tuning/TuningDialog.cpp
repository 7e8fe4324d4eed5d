// SPDX-License-Identifier: MIT
#include "ui/tuning/TuningDialog.h"

#include <QDir>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "ui/panels/Format.h"
#include "ui/panels/PanelParts.h"
#include "ui/session/FileDialogs.h"
#include "ui/session/InspectionController.h"
#include "ui/session/ParameterUse.h"
#include "ui/tuning/CostPage.h"
#include "ui/tuning/PhotoPage.h"
#include "ui/tuning/TuningOptions.h"
#include "ui/tuning/TuningValues.h"
#include "ui/widgets/Card.h"

namespace fodscope {
namespace {

constexpr int kLeftWidth_px = 320;

QString taskName() {
    return QObject::tr("searching parameters");
}

void markProblem(QWidget* widget, bool on) {
    widget->setProperty("problem", on);
    widget->style()->unpolish(widget);
    widget->style()->polish(widget);
}

/// How many settings a search tries.
std::size_t settingCount(const ParameterSearchSettings& grid) {
    return static_cast<std::size_t>(grid.cutoffCount) * static_cast<std::size_t>(grid.thresholdCount) *
           static_cast<std::size_t>(grid.highestLeastPoints - grid.lowestLeastPoints + 1);
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
    left->column()->addWidget(makeTrialsCard(left));
    left->column()->addWidget(makeSearchCard(left));
    auto* card = new Card(tr("Values"), left);
    values_ = new QStackedWidget(card);
    card->body()->addWidget(values_);
    left->column()->addWidget(card);
    left->column()->addStretch();
    return left;
}

QWidget* TuningDialog::makeTrialsCard(QWidget* parent) {
    auto* trials = new Card(tr("Trials"), parent);
    auto* folder = new QPushButton(tr("Choose a folder of trials…"), trials);
    folder->setObjectName(QStringLiteral("tuning.folder"));
    folder->setAutoDefault(false);
    folder->setToolTip(tr("Maps NAME.pcd with known FOD in NAME.json, as fodscope-cli simulate writes them"));
    trialsText_ = makeText(tr("Maps of this space whose FOD is known. Every setting is tried on all of them."),
                           TextRole::Muted, trials);
    trialsText_->setObjectName(QStringLiteral("tuning.trials"));
    trials->body()->addWidget(folder);
    trials->body()->addWidget(trialsText_);
    connect(folder, &QPushButton::clicked, this, [this] {
        const QString chosen = files_.chooseFolder(this, tr("Folder of trials"), folder_);
        if (!chosen.isEmpty()) chooseFolder(chosen);
    });
    return trials;
}

QWidget* TuningDialog::makeSearchCard(QWidget* parent) {
    auto* search = new Card(tr("Search"), parent);
    options_ = new TuningOptions(files_, search);
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
    for (QWidget* widget :
         {static_cast<QWidget*>(options_), static_cast<QWidget*>(search_), static_cast<QWidget*>(cancel_),
          static_cast<QWidget*>(progress_), static_cast<QWidget*>(stage_)})
        search->body()->addWidget(widget);
    connect(search_, &QPushButton::clicked, this, &TuningDialog::search);
    connect(cancel_, &QPushButton::clicked, this, [this] { controller_.tasks().cancel(); });
    connect(options_, &TuningOptions::changed, this, &TuningDialog::refresh);
    return search;
}

QWidget* TuningDialog::makeRight() {
    auto* right = new QWidget(this);
    setSurface(right, SurfaceRole::Surface1);
    auto* column = new QVBoxLayout(right);
    column->setContentsMargins(metrics::kPanelMargin_px, metrics::kPanelMargin_px, metrics::kPanelMargin_px,
                               metrics::kPanelMargin_px);
    pages_ = new QStackedWidget(right);
    costPage_ = new CostPage(pages_);
    photoPage_ = new PhotoPage(pages_);
    for (TuningPage* page : {static_cast<TuningPage*>(costPage_), static_cast<TuningPage*>(photoPage_)}) {
        pages_->addWidget(page);
        values_->addWidget(page->values());
        connect(page, &TuningPage::chosenChanged, this, &TuningDialog::refresh);
    }
    column->addWidget(pages_, 1);
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
    best_->setToolTip(tr("Chooses the best values again (Home in the picture)"));
    use_ = button(tr("Use these"), "tuning.use");
    setButtonRole(use_, ButtonRole::Primary);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(best_, &QPushButton::clicked, this, [this] { page().chooseBest(); });
    connect(use_, &QPushButton::clicked, this, &TuningDialog::use);
    return bottom;
}

void TuningDialog::takeInspection() {
    if (!controller_.isOpen()) hide();
    const auto& reference = controller_.state().reference;
    options_->offerMetrics(reference && reference->hasCovariance(), controller_.state().parameters.candidates.metric);
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
    markProblem(trialsText_, isProblem);
    if (const QDir beside(QDir(folder).filePath(QStringLiteral("worlds"))); beside.exists())
        options_->chooseWorlds(beside.path());
    refresh();
}

bool TuningDialog::isForPhotos() const {
    return options_->objective() == TuningOptions::Objective::Photos;
}

TuningPage& TuningDialog::page() const {
    if (isForPhotos()) return *photoPage_;
    return *costPage_;
}

QString TuningDialog::searchObstacle() const {
    if (!controller_.state().reference) return tr("load a reference first, in step 1");
    if (folder_.isEmpty()) return tr("choose a folder of trials first");
    if (trials_ == 0) return tr("the folder holds no trial with FOD");
    if (searching_) return tr("a search is under way");
    return options_->obstacle();
}

QString TuningDialog::whatASearchDoes() const {
    if (isForPhotos())
        return tr("Plans for and photographs every trial at %1 settings; can take minutes")
            .arg(count(settingCount(usualPhotoGrid(searchedMethod()))));
    return tr("Tries %1 settings on every trial").arg(count(settingCount({})));
}

QString TuningDialog::useObstacle() const {
    const std::optional<CandidateSettings> chosen = page().chosen();
    if (!chosen) return tr("search first");
    if (controller_.candidatesAreFrozen()) return tr("the visits have begun, so candidates keep their ids");
    if (*chosen == controller_.state().parameters.candidates) return tr("these values are in effect");
    return {};
}

void TuningDialog::refresh() {
    pages_->setCurrentWidget(&page());
    values_->setCurrentWidget(page().values());
    const QString obstacle = searchObstacle();
    search_->setEnabled(obstacle.isEmpty());
    search_->setToolTip(obstacle.isEmpty() ? whatASearchDoes() : tr("Cannot search: %1").arg(obstacle));
    search_->setVisible(!searching_);
    cancel_->setVisible(searching_);
    progress_->setVisible(searching_);
    const QString hindrance = useObstacle();
    use_->setEnabled(hindrance.isEmpty());
    use_->setToolTip(hindrance.isEmpty() ? tr("The chosen values become those of the inspection; can be undone")
                                         : tr("Not now: %1").arg(hindrance));
    best_->setEnabled(page().canChooseBest());
    page().markInEffect(controller_.state().parameters.candidates);
}

CandidateSettings TuningDialog::searchedMethod() const {
    CandidateSettings method = controller_.state().parameters.candidates;
    method.metric = options_->metric();
    return method;
}

TuningDialog::Measured TuningDialog::measuredNow() const {
    const Parameters& now = controller_.state().parameters;
    return {folder_, options_->worlds(), controller_.state().reference, now,
            now.candidates.metric == Metric::ChiSquare || searchedMethod().metric == Metric::ChiSquare};
}

bool TuningDialog::isMeasured(const Measured& measured) const {
    const Measured now = measuredNow();
    Parameters sameCandidates = measured.parameters;
    sameCandidates.candidates = now.parameters.candidates;
    return measured.folder == now.folder && measured.reference == now.reference &&
           sameFor(ParameterUse::Detection, sameCandidates, now.parameters) &&
           (measured.hasChiSquare || !now.hasChiSquare);
}

void TuningDialog::search() {
    searching_ = true;
    stage_->clear();
    refresh();
    if (isForPhotos())
        searchForPhotos();
    else
        searchForCost();
}

void TuningDialog::searchForCost() {
    TuningRequest request;
    request.folder = folder_.toStdString();
    request.reference = controller_.state().reference;
    request.parameters = controller_.state().parameters;
    const CandidateSettings method = searchedMethod();
    request.search.metric = method.metric;
    request.search.linkage = method.linkage;
    request.search.centroid = method.centroid;
    request.search.lambda_m = options_->lambda_m().value_or(kUnassociatedWeight_m);
    if (costPage_->outcome() && isMeasured(costMeasured_)) request.measured = costPage_->outcome()->measured;
    controller_.tasks().run(taskName(), [this, request, now = measuredNow()](Progress& progress) -> TaskRunner::Adopt {
        const auto outcome = std::make_shared<const TuningOutcome>(runTuning(request, progress));
        return [this, now, outcome] {
            costMeasured_ = now;
            endTask({}, false);
            showOutcome(*outcome);
        };
    });
}

void TuningDialog::searchForPhotos() {
    PhotoTuningRequest request;
    request.folder = folder_.toStdString();
    request.worlds = options_->worlds().toStdString();
    request.reference = controller_.state().reference;
    request.parameters = controller_.state().parameters;
    request.search.recall = options_->recall().value_or(PhotoSearchSettings().recall);
    request.search.grid = usualPhotoGrid(searchedMethod());
    if (photoPage_->outcome() && isMeasured(photosMeasured_) && photosMeasured_.worlds == options_->worlds() &&
        sameFor(ParameterUse::Plan, photosMeasured_.parameters, request.parameters))
        request.measured = photoPage_->outcome()->measured;
    controller_.tasks().run(taskName(), [this, request, now = measuredNow()](Progress& progress) -> TaskRunner::Adopt {
        const auto outcome = std::make_shared<const PhotoTuningOutcome>(runPhotoTuning(request, progress));
        return [this, now, outcome] {
            photosMeasured_ = now;
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
    markProblem(stage_, isProblem);
    refresh();
}

void TuningDialog::tell(const QString& searched, const std::map<std::string, std::string>& failures,
                        const QString& counts) {
    QString told = searched;
    for (const auto& [name, reason] : failures)
        told += tr(". %1 %2: %3").arg(QString::fromStdString(name), counts, QString::fromStdString(reason));
    stage_->setText(told);
}

void TuningDialog::showOutcome(const TuningOutcome& outcome) {
    options_->chooseObjective(TuningOptions::Objective::Cost);
    const ParameterSearchResult& result = outcome.result;
    tell(tr("%1 settings in %2").arg(count(result.costs.size()), counted(result.trialCount, tr("trial"), tr("trials"))),
         outcome.measured->failures, tr("counts as without candidates"));
    costPage_->showOutcome(outcome);
}

void TuningDialog::showOutcome(const PhotoTuningOutcome& outcome) {
    options_->chooseObjective(TuningOptions::Objective::Photos);
    const PhotoSearchResult& result = outcome.result;
    QString searched = tr("%1 settings in %2")
                           .arg(count(result.outcomes.size()), counted(result.trialCount, tr("trial"), tr("trials")));
    if (!result.best) searched += tr(". No setting shows %1 of the FOD").arg(percent(result.settings.recall));
    tell(searched, outcome.measured ? outcome.measured->failures() : std::map<std::string, std::string>(),
         tr("shows no FOD"));
    photoPage_->showOutcome(outcome);
    refresh();
}

void TuningDialog::use() {
    if (const std::optional<CandidateSettings> chosen = page().chosen()) controller_.commitCandidates(*chosen);
}

}  // namespace fodscope
