// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>

#include "core/inspection/Inspection.h"
#include "core/inspection/ReportModel.h"
#include "core/registration/RegionResiduals.h"
#include "ui/session/CandidatePreview.h"
#include "ui/session/MapLoading.h"
#include "ui/session/ReferenceSources.h"
#include "ui/session/Steps.h"
#include "ui/session/TaskRunner.h"
#include "ui/session/UndoHistory.h"
#include "ui/session/VisitDriver.h"

namespace fodscope {

class SessionFile;
struct BuiltinInspection;
struct World;

/// The one wrapper of an inspection for Qt: panels read its state, send it commands and learn of changes by signals.
/// Long work runs off the GUI thread and its results are taken over on it. No function throws: what goes wrong becomes
/// errorRaised() with one sentence.
class InspectionController : public QObject {
    Q_OBJECT

  public:
    explicit InspectionController(QObject* parent = nullptr);
    ~InspectionController() override;

    // --- the session -------------------------------------------------------------------------------------------------
    bool isOpen() const { return inspection_ != nullptr; }
    /// Of the open inspection; an empty one when none is open.
    const InspectionState& state() const;
    QString sessionPath() const;
    /// Head of the session's chain of acts.
    QString headHash() const;
    /// @return whether it was made; it is then the open one
    bool createSession(const QString& file, const InspectionHeader& header);
    void openSession(const QString& file);
    void closeSession();
    void setHeader(const InspectionHeader& header);
    /// A new session on the built-in tank: reference from simulated nominal maps, map, detection, plan and robot.
    void createBuiltinTank(const QString& file);

    // --- reference and map -------------------------------------------------------------------------------------------
    /// The inspection's parameters say how it is made.
    void loadReference(const ReferenceRequest& request);
    /// Makes the last reference again from the same files, with the parameters as they are now.
    void remakeReference();
    bool canRemakeReference() const { return lastReference_.has_value(); }
    /// Metres in one unit of the meshes that are loaded next.
    double meshScale() const { return meshScale_; }
    void setMeshScale(double scale) { meshScale_ = scale; }
    void loadMap(const QString& file);
    const std::optional<LoadedMap>& loadedMap() const { return map_; }
    /// A 4×4 transform, reference from map, from a CSV file replaces the registration.
    void loadGivenTransform(const QString& csvFile);
    bool hasGivenTransform() const { return givenTransform_.has_value(); }
    /// Aligns from a known start pose instead of searching all poses; also chooses one of several that fit.
    void setStartPose(const Transform& T_reference_from_map);
    /// Where the map's origin lies in the reference; the floors are laid on each other.
    void setStartPose(const Pose2& mapOrigin_reference);
    /// The start pose from a 4×4 CSV file.
    void loadStartPose(const QString& csvFile);
    bool hasStartPose() const { return start_.has_value(); }
    /// Forgets a given transform and a start pose, and searches all poses.
    void alignBySearch();
    /// Shows the map at a pose without keeping it; empty: where it is.
    void previewPose(const std::optional<Transform>& T_reference_from_map);
    const std::optional<Transform>& previewedPose() const { return previewedPose_; }
    /// What is left between map and reference, region by region; null until it was measured.
    std::shared_ptr<const RegionResiduals> residuals() const { return residuals_; }
    /// Aligns the map, measures the discrepancy and finds candidates.
    void detect();
    void setParameters(const Parameters& parameters);
    /// Keeps parameters and makes what rests on them anew: the detection where they are about it. They are kept once
    /// that succeeded, so a cancelled or failed detection leaves everything as it was. Can be undone.
    void applyParameters(const Parameters& parameters);

    // --- candidates --------------------------------------------------------------------------------------------------
    /// Shows candidates for other settings without keeping them; the last call wins.
    void previewCandidates(const CandidateSettings& settings);
    /// Keeps them.
    void commitCandidates(const CandidateSettings& settings);
    bool candidatesAreFrozen() const;
    /// The candidates on the screen: those of the preview while one is shown, else the committed ones; may be null.
    std::shared_ptr<const CandidateSet> shownCandidates() const;
    CandidateSettings shownCandidateSettings() const;
    bool isPreviewing() const { return preview_ != nullptr; }
    const Candidate* findShownCandidate(const QString& id) const;
    /// One verdict for each committed candidate, in their order.
    const std::vector<CandidateVerdict>& verdicts() const { return verdicts_; }

    /// The candidate selected everywhere; empty: none.
    QString selectedCandidate() const { return selected_; }
    void selectCandidate(const QString& id);
    /// @param step +1 next, −1 previous, wrapping round
    void selectNeighbour(int step);
    /// Selects it and asks the views to fly there.
    void flyToCandidate(const QString& id);
    void flyToPlace(const Eigen::Vector3d& centre_reference, double radius_m);

    /// What the operator pointed at in a view: names and values, ready to be read; empty: nothing.
    const std::vector<ReportField>& probe() const { return probe_; }
    void setProbe(std::vector<ReportField> fields);

    // --- plan and visits ---------------------------------------------------------------------------------------------
    /// Where the route starts: the robot's pose when it is known, else what was set.
    std::optional<Pose2> robotStart() const;
    void setRobotStart(const Pose2& pose_map);
    /// A map_server grid for the plan instead of one made from the map.
    void loadGrid(const QString& yamlFile);
    void planVisits();
    /// The stops of the plan as the operator may change them; none without a plan.
    std::vector<PlannedStop> stops() const;
    /// Makes the plan one over the operator's own stops. Can be undone until the visits begin.
    /// @param what in words, after "undo ": "move of W-02"
    void changeStops(const std::vector<PlannedStop>& stops, const QString& what);
    /// The waypoint that changes of the plan are about; empty: none.
    QString selectedWaypoint() const { return selectedWaypoint_; }
    /// Selects its first candidate too, unless one of its candidates is selected.
    void selectWaypoint(const QString& id);
    void connectRobot(std::unique_ptr<RobotLink> robot);
    /// A simulated robot in a world file, or in the built-in tank.
    void connectWorldRobot(const QString& worldFile);
    void connectBuiltinRobot();
    /// Whether the open inspection is one of the built-in tank.
    bool isOnBuiltinTank() const;
    /// What the simulated robot drives in, for a labeller that knows the truth; null without one.
    std::shared_ptr<const World> simulatedWorld() const { return world_; }
    VisitDriver& visits() { return visits_; }
    const VisitDriver& visits() const { return visits_; }
    /// Cancels every goal of the robot at once.
    void stopRobot();

    // --- the inspection route ----------------------------------------------------------------------------------------
    /// What the route is drawn on; null until a robot, a file or a plan brought a grid.
    const OccupancyGrid* routeGrid() const;
    /// Whether there is a route, or a robot that could drive one while there is no map.
    bool isRouteWanted() const;
    /// Keeps an edited route. Can be undone.
    /// @param act in words, after "undo "
    void setRoute(const InspectionRoute& route, const QString& act);
    void removeRoutePose(const QString& poseId);
    void loadRoute(const QString& yamlFile);
    void saveRoute(const QString& yamlFile);
    /// A simulated robot in a world file, which maps while it drives.
    void connectMappingRobot(const QString& worldFile);
    /// Goes on at the first pose not done; when all are, the map is fetched.
    void driveRoute();
    /// Every pose is to be driven once more.
    void driveRouteAgain();
    bool isDrivingRoute() const { return isOnRoute_ && visits_.runnerState() == RunnerState::Running; }
    /// Asks the robot for its map, keeps it in a file beside the session and loads it.
    void fetchMap();
    QString selectedRoutePose() const { return selectedRoutePose_; }
    void selectRoutePose(const QString& poseId);

    // --- photos and decisions ----------------------------------------------------------------------------------------
    const Photo* findPhoto(const QString& photoId) const;
    QString labeller() const { return labeller_; }
    void setLabeller(const QString& name);
    void loadLabelSet(const QString& yamlFile);
    /// @return whether the decision is safe in the session file
    bool decide(const QString& photoId, const std::vector<PhotoLabel>& labels, const QString& comment);
    /// The photo to be labelled, one everywhere.
    QString selectedPhoto() const { return selectedPhoto_; }
    void selectPhoto(const QString& photoId);

    // --- undo, report, tasks -----------------------------------------------------------------------------------------
    const UndoHistory& history() const { return history_; }
    /// Also after reopening, when the history is empty: the labeller's decisions can still be taken back.
    bool canUndo() const;
    void undo();
    void redo();
    ReportModel reportModel() const;
    /// Writes report.pdf, report.html, report.csv and report.json into a folder and records that.
    void issueReport(const QString& folder);
    TaskRunner& tasks() { return tasks_; }
    const TaskRunner& tasks() const { return tasks_; }
    /// The states of the steps with the running task laid over them.
    std::array<StepState, kStepCount> steps() const;
    /// Shows a sentence as an error; for windows whose own work failed.
    void raiseError(const QString& sentence);

  signals:
    /// The built-in tank that was asked for is detected and can be worked on.
    void builtinTankReady();
    /// Another inspection is open, or none: everything shown must be made anew.
    void sessionChanged();
    void headerChanged();
    void referenceChanged();
    void mapChanged();
    void parametersChanged();
    /// A detection was adopted (or is gone).
    void detectionChanged();
    /// The candidates on the screen changed: by a preview, a commit or a detection.
    void candidatesChanged();
    void selectionChanged(const QString& candidateId);
    void probeChanged();
    void flyToRequested(const QString& candidateId);
    void flyToPlaceRequested(const Eigen::Vector3d& centre_reference, double radius_m);
    void posePreviewChanged();
    void residualsChanged();
    void planChanged();
    void routeChanged();
    void routePoseSelected(const QString& poseId);
    void waypointSelectionChanged(const QString& waypointId);
    void visitsChanged();
    void robotChanged();
    void photosChanged();
    void photoArrived(const QString& photoId);
    void photoSelectionChanged(const QString& photoId);
    void decisionsChanged();
    void labelSetChanged();
    void labellerChanged();
    void reportIssued(const QString& folder);
    void historyChanged();
    /// The state of a step changed.
    void stepsChanged();
    void errorRaised(const QString& sentence);
    void noticeRaised(const QString& sentence);

  private:
    void connectParts();
    /// Runs an act that may fail and turns what it throws into errorRaised().
    bool attempt(const std::function<void()>& act);
    void runFor(Step step, const QString& task, TaskRunner::Work work);

    void adoptSession(std::shared_ptr<SessionFile> file, InspectionState state);
    void adoptReference(const LoadedReference& loaded);
    void chooseMetricFor(const ReferenceMap& reference);
    void adoptBuiltinRobot(const BuiltinInspection& builtin);
    void adoptMap(const SourceFile& source, const LoadedMap& map);
    void afterInputChanged();
    void refreshResiduals();
    void adoptCandidates(const Parameters& parameters, const DetectionResult& result);
    /// Detects with parameters that become those of the inspection when it succeeds.
    void detectWith(const Parameters& parameters, const std::function<void()>& afterwards);
    void keepParameters(const Parameters& parameters, const std::function<void()>& afterwards);
    void keepCandidateSettings(const CandidateSettings& settings, const std::function<void()>& afterwards);
    void dropPreview();
    void refreshVerdicts();
    GridSources gridSources() const;
    bool keepRoute(const InspectionRoute& route);
    void followRoute();
    void leaveRoute();
    void keepMap(const std::shared_ptr<const PointCloud>& map);
    void keepVisit(const Visit& visit);
    void keepPlan(const OccupancyGrid& grid, const VisitPlan& plan);
    void keepPhoto(const Photo& photo);
    void recordDecision(const std::string& photoId, const std::string& labeller, const std::vector<PhotoLabel>& labels,
                        const std::string& comment);
    void takeBackDecision(const std::string& labeller);
    bool hasDecisionOf(const std::string& labeller) const;

    InspectionState nothing_;
    UndoHistory history_;
    /// Before the inspection, which writes into it to its end.
    std::shared_ptr<SessionFile> session_;
    std::unique_ptr<Inspection> inspection_;
    std::shared_ptr<DetectionPipeline> pipeline_;
    double meshScale_ = 1.0;
    /// What the reference was made from in this run of the program, where covariances were fitted.
    std::optional<ReferenceRequest> lastReference_;
    std::optional<LoadedMap> map_;
    std::optional<Transform> givenTransform_;
    std::optional<Transform> start_;
    std::optional<Transform> previewedPose_;
    std::shared_ptr<const RegionResiduals> residuals_;
    /// The discrepancy that they belong to.
    std::shared_ptr<const DiscrepancyField> residualsOf_;
    /// What was chosen before a reference without covariances took Mahalanobis away.
    std::optional<CandidateSettings> settingsWithCovariances_;
    std::shared_ptr<CandidateFinder> finder_;
    std::shared_ptr<const CandidateSet> preview_;
    CandidateSettings previewSettings_;
    std::vector<CandidateVerdict> verdicts_;
    std::vector<ReportField> probe_;
    QString selected_;
    QString selectedPhoto_;
    QString selectedWaypoint_;
    QString labeller_;
    std::optional<Pose2> robotStart_;
    std::optional<OccupancyGrid> givenGrid_;
    std::optional<OccupancyGrid> robotGrid_;
    std::shared_ptr<const World> world_;
    bool isBuiltinPending_ = false;
    /// The runner drives the route, not the plan.
    bool isOnRoute_ = false;
    bool isMapAwaited_ = false;
    QString selectedRoutePose_;
    std::optional<Step> taskStep_;
    /// Last, so that their threads end before what they work on goes.
    VisitDriver visits_;
    CandidatePreview previewer_;
    TaskRunner tasks_;
};

}  // namespace fodscope
