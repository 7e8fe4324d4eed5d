// SPDX-License-Identifier: MIT
#include "tests/fakes/TankInspection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/common/Hash.h"
#include "core/inspection/Inspection.h"
#include "core/planning/OccupancyGrid.h"
#include "tests/fakes/SamplePhoto.h"

namespace fodscope {

namespace {

constexpr double kVoxel_m = 0.02;
constexpr double kLength_m = 3.2;
constexpr double kWidth_m = 2.6;
constexpr double kCell_m = 0.05;
constexpr std::int64_t kBegun_ms = 1'795'255'200'000;

struct Thing {
    double x_m, y_m, length_m, width_m, height_m;
    unsigned colour;
};

/// Things of the first eight candidates, map frame; the last lies behind the partition where no robot gets.
constexpr std::array<Thing, 8> kThings{{{0.85, 0.62, 0.28, 0.06, 0.06, 0xffd9a13cU},
                                        {2.40, 0.70, 0.20, 0.10, 0.14, 0xffe0d020U},
                                        {1.55, 1.95, 0.10, 0.10, 0.06, 0xffd04030U},
                                        {0.70, 1.90, 0.22, 0.04, 0.04, 0xff3060c0U},
                                        {2.05, 1.35, 0.16, 0.08, 0.06, 0xff909aa0U},
                                        {1.25, 0.55, 0.24, 0.08, 0.04, 0xff40a060U},
                                        {2.35, 2.00, 0.18, 0.12, 0.08, 0xffa06030U},
                                        {2.98, 2.35, 0.12, 0.08, 0.06, 0xff808890U}}};

Thing thingAt(int index) {
    if (index < static_cast<int>(kThings.size())) return kThings[static_cast<std::size_t>(index)];
    const int more = index - static_cast<int>(kThings.size());
    Thing thing = kThings[static_cast<std::size_t>(more) % 7];
    thing.x_m = 0.5 + 2.0 * std::fmod(more * 0.381966, 1.0);
    thing.y_m = 0.5 + 1.6 * std::fmod(more * 0.618034, 1.0);
    return thing;
}

Transform turnedFrame() {
    Transform T_reference_from_map = Transform::Identity();
    T_reference_from_map.rotate(Eigen::AngleAxisd(0.35, Eigen::Vector3d::UnitZ()));
    T_reference_from_map.pretranslate(Eigen::Vector3d(12.0, -4.0, 0.5));
    return T_reference_from_map;
}

std::string numbered(const char* prefix, int number) {
    std::string digits = std::to_string(number);
    return prefix + std::string(digits.size() < 3 ? 3 - digits.size() : 0, '0') + digits;
}

std::vector<Eigen::Vector3d> shellPoints_map(double step_m) {
    std::vector<Eigen::Vector3d> points;
    for (double x = 0.0; x <= kLength_m; x += step_m) {
        for (double y = 0.0; y <= kWidth_m; y += step_m)
            points.emplace_back(x, y, 0.0);
        for (double z = step_m; z <= 0.9; z += step_m) {
            points.emplace_back(x, 0.0, z);
            points.emplace_back(x, kWidth_m, z);
        }
    }
    for (double y = 0.0; y <= kWidth_m; y += step_m) {
        for (double z = step_m; z <= 0.9; z += step_m) {
            points.emplace_back(0.0, y, z);
            points.emplace_back(kLength_m, y, z);
        }
    }
    return points;
}

void appendVoxel(DiscrepancyField& field, const Eigen::Vector3d& point_reference, double euclidean_m) {
    field.points.push_back(point_reference);
    field.weights.push_back(12);
    field.nearest.push_back(0);
    field.euclidean_m.push_back(euclidean_m);
    field.mahalanobis.push_back(euclidean_m / 0.01);
    field.smoothedEuclidean_m.push_back(euclidean_m);
    field.smoothedMahalanobis.push_back(euclidean_m / 0.01);
}

Candidate makeCandidate(int index, const Thing& thing, const Transform& T_reference_from_map, DiscrepancyField& field) {
    Candidate candidate;
    candidate.id = numbered("C-", index + 1);
    for (double x = 0.5 * kVoxel_m; x < thing.length_m; x += kVoxel_m) {
        for (double y = 0.5 * kVoxel_m; y < thing.width_m; y += kVoxel_m) {
            for (double z = 0.5 * kVoxel_m; z < thing.height_m; z += kVoxel_m) {
                const Eigen::Vector3d point_map(thing.x_m - 0.5 * thing.length_m + x,
                                                thing.y_m - 0.5 * thing.width_m + y, z);
                candidate.voxels.push_back(static_cast<std::uint32_t>(field.size()));
                appendVoxel(field, T_reference_from_map * point_map, 0.028 + z);
            }
        }
    }
    candidate.centroid_map = Eigen::Vector3d(thing.x_m, thing.y_m, 0.5 * thing.height_m);
    candidate.centroid_reference = T_reference_from_map * candidate.centroid_map;
    candidate.size_m = Eigen::Vector3d(thing.length_m, thing.width_m, thing.height_m);
    candidate.lengthDirection_rad = 0.35;
    candidate.heightAboveFloor_m = 0.5 * thing.height_m;
    candidate.discrepancyMax = (0.028 + thing.height_m) / 0.01;
    candidate.discrepancyMean = (0.028 + 0.5 * thing.height_m) / 0.01;
    candidate.discrepancySum = candidate.discrepancyMean * static_cast<double>(candidate.voxels.size());
    return candidate;
}

/// Walls, a column, a partition with a corner behind it that the robot cannot enter, and a strip that nobody saw.
OccupancyGrid sampleGrid() {
    OccupancyGrid grid;
    grid.resolution_m = kCell_m;
    grid.origin_map = {-0.3, -0.3, 0.0};
    grid.width = static_cast<int>(std::lround((kLength_m + 0.6) / kCell_m));
    grid.height = static_cast<int>(std::lround((kWidth_m + 0.6) / kCell_m));
    for (int row = 0; row < grid.height; ++row) {
        for (int column = 0; column < grid.width; ++column) {
            const Eigen::Vector2d centre = grid.centreOf({column, row});
            const bool inside = centre.x() > 0 && centre.y() > 0 && centre.x() < kLength_m && centre.y() < kWidth_m;
            const bool wall = !inside && centre.x() > -0.06 && centre.y() > -0.06 && centre.x() < kLength_m + 0.06 &&
                              centre.y() < kWidth_m + 0.06;
            const bool column_ = (centre - Eigen::Vector2d(1.45, 1.25)).norm() < 0.1;
            const bool partition = centre.x() > 2.62 && centre.x() < 2.72 && centre.y() > 1.5;
            const bool sill = centre.x() > 2.62 && centre.y() > 1.5 && centre.y() < 1.58;
            const bool unseen = inside && centre.x() < 0.3 && centre.y() > 2.2;
            grid.cells.push_back(unseen || !(inside || wall)            ? Cell::Unknown
                                 : wall || column_ || partition || sill ? Cell::Occupied
                                                                        : Cell::Free);
        }
    }
    return grid;
}

DetectionRecord makeDetection(int candidates, const ReferenceMap& reference) {
    DetectionRecord detection;
    detection.parameters = presetParameters("paper-physical");
    detection.registration.T_reference_from_map = turnedFrame();
    detection.registration.quality = RegistrationQuality::Good;
    detection.registration.converged = true;
    detection.registration.rms_m = 0.008;
    detection.registration.overlap = 0.94;
    detection.registration.summary = "aligned, 8 mm rms, 94 % overlap";
    detection.floorHeight_m = 0.5;
    auto field = std::make_shared<DiscrepancyField>();
    for (const Eigen::Vector3d& point_map : shellPoints_map(0.04)) {
        appendVoxel(*field, turnedFrame() * point_map, 0.004);
    }
    auto set = std::make_shared<CandidateSet>();
    for (int index = 0; index < candidates; ++index) {
        set->candidates.push_back(makeCandidate(index, thingAt(index), turnedFrame(), *field));
    }
    set->candidateOfVoxel.assign(field->size(), -1);
    for (std::size_t index = 0; index < set->candidates.size(); ++index) {
        for (const std::uint32_t voxel : set->candidates[index].voxels) {
            set->candidateOfVoxel[voxel] = static_cast<std::int32_t>(index);
        }
        set->pointsAboveThreshold += set->candidates[index].voxels.size();
    }
    auto coverage = std::make_shared<Coverage>();
    coverage->observed.assign(reference.size(), 1);
    const std::size_t unseen = reference.size() * 7 / 100;
    for (std::size_t index = 0; index < unseen; ++index)
        coverage->observed[index] = 0;
    coverage->observedShare = 1.0 - static_cast<double>(unseen) / static_cast<double>(reference.size());
    detection.field = field;
    detection.candidates = set;
    detection.coverage = coverage;
    return detection;
}

std::vector<SampleBlock> blocksOf(int candidates) {
    std::vector<SampleBlock> blocks{{{1.37, 1.17, 0.0}, {1.53, 1.33, 0.9}, 0xff788088U},
                                    {{2.62, 1.5, 0.0}, {2.72, kWidth_m, 0.9}, 0xff6a7278U},
                                    {{-0.05, -0.05, 0.0}, {kLength_m, 0.0, 0.9}, 0xff7c8288U},
                                    {{-0.05, kWidth_m, 0.0}, {kLength_m, kWidth_m + 0.05, 0.9}, 0xff7c8288U},
                                    {{-0.05, 0.0, 0.0}, {0.0, kWidth_m, 0.9}, 0xff747a80U},
                                    {{kLength_m, 0.0, 0.0}, {kLength_m + 0.05, kWidth_m, 0.9}, 0xff747a80U}};
    for (int index = 0; index < candidates; ++index) {
        const Thing thing = thingAt(index);
        if (index == 3) continue;  // what was measured there is no thing: the photo shows bare floor
        blocks.push_back({{thing.x_m - 0.5 * thing.length_m, thing.y_m - 0.5 * thing.width_m, 0.0},
                          {thing.x_m + 0.5 * thing.length_m, thing.y_m + 0.5 * thing.width_m, thing.height_m},
                          thing.colour});
    }
    return blocks;
}

void visit(InspectionState& state, int candidates) {
    const std::vector<SampleBlock> blocks = blocksOf(candidates);
    for (const Waypoint& waypoint : state.plan->waypoints) {
        Visit visit{waypoint.id, VisitState::Done, waypoint.id + "/1", {}, {}, 1, 1};
        if (!waypoint.pose_map) {
            visit.state = VisitState::Skipped;
            visit.reason = VisitReason::NoPose;
            visit.detail = toString(waypoint.status);
            state.visits.push_back(visit);
            continue;
        }
        state.visits.push_back(visit);
        Photo photo;
        photo.id = numbered("P-", static_cast<int>(state.photos.size()) + 1);
        photo.waypointId = waypoint.id;
        photo.candidateIds = waypoint.candidateIds;
        photo.taken = {kBegun_ms + 600'000 + 20'000 * static_cast<std::int64_t>(state.photos.size())};
        photo.T_map_from_camera = sampleCameraPose(*waypoint.pose_map);
        photo.intrinsics = sampleIntrinsics();
        photo.mediaType = "image/jpeg";
        photo.bytes = samplePhoto(blocks, photo.T_map_from_camera, photo.intrinsics);
        photo.sha256 = sha256(photo.bytes);
        state.photos.push_back(std::move(photo));
    }
}

/// A photo of its own for each candidate, so that one can speak of "the photo of C-003".
void planOneByOne(InspectionState& state, const Pose2& robot_map) {
    Progress progress;
    state.parameters.waypoints.order = VisitOrder::NearestNext;
    state.plan = planInspection(state, *state.grid_map, robot_map, progress);
    VisitPlan plan = *state.plan;
    plan.waypoints.clear();
    plan.length_m = 0.0;
    plan.nearestNextLength_m.reset();
    plan.shortestTourLength_m.reset();
    for (const Candidate& candidate : state.detection->candidates->candidates) {
        InspectionState alone = state;
        auto set = std::make_shared<CandidateSet>(*state.detection->candidates);
        set->candidates = {candidate};
        alone.detection->candidates = set;
        const VisitPlan own = planInspection(alone, *state.grid_map, robot_map, progress);
        plan.length_m += own.length_m;
        plan.waypoints.insert(plan.waypoints.end(), own.waypoints.begin(), own.waypoints.end());
    }
    std::ranges::stable_partition(plan.waypoints,
                                  [](const Waypoint& waypoint) { return waypoint.pose_map.has_value(); });
    for (std::size_t i = 0; i < plan.waypoints.size(); ++i)
        plan.waypoints[i].id = (i < 9 ? "W-0" : "W-") + std::to_string(i + 1);
    state.plan = plan;
}

std::string answerOf(const InspectionState& state, const Photo& photo) {
    const std::string& id = photo.candidateIds.front();
    if (id == "C-004") return kNoFod;
    if (id == "C-005") return kNotSure;
    const auto number = static_cast<std::size_t>(std::stoi(id.substr(2)));
    return state.labelSet.labels[(number - 1) % 9].name;
}

void decide(InspectionState& state) {
    std::int64_t now_ms = kBegun_ms + 3'600'000;
    for (const Photo& photo : state.photos) {
        Decision decision;
        decision.photoId = photo.id;
        decision.labeller = "Anna Bergström";
        decision.time = {now_ms += 9'000};
        decision.labels = {{answerOf(state, photo), std::nullopt}};
        if (photo.candidateIds.front() == "C-001") {
            decision.labels.front().box = PixelBox{520, 300, 260, 150};
            decision.comment = "Handle towards the bulkhead; wear marks <5 mm & \"taped\".";
        }
        if (photo.candidateIds.front() == "C-005") decision.comment = "Too dark to tell.";
        state.decisions.push_back(decision);
        if (photo.candidateIds.front() != "C-006" && photo.candidateIds.front() != "C-001") continue;
        Decision second = decision;
        second.labeller = "Piet de Vries";
        second.time = {now_ms + 7'200'000};
        second.comment.clear();
        if (photo.candidateIds.front() == "C-006") second.labels = {{kNoFod, std::nullopt}};
        state.decisions.push_back(second);
    }
}

}  // namespace

InspectionState tankInspection(const TankOptions& options) {
    InspectionState state;
    state.header.id = "5f0c2a9b7d1e4f6383a4c5d6e7f80912";
    state.header.title = "Ballast tank 5-WT-2, after hot work";
    state.header.ship = "MV Example";
    state.header.tank = "5-WT-2";
    state.header.workOrder = "WO-4711";
    state.header.inspector = "Anna Bergström";
    state.header.robot = "simulated robot";
    state.header.created = {kBegun_ms};
    state.header.softwareVersion = "0.1.0";
    auto reference = std::make_shared<ReferenceMap>();
    for (const Eigen::Vector3d& point_map : shellPoints_map(0.05)) {
        reference->points.push_back(turnedFrame() * point_map);
    }
    state.reference = reference;
    state.referenceSource = {"/data/tank-5-WT-2/reference.ply", sha256("reference"), reference->size()};
    state.mapSource = {"/data/tank-5-WT-2/map.pcd", sha256("map"), 184'233};
    state.parameters = presetParameters("paper-physical");
    state.detection = makeDetection(options.candidates, *reference);
    state.highestCandidateNumber = options.candidates;
    state.labelSet = parseLabelSet(
        "name: Tools\n"
        "labels: [{name: hammer, key: 1}, {name: drill, key: 2}, {name: tape measure, key: 3}, {name: screwdriver, "
        "key: "
        "4}, {name: sander, key: 5}, {name: crimper, key: 6}, {name: wrench, key: 7}, {name: level, key: 8}, {name: "
        "other FOD, key: 9}]\n",
        "sample label set");
    if (!options.visited) return state;
    state.grid_map = sampleGrid();
    planOneByOne(state, {0.6, 1.25, 0.0});
    visit(state, options.candidates);
    if (options.decided) decide(state);
    return state;
}

}  // namespace fodscope
