// SPDX-License-Identifier: MIT
#include "core/evaluation/PhotoSearch.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/common/Error.h"
#include "core/evaluation/Numpy.h"
#include "core/evaluation/PhotoTrial.h"
#include "core/evaluation/SharedProgress.h"
#include "core/inspection/Inspection.h"
#include "core/planning/PhotoPlan.h"

namespace fodscope {
namespace {

/// A trial that is ready to be planned in.
struct Measured {
    std::string name;
    std::string failure;
    DetectionRecord detection;
    std::size_t fods = 0;
    std::unique_ptr<PhotoTrial> place;
    OccupancyGrid grid;
    CostMap collision;
};

/// What a trial's photos show at one grid point.
struct TrialOutcome {
    std::size_t photos = 0;
    std::size_t photosWithFod = 0;
    std::vector<std::uint8_t> fodShown;
    std::size_t candidates = 0;
    std::size_t candidatesWithoutPhoto = 0;
};

struct Task {
    std::size_t trial = 0;
    std::size_t threshold = 0;
    /// By cutoff, then least points; empty for too many candidates.
    std::vector<std::optional<TrialOutcome>> outcomes;
};

/// What the photo from a pose shows, computed once for each pose.
class Eyes {
  public:
    Eyes(const PhotoTrial& place, const CameraSettings& camera) : place_(place), camera_(camera) {}

    const std::vector<std::uint8_t>& fodSeenFrom(const Pose2& pose_map) {
        const auto key = std::tuple(pose_map.x_m, pose_map.y_m, pose_map.yaw_rad);
        const auto known = seen_.find(key);
        if (known != seen_.end()) return known->second;
        return seen_.emplace(key, place_.fodSeenFrom(cameraPose(pose_map, camera_))).first->second;
    }

  private:
    const PhotoTrial& place_;
    CameraSettings camera_;
    std::map<std::tuple<double, double, double>, std::vector<std::uint8_t>> seen_;
};

/// All cutoffs and least points of one trial at one threshold. Where they make the same candidates, they are planned
/// for once.
class TrialSearch {
  public:
    TrialSearch(const Measured& trial, const Parameters& parameters, int mostCandidates, Progress& progress)
        : trial_(trial),
          parameters_(parameters),
          mostCandidates_(static_cast<std::size_t>(mostCandidates)),
          progress_(progress),
          camera_(parameters.camera, parameters.waypoints),
          eyes_(*trial.place, parameters.camera),
          sight_(inflate(withoutCandidates(trial.grid, discrepantPoints_map(recordWith(parameters.candidates))),
                         parameters.costMap)) {}

    void addCutoff(double cutoff_m, std::span<const int> leastPoints,
                   std::vector<std::optional<TrialOutcome>>& outcomes) {
        Parameters parameters = parameters_;
        parameters.candidates.clusterCutoff_m = cutoff_m;
        parameters.candidates.minimumPoints = leastPoints.front();
        DetectionRecord record = recordWith(parameters.candidates);
        const CandidateSet all =
            findCandidates(*record.field, parameters.candidates, parameters.discrepancy.voxelSize_m,
                           record.floorHeight_m, record.registration.T_reference_from_map, progress_);
        for (const int least : leastPoints) {
            CandidateSet set;
            std::ranges::copy_if(all.candidates, std::back_inserter(set.candidates), [&](const Candidate& candidate) {
                return candidate.voxels.size() >= static_cast<std::size_t>(least);
            });
            if (set.candidates.size() > mostCandidates_) {
                outcomes.emplace_back();
                continue;
            }
            std::vector<std::vector<std::uint32_t>> key;
            for (const Candidate& candidate : set.candidates)
                key.push_back(candidate.voxels);
            auto known = known_.find(key);
            if (known == known_.end()) {
                record.candidates = std::make_shared<const CandidateSet>(std::move(set));
                known = known_.emplace(std::move(key), photographed(record)).first;
            }
            outcomes.emplace_back(known->second);
        }
    }

  private:
    DetectionRecord recordWith(const CandidateSettings& settings) const {
        DetectionRecord record = trial_.detection;
        record.parameters.candidates = settings;
        return record;
    }

    TrialOutcome photographed(const DetectionRecord& record) {
        TrialOutcome outcome;
        outcome.fodShown.assign(trial_.fods, 0);
        outcome.candidates = record.candidates->candidates.size();
        const std::vector<PlanTarget> targets = planTargets(record);
        const SearchFloor floor(trial_.collision, sight_, targets, parameters_.waypoints);
        const PhotoPlan plan = planPhotos(targets, floor, camera_, parameters_.waypoints, progress_);
        outcome.photos = plan.poses.size();
        outcome.candidatesWithoutPhoto =
            static_cast<std::size_t>(std::ranges::count(plan.views, 0.0, &CandidateView::share));
        for (const PhotoPose& pose : plan.poses) {
            progress_.throwIfCancelled();
            const std::vector<std::uint8_t>& seen = eyes_.fodSeenFrom(pose.pose_map);
            if (std::ranges::find(seen, 1) != seen.end()) ++outcome.photosWithFod;
            for (std::size_t i = 0; i < seen.size(); ++i)
                outcome.fodShown[i] |= seen[i];
        }
        return outcome;
    }

    const Measured& trial_;
    const Parameters& parameters_;
    std::size_t mostCandidates_;
    Progress& progress_;
    CameraFit camera_;
    Eyes eyes_;
    CostMap sight_;
    std::map<std::vector<std::vector<std::uint32_t>>, TrialOutcome> known_;
};

Measured measure(const std::shared_ptr<const ReferenceMap>& reference, const Trial& trial,
                 const std::filesystem::path& worlds, const Parameters& parameters, TrialPlacement placement,
                 Progress& progress) {
    Measured measured;
    measured.name = trial.name;
    measured.fods = trial.fods.size();
    measured.place = std::make_unique<PhotoTrial>(trial, worldFile(worlds, trial), parameters.camera);
    DetectionPipeline pipeline = pipelineFor(trial, reference, placement);
    const DetectionResult& detection = pipeline.run(parameters, progress, PipelineEnd::Discrepancy);
    if (!detection.field) {
        measured.failure = detection.registration.summary;
        return measured;
    }
    measured.detection.parameters = parameters;
    measured.detection.registration = detection.registration;
    measured.detection.floorHeight_m = floorHeight(*reference);
    measured.detection.field = detection.field;
    measured.grid = gridOf(trial, detection, measured.detection.floorHeight_m, parameters.occupancy);
    measured.collision = inflate(measured.grid, parameters.costMap);
    floodFill(measured.collision, measured.place->robotStart_map());
    return measured;
}

void require(const PhotoSearchSettings& settings) {
    std::string problems;
    for (const std::string& problem : parameterSearchProblems(settings.grid))
        problems += (problems.empty() ? "" : ", ") + problem;
    if (!(settings.recall > 0.0 && settings.recall <= 1.0))
        problems += std::string(problems.empty() ? "" : ", ") + "the recall is not over 0 and up to 1";
    if (settings.mostCandidates < 1)
        problems += std::string(problems.empty() ? "" : ", ") + "the most candidates are less than 1";
    if (!problems.empty()) throw Error("photo search", problems, "mend its settings");
}

std::vector<double> thresholdsOf(std::span<const Measured> trials, const ParameterSearchSettings& grid) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Measured& trial : trials) {
        if (!trial.detection.field) continue;
        const auto percentile =
            percentileOfKnown(trial.detection.field->smoothed(grid.metric), grid.lowestThresholdPercentile);
        if (percentile) lowest = std::min(lowest, *percentile);
    }
    if (!std::isfinite(lowest))
        throw Error("trials", "no map could be aligned and compared, so there is nothing to search in",
                    "check that trials and reference show the same space");
    lowest = grid.lowestThreshold.value_or(lowest);
    const double highest = grid.highestThreshold.value_or(usualHighestThreshold(grid.metric));
    if (lowest > highest)
        throw Error(
            "thresholds",
            "the lowest, " + std::to_string(lowest) + ", is greater than the highest, " + std::to_string(highest),
            "give a greater highest threshold");
    return linearSpace(lowest, highest, grid.thresholdCount);
}

/// Sums over the trials, in their order.
void sum(std::span<const Task> tasks, PhotoSearchResult& result) {
    const std::size_t levels = result.leastPoints.size();
    const auto index = [&](std::size_t cutoff, std::size_t threshold, std::size_t least) {
        return (cutoff * result.thresholds.size() + threshold) * levels + least;
    };
    result.outcomes.assign(result.cutoffs_m.size() * result.thresholds.size() * levels, PhotoOutcome());
    for (const Task& task : tasks) {
        for (std::size_t i = 0; i < task.outcomes.size(); ++i) {
            std::optional<PhotoOutcome>& total = result.outcomes[index(i / levels, task.threshold, i % levels)];
            const std::optional<TrialOutcome>& part = task.outcomes[i];
            if (!part) total.reset();
            if (!total) continue;
            total->photos += part->photos;
            total->photosWithFod += part->photosWithFod;
            total->fodsShown += static_cast<std::size_t>(std::ranges::count(part->fodShown, 1));
            total->candidates += part->candidates;
            total->candidatesWithoutPhoto += part->candidatesWithoutPhoto;
        }
    }
}

/// The points that no other beats in photos and FOD at once, by the FOD that they show.
void drawCurve(PhotoSearchResult& result) {
    std::map<std::size_t, PhotoChoice> fewest;
    const std::size_t levels = result.leastPoints.size(), thresholds = result.thresholds.size();
    for (std::size_t i = 0; i < result.outcomes.size(); ++i) {
        if (!result.outcomes[i]) continue;
        const PhotoChoice choice{{i / levels / thresholds, i / levels % thresholds, i % levels}, *result.outcomes[i]};
        const auto [known, isNew] = fewest.try_emplace(choice.outcome.fodsShown, choice);
        if (isNew) continue;
        const auto rank = [](const PhotoChoice& one) {
            return std::tuple(one.outcome.photos, -static_cast<std::ptrdiff_t>(one.outcome.photosWithFod),
                              one.point.cutoff, -static_cast<std::ptrdiff_t>(one.point.threshold),
                              one.point.leastPoints);
        };
        if (rank(choice) < rank(known->second)) known->second = choice;
    }
    for (const auto& [shown, choice] : fewest) {
        while (!result.curve.empty() && result.curve.back().outcome.photos >= choice.outcome.photos)
            result.curve.pop_back();
        result.curve.push_back(choice);
    }
    const double needed = result.settings.recall * static_cast<double>(result.fodCount) - 1e-9;
    for (const PhotoChoice& choice : result.curve) {
        if (static_cast<double>(choice.outcome.fodsShown) < needed) continue;
        result.best = choice;
        return;
    }
}

}  // namespace

struct PhotoSearchTrials::Parts {
    Parameters parameters;
    std::vector<Measured> trials;
    std::vector<std::string> nominalMaps;
    std::map<std::string, std::string> failures;
};

PhotoSearchTrials::PhotoSearchTrials(const std::shared_ptr<const ReferenceMap>& reference,
                                     std::span<const Trial> trials, const std::filesystem::path& worlds,
                                     const Parameters& parameters, TrialPlacement placement, Progress& progress)
    : parts_(std::make_unique<Parts>()) {
    const TrialSelection selection = selectTrials(trials, placement);
    requireWorlds(worlds, trials);
    parts_->parameters = parameters;
    parts_->nominalMaps = selection.nominalMaps;
    parts_->trials.resize(selection.withFod.size());
    SharedProgress shared(progress, "measuring " + std::to_string(selection.withFod.size()) + " trials",
                          static_cast<double>(selection.withFod.size()));
    tbb::parallel_for(
        std::size_t{0}, selection.withFod.size(),
        [&](std::size_t i) {
            Progress part = shared.forPart();
            try {
                // A thread that waits for a stage of one trial must not begin with another trial.
                tbb::this_task_arena::isolate([&] {
                    parts_->trials[i] = measure(reference, *selection.withFod[i], worlds, parameters, placement, part);
                });
            } catch (const Error& error) {
                rethrowNaming(*selection.withFod[i], error);
            }
            shared.add(1.0);
        },
        tbb::simple_partitioner());
    for (const Measured& trial : parts_->trials)
        if (!trial.failure.empty()) parts_->failures[trial.name] = trial.failure;
}

PhotoSearchTrials::~PhotoSearchTrials() = default;
PhotoSearchTrials::PhotoSearchTrials(PhotoSearchTrials&&) noexcept = default;

const std::vector<std::string>& PhotoSearchTrials::nominalMaps() const {
    return parts_->nominalMaps;
}

const std::map<std::string, std::string>& PhotoSearchTrials::failures() const {
    return parts_->failures;
}

ParameterSearchSettings usualPhotoGrid(const CandidateSettings& method) {
    ParameterSearchSettings grid;
    grid.metric = method.metric;
    grid.linkage = method.linkage;
    grid.centroid = method.centroid;
    grid.cutoffCount = 10;
    grid.thresholdCount = 12;
    grid.lowestThresholdPercentile = 97.0;
    return grid;
}

std::optional<double> PhotoOutcome::precision() const {
    if (photos == 0) return std::nullopt;
    return static_cast<double>(photosWithFod) / static_cast<double>(photos);
}

double PhotoSearchResult::recallOf(const PhotoOutcome& outcome) const {
    return static_cast<double>(outcome.fodsShown) / static_cast<double>(fodCount);
}

CandidateSettings PhotoSearchResult::settingsAt(const GridPoint& point) const {
    CandidateSettings candidates;
    candidates.metric = settings.grid.metric;
    candidates.linkage = settings.grid.linkage;
    candidates.centroid = settings.grid.centroid;
    candidates.clusterCutoff_m = cutoffs_m[point.cutoff];
    candidates.threshold = thresholds[point.threshold];
    candidates.minimumPoints = leastPoints[point.leastPoints];
    return candidates;
}

PhotoSearchResult searchPhotos(const PhotoSearchTrials& trials, const PhotoSearchSettings& settings,
                               Progress& progress) {
    require(settings);
    const std::vector<Measured>& measured = trials.parts_->trials;
    PhotoSearchResult result;
    result.settings = settings;
    result.trialCount = measured.size();
    for (const Measured& trial : measured)
        result.fodCount += trial.fods;
    const ParameterSearchSettings& grid = settings.grid;
    result.cutoffs_m = linearSpace(grid.lowestCutoff_m, grid.highestCutoff_m, grid.cutoffCount);
    result.thresholds = thresholdsOf(measured, grid);
    for (int least = grid.lowestLeastPoints; least <= grid.highestLeastPoints; ++least)
        result.leastPoints.push_back(least);

    // The lowest thresholds take longest and go first, so that the last ones to end are short.
    std::vector<Task> tasks;
    for (std::size_t threshold = 0; threshold < result.thresholds.size(); ++threshold)
        for (std::size_t trial = 0; trial < measured.size(); ++trial)
            if (measured[trial].detection.field) tasks.push_back({trial, threshold, {}});
    SharedProgress shared(progress, "photographing at every grid point",
                          static_cast<double>(tasks.size() * result.cutoffs_m.size()));
    std::atomic<std::size_t> next{0};
    // The index is not used: each call takes the first task that is left.
    tbb::parallel_for(
        std::size_t{0}, tasks.size(),
        [&](std::size_t) {
            Task& task = tasks[next++];
            Progress part = shared.forPart();
            Parameters parameters = trials.parts_->parameters;
            parameters.candidates = result.settingsAt({0, task.threshold, 0});
            tbb::this_task_arena::isolate([&] {
                TrialSearch search(measured[task.trial], parameters, settings.mostCandidates, part);
                for (const double cutoff_m : result.cutoffs_m) {
                    search.addCutoff(cutoff_m, result.leastPoints, task.outcomes);
                    shared.add(1.0);
                }
            });
        },
        tbb::simple_partitioner());
    sum(tasks, result);
    drawCurve(result);
    return result;
}

}  // namespace fodscope
