// SPDX-License-Identifier: MIT
#include "ui/session/InspectionController.h"

#include <QFileInfo>
#include <QSettings>

#include "core/common/Error.h"
#include "storage/SessionFile.h"
#include "ui/session/ParameterUse.h"
#include "ui/session/RecentSessions.h"
#include "ui/session/Resources.h"

namespace fodscope {
namespace {

constexpr const char* kLabeller = "labelling/labeller";

}  // namespace

InspectionController::InspectionController(QObject* parent)
    : QObject(parent),
      pipeline_(std::make_shared<DetectionPipeline>()),
      finder_(std::make_shared<CandidateFinder>()),
      labeller_(QSettings().value(kLabeller).toString()),
      previewer_(finder_) {
    connectParts();
}

InspectionController::~InspectionController() = default;

void InspectionController::connectParts() {
    connect(&tasks_, &TaskRunner::failed, this, [this](const QString&, const QString& sentence) {
        dropPreview();
        emit errorRaised(sentence);
        emit stepsChanged();
    });
    connect(&tasks_, &TaskRunner::cancelled, this, [this](const QString& task) {
        dropPreview();
        emit noticeRaised(tr("Cancelled: %1. What was there before is kept.").arg(task));
    });
    connect(&tasks_, &TaskRunner::started, this, &InspectionController::stepsChanged);
    connect(&tasks_, &TaskRunner::idle, this, &InspectionController::stepsChanged);
    connect(&previewer_, &CandidatePreview::ready, this,
            [this](const std::shared_ptr<const CandidateSet>& candidates, const CandidateSettings& settings) {
                if (!state().detection || !state().detection->candidates) return;
                preview_ = candidates;
                previewSettings_ = settings;
                emit candidatesChanged();
            });
    connect(&previewer_, &CandidatePreview::failed, this, &InspectionController::errorRaised);
    connect(&visits_, &VisitDriver::robotChanged, this, &InspectionController::robotChanged);
    connect(&visits_, &VisitDriver::runnerStateChanged, this, &InspectionController::visitsChanged);
    connect(&visits_, &VisitDriver::runnerStateChanged, this, &InspectionController::followRoute);
    connect(&visits_, &VisitDriver::mapReceived, this, &InspectionController::keepMap);
    connect(&visits_, &VisitDriver::message, this, &InspectionController::noticeRaised);
    connect(&visits_, &VisitDriver::gridReceived, this, [this](const OccupancyGrid& grid) {
        robotGrid_ = grid;
        emit routeChanged();
    });
    connect(&visits_, &VisitDriver::visitChanged, this, &InspectionController::keepVisit);
    connect(&visits_, &VisitDriver::photoArrived, this, &InspectionController::keepPhoto);
}

const InspectionState& InspectionController::state() const {
    return inspection_ ? inspection_->state() : nothing_;
}

QString InspectionController::sessionPath() const {
    return session_ ? QString::fromStdString(session_->path().string()) : QString();
}

QString InspectionController::headHash() const {
    return session_ ? QString::fromStdString(session_->headHash()) : QString();
}

bool InspectionController::attempt(const std::function<void()>& act) {
    try {
        act();
        return true;
    } catch (const std::exception& error) {
        emit errorRaised(sentenceOf(error));
        return false;
    }
}

void InspectionController::raiseError(const QString& sentence) {
    emit errorRaised(sentence);
}

bool InspectionController::createSession(const QString& file, const InspectionHeader& header) {
    return attempt([&] {
        const LabelSet labels = readLabelSet(resourceFile("labels/default.yaml"));
        auto session = SessionFile::create(file.toStdString(), header);
        InspectionState state;
        state.header = header;
        adoptSession(std::move(session), std::move(state));
        inspection_->setLabelSet(labels);
        inspection_->setParameters(presetParameters("paper-physical"));
        emit labelSetChanged();
        emit parametersChanged();
    });
}

void InspectionController::openSession(const QString& file) {
    // SQLite hands a connection from thread to thread as long as one uses it at a time.
    tasks_.run(tr("opening %1").arg(QFileInfo(file).fileName()), [this, file](Progress& progress) -> TaskRunner::Adopt {
        progress.report(tr("reading the session").toStdString(), 0.0);
        std::shared_ptr<SessionFile> session = SessionFile::open(file.toStdString());
        auto state = std::make_shared<InspectionState>(session->load());
        // An altered session is shown all the same, so that people can see what is left of it, but never in silence.
        QString alteration;
        try {
            session->requireIntact();
        } catch (const Error& error) {
            alteration = sentenceOf(error);
        }
        return [this, session, state, alteration]() mutable {
            adoptSession(std::move(session), std::move(*state));
            if (!alteration.isEmpty()) emit errorRaised(alteration);
        };
    });
}

void InspectionController::adoptSession(std::shared_ptr<SessionFile> file, InspectionState state) {
    closeSession();
    session_ = std::move(file);
    inspection_ = std::make_unique<Inspection>(std::move(state), *session_);
    attempt([&] { inspection_->resumeVisits(); });
    refreshVerdicts();
    const InspectionState& opened = this->state();
    if (opened.plan) visits_.setPlan(*opened.plan, opened.visits, opened.parameters.visits, photoMarks(opened));
    RecentSessions().add(sessionPath());
    if (opened.detection) start_ = opened.detection->registration.start_T_reference_from_map;
    emit sessionChanged();
    emit stepsChanged();
    refreshResiduals();
}

void InspectionController::closeSession() {
    if (!inspection_) return;
    if (visits_.runnerState() == RunnerState::Running) visits_.stop();
    visits_.clearPlan();
    visits_.setRobot(nullptr);
    previewer_.drop();
    preview_.reset();
    history_.clear();
    isOnRoute_ = isMapAwaited_ = false;
    selectedRoutePose_.clear();
    inspection_.reset();
    session_.reset();
    pipeline_ = std::make_shared<DetectionPipeline>();
    map_.reset();
    givenTransform_.reset();
    start_.reset();
    lastReference_.reset();
    previewedPose_.reset();
    residuals_.reset();
    residualsOf_.reset();
    settingsWithCovariances_.reset();
    robotStart_.reset();
    givenGrid_.reset();
    robotGrid_.reset();
    world_.reset();
    isBuiltinPending_ = false;
    verdicts_.clear();
    selected_.clear();
    selectedPhoto_.clear();
    setProbe({});
    emit sessionChanged();
    emit historyChanged();
    emit stepsChanged();
}

void InspectionController::setHeader(const InspectionHeader& header) {
    if (!inspection_) return;
    if (attempt([&] { inspection_->setHeader(header); })) emit headerChanged();
}

void InspectionController::setParameters(const Parameters& parameters) {
    if (!inspection_ || parameters == state().parameters) return;
    if (attempt([&] { inspection_->setParameters(parameters); })) emit parametersChanged();
}

void InspectionController::applyParameters(const Parameters& parameters) {
    const Parameters before = state().parameters;
    if (!inspection_ || parameters == before) return;
    keepParameters(parameters, [this, before, parameters] {
        history_.add({tr("settings"), [this, before] { keepParameters(before, {}); },
                      [this, parameters] { keepParameters(parameters, {}); }});
        emit historyChanged();
    });
}

void InspectionController::keepParameters(const Parameters& parameters, const std::function<void()>& afterwards) {
    const Parameters before = state().parameters;
    const bool isAllowed = attempt([&] {
        if (candidatesAreFrozen() &&
            !(sameFor(ParameterUse::Detection, parameters, before) && sameFor(ParameterUse::Plan, parameters, before)))
            throw Error("settings", "candidates and plan are frozen because the visits have begun",
                        "start a new inspection for other ones");
        if (visits_.runnerState() == RunnerState::Running && !sameFor(ParameterUse::Visits, parameters, before))
            throw Error("settings", "the visits are under way", "pause them first, and apply again");
    });
    if (!isAllowed) return;
    if (!sameFor(ParameterUse::Detection, parameters, before) && state().reference && state().mapSource) {
        detectWith(parameters, afterwards);
        return;
    }
    setParameters(parameters);
    if (state().parameters != parameters) return;
    if (state().plan && !sameFor(ParameterUse::Visits, parameters, before))
        visits_.setPlan(*state().plan, state().visits, parameters.visits, photoMarks(state()));
    if (state().plan && !sameFor(ParameterUse::Plan, parameters, before))
        emit noticeRaised(tr("The plan was made with the settings before. Plan the visits again."));
    if (!sameFor(ParameterUse::Reference, parameters, before) && state().reference)
        emit noticeRaised(tr("These settings count for the next reference that is made."));
    if (afterwards) afterwards();
}

void InspectionController::undo() {
    if (history_.canUndo()) {
        attempt([this] { history_.undo(); });
    } else if (inspection_ && !labeller_.isEmpty()) {
        attempt([this] { takeBackDecision(labeller_.toStdString()); });
    }
    emit historyChanged();
}

void InspectionController::redo() {
    attempt([this] { history_.redo(); });
    emit historyChanged();
}

bool InspectionController::canUndo() const {
    return history_.canUndo() || (inspection_ && !labeller_.isEmpty() && hasDecisionOf(labeller_.toStdString()));
}

ReportModel InspectionController::reportModel() const {
    return makeReportModel(state());
}

std::array<StepState, kStepCount> InspectionController::steps() const {
    auto steps = stepStates(state());
    if (tasks_.isBusy() && taskStep_) steps[static_cast<std::size_t>(*taskStep_)] = StepState::Running;
    if (visits_.runnerState() == RunnerState::Running)
        steps[static_cast<std::size_t>(Step::Visit)] = StepState::Running;
    return steps;
}

void InspectionController::runFor(Step step, const QString& task, TaskRunner::Work work) {
    taskStep_ = step;
    tasks_.run(task, std::move(work));
}

}  // namespace fodscope
