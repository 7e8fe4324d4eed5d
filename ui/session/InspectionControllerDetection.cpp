// SPDX-License-Identifier: MIT
// Reference, map and candidates of the inspection controller.
#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "core/common/Error.h"
#include "ui/session/BuiltinInspection.h"
#include "ui/session/InspectionController.h"

namespace fodscope {
namespace {

QString fileNames(const ReferenceRequest& request) {
    if (request.files.size() == 1) return QString::fromStdString(request.files.front().filename().string());
    return QObject::tr("%n nominal maps", nullptr, static_cast<int>(request.files.size()));
}

/// As the pipeline makes it: with the local statistical test if and only if the metric needs it.
std::shared_ptr<const DiscrepancyField> fieldFor(const DetectionRecord& record, const Parameters& parameters,
                                                 Progress& progress) {
    const bool wanted = parameters.candidates.metric == Metric::ChiSquare;
    const bool isThere = record.field->has(Metric::ChiSquare);
    if (wanted == isThere && (!wanted || record.parameters.chiSquare == parameters.chiSquare)) return record.field;
    if (wanted) return std::make_shared<DiscrepancyField>(withChiSquare(*record.field, parameters.chiSquare, progress));
    auto field = std::make_shared<DiscrepancyField>(*record.field);
    field->chiSquare.clear();
    return field;
}

DetectionResult resultOf(const DetectionRecord& record, std::shared_ptr<const DiscrepancyField> field,
                         std::shared_ptr<const CandidateSet> candidates) {
    DetectionResult result;
    result.registration = record.registration;
    result.field = std::move(field);
    result.candidates = std::move(candidates);
    result.coverage = record.coverage;
    result.floorHeight_m = record.floorHeight_m;
    return result;
}

}  // namespace

void InspectionController::remakeReference() {
    if (lastReference_) loadReference(*lastReference_);
}

void InspectionController::loadReference(const ReferenceRequest& wanted) {
    if (!inspection_) return;
    ReferenceRequest request = wanted;
    request.parameters = state().parameters;
    runFor(Step::Reference, tr("loading the reference: %1").arg(fileNames(request)),
           [this, request](Progress& progress) -> TaskRunner::Adopt {
               const LoadedReference loaded = makeReference(request, progress);
               return [this, request, loaded] {
                   lastReference_.reset();
                   if (request.kind == ReferenceKind::NominalMaps || request.kind == ReferenceKind::CadAndMaps)
                       lastReference_ = request;
                   adoptReference(loaded);
               };
           });
}

void InspectionController::adoptReference(const LoadedReference& loaded) {
    inspection_->setReference(loaded.source, loaded.reference);
    start_.reset();
    chooseMetricFor(*loaded.reference);
    afterInputChanged();
    emit referenceChanged();
    if (map_) detect();
}

void InspectionController::chooseMetricFor(const ReferenceMap& reference) {
    const CandidateSettings euclidean = paperPhysicalCandidateSettings(Metric::Euclidean);
    Parameters parameters = state().parameters;
    if (!reference.hasCovariance() && parameters.candidates.metric == Metric::Mahalanobis) {
        settingsWithCovariances_ = std::exchange(parameters.candidates, euclidean);
        inspection_->setParameters(parameters);
        emit parametersChanged();
        emit noticeRaised(tr("This reference has no covariances, so the Euclidean discrepancy is used."));
    } else if (reference.hasCovariance() && settingsWithCovariances_) {
        // What was given up only for want of covariances comes back with them, unless the operator chose since.
        const bool wasChosenSince = parameters.candidates != euclidean;
        const CandidateSettings before = *std::exchange(settingsWithCovariances_, std::nullopt);
        if (wasChosenSince) return;
        parameters.candidates = before;
        inspection_->setParameters(parameters);
        emit parametersChanged();
        emit noticeRaised(tr("This reference has covariances, so the Mahalanobis discrepancy is used again."));
    }
}

void InspectionController::afterInputChanged() {
    dropPreview();
    history_.clear();
    if (!state().plan) visits_.clearPlan();
    refreshVerdicts();
    refreshResiduals();
    if (!selected_.isEmpty() && findShownCandidate(selected_) == nullptr) selectCandidate(QString());
    emit historyChanged();
    emit detectionChanged();
    emit candidatesChanged();
    emit planChanged();
    emit visitsChanged();
    emit stepsChanged();
}

void InspectionController::loadMap(const QString& file) {
    if (!inspection_) return;
    runFor(Step::Map, tr("loading the map: %1").arg(QFileInfo(file).fileName()),
           [this, file](Progress& progress) -> TaskRunner::Adopt {
               const MapFile loaded = readMapFile(file.toStdString(), progress);
               return [this, loaded] { adoptMap(loaded.source, loaded.map); };
           });
}

void InspectionController::adoptMap(const SourceFile& source, const LoadedMap& map) {
    inspection_->setMap(source);
    map_ = map;
    start_.reset();
    robotGrid_.reset();
    afterInputChanged();
    emit mapChanged();
    if (state().reference) detect();
}

void InspectionController::loadGivenTransform(const QString& csvFile) {
    const bool read = attempt([&] { givenTransform_ = readTransformCsv(csvFile.toStdString()); });
    if (!read) return;
    emit mapChanged();
    if (state().reference && state().mapSource) detect();
}

void InspectionController::detect() {
    detectWith(state().parameters, {});
}

void InspectionController::detectWith(const Parameters& parameters, const std::function<void()>& afterwards) {
    const bool ready = attempt([this] {
        if (!state().reference) throw Error("reference", "there is none yet", "load a reference map in step 1");
        if (!state().mapSource) throw Error("map", "there is none yet", "load the map under inspection in step 2");
        if (candidatesAreFrozen())
            throw Error("candidates", "they are frozen because the visits have begun",
                        "start a new inspection to detect again");
    });
    if (!ready) return;
    auto reread = std::make_shared<std::optional<LoadedMap>>(map_);
    runFor(Step::Map, tr("detecting"),
           [this, reread, parameters, afterwards, pipeline = pipeline_, reference = state().reference,
            source = *state().mapSource, given = givenTransform_,
            start = start_](Progress& progress) -> TaskRunner::Adopt {
               if (!*reread) *reread = rereadMap(source, progress);
               pipeline->setReference(reference);
               pipeline->setMap((*reread)->cloud);
               pipeline->setGivenTransform(given);
               pipeline->setStart(start);
               const DetectionResult result = pipeline->run(parameters, progress);
               return [this, reread, parameters, afterwards, result] {
                   const bool isNew = !map_;
                   map_ = *reread;
                   adoptCandidates(parameters, result);
                   if (isNew) emit mapChanged();
                   if (afterwards) afterwards();
                   if (std::exchange(isBuiltinPending_, false)) emit builtinTankReady();
               };
           });
}

void InspectionController::adoptCandidates(const Parameters& parameters, const DetectionResult& result) {
    inspection_->adoptDetection(parameters, result);
    preview_.reset();
    previewer_.drop();
    previewPose(std::nullopt);
    visits_.clearPlan();
    refreshVerdicts();
    if (!selected_.isEmpty() && findShownCandidate(selected_) == nullptr) selectCandidate(QString());
    emit parametersChanged();
    emit detectionChanged();
    emit candidatesChanged();
    emit planChanged();
    emit visitsChanged();
    emit stepsChanged();
    refreshResiduals();
}

bool InspectionController::candidatesAreFrozen() const {
    return inspection_ && inspection_->candidatesAreFrozen();
}

void InspectionController::previewCandidates(const CandidateSettings& settings) {
    if (!state().detection || !state().detection->field || candidatesAreFrozen()) return;
    previewSettings_ = settings;
    previewer_.request({*state().detection, settings, state().highestCandidateNumber});
}

void InspectionController::commitCandidates(const CandidateSettings& settings) {
    if (!inspection_) return;
    const CandidateSettings before = state().parameters.candidates;
    if (settings == before) {
        dropPreview();
        return;
    }
    if (candidatesAreFrozen()) {
        dropPreview();
        emit errorRaised(
            tr("Candidates: they are frozen because the visits have begun; start a new inspection to "
               "detect again"));
        return;
    }
    keepCandidateSettings(settings, [this, before, settings] {
        history_.add({tr("candidate settings"), [this, before] { keepCandidateSettings(before, {}); },
                      [this, settings] { keepCandidateSettings(settings, {}); }});
        emit historyChanged();
    });
}

void InspectionController::keepCandidateSettings(const CandidateSettings& settings,
                                                 const std::function<void()>& afterwards) {
    Parameters parameters = state().parameters;
    parameters.candidates = settings;
    if (!state().detection || !state().detection->field) {
        // Nothing to cluster yet: the settings wait for the next detection.
        setParameters(parameters);
        if (afterwards) afterwards();
        return;
    }
    runFor(Step::Candidates, tr("finding candidates"),
           [this, parameters, afterwards, finder = finder_,
            record = *state().detection](Progress& progress) -> TaskRunner::Adopt {
               const auto field = fieldFor(record, parameters, progress);
               const auto candidates = finder->find(record, field, parameters.candidates, progress);
               return [this, parameters, afterwards, result = resultOf(record, field, candidates)] {
                   adoptCandidates(parameters, result);
                   if (afterwards) afterwards();
               };
           });
}

void InspectionController::dropPreview() {
    previewer_.drop();
    if (!preview_) return;
    preview_.reset();
    emit candidatesChanged();
}

std::shared_ptr<const CandidateSet> InspectionController::shownCandidates() const {
    if (preview_) return preview_;
    return state().detection ? state().detection->candidates : nullptr;
}

CandidateSettings InspectionController::shownCandidateSettings() const {
    return preview_ ? previewSettings_ : state().parameters.candidates;
}

const Candidate* InspectionController::findShownCandidate(const QString& id) const {
    const auto shown = shownCandidates();
    if (!shown) return nullptr;
    const auto found = std::ranges::find(shown->candidates, id.toStdString(), &Candidate::id);
    return found == shown->candidates.end() ? nullptr : &*found;
}

void InspectionController::selectCandidate(const QString& id) {
    if (id == selected_) return;
    selected_ = id;
    emit selectionChanged(id);
}

void InspectionController::selectNeighbour(int step) {
    const auto shown = shownCandidates();
    if (!shown || shown->candidates.empty()) return;
    const int count = static_cast<int>(shown->candidates.size());
    const auto found = std::ranges::find(shown->candidates, selected_.toStdString(), &Candidate::id);
    const int current =
        found == shown->candidates.end() ? (step > 0 ? -1 : 0) : static_cast<int>(found - shown->candidates.begin());
    const int next = ((current + step) % count + count) % count;
    selectCandidate(QString::fromStdString(shown->candidates[static_cast<std::size_t>(next)].id));
}

void InspectionController::flyToCandidate(const QString& id) {
    selectCandidate(id);
    emit flyToRequested(id);
}

void InspectionController::setProbe(std::vector<ReportField> fields) {
    probe_ = std::move(fields);
    emit probeChanged();
}

void InspectionController::refreshVerdicts() {
    verdicts_ = verdictsOf(state());
}

}  // namespace fodscope
