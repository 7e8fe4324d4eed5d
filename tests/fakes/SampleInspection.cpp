// SPDX-License-Identifier: MIT
#include "tests/fakes/SampleInspection.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <limits>

namespace fodscope::test {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// NaN equals NaN here.
bool same(const std::vector<double>& a, const std::vector<double>& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i] != b[i] && !(std::isnan(a[i]) && std::isnan(b[i]))) return false;
    }
    return true;
}

void expectEqual(const ReferenceMap& actual, const ReferenceMap& expected) {
    EXPECT_EQ(actual.points, expected.points);
    EXPECT_EQ(actual.occupancy, expected.occupancy);
    EXPECT_EQ(actual.sampleCount, expected.sampleCount);
    EXPECT_EQ(actual.covariance, expected.covariance);
    EXPECT_EQ(actual.untrained, expected.untrained);
    EXPECT_EQ(actual.provenance, expected.provenance);
}

void expectEqual(const DiscrepancyField& actual, const DiscrepancyField& expected) {
    EXPECT_EQ(actual.points, expected.points);
    EXPECT_EQ(actual.weights, expected.weights);
    EXPECT_EQ(actual.nearest, expected.nearest);
    EXPECT_TRUE(same(actual.euclidean_m, expected.euclidean_m));
    EXPECT_TRUE(same(actual.mahalanobis, expected.mahalanobis));
    EXPECT_TRUE(same(actual.smoothedEuclidean_m, expected.smoothedEuclidean_m));
    EXPECT_TRUE(same(actual.smoothedMahalanobis, expected.smoothedMahalanobis));
    EXPECT_TRUE(same(actual.chiSquare, expected.chiSquare));
}

void expectEqual(const CandidateSet& actual, const CandidateSet& expected) {
    EXPECT_EQ(actual.candidateOfVoxel, expected.candidateOfVoxel);
    EXPECT_EQ(actual.pointsAboveThreshold, expected.pointsAboveThreshold);
    ASSERT_EQ(actual.candidates.size(), expected.candidates.size());
    for (std::size_t i = 0; i < expected.candidates.size(); ++i) {
        const Candidate& a = actual.candidates[i];
        const Candidate& b = expected.candidates[i];
        EXPECT_EQ(a.id, b.id);
        EXPECT_EQ(a.voxels, b.voxels);
        EXPECT_EQ(a.centroid_reference, b.centroid_reference);
        EXPECT_EQ(a.centroid_map, b.centroid_map);
        EXPECT_EQ(a.size_m, b.size_m);
        EXPECT_EQ(a.lengthDirection_rad, b.lengthDirection_rad);
        EXPECT_EQ(a.heightAboveFloor_m, b.heightAboveFloor_m);
        EXPECT_EQ(a.discrepancyMax, b.discrepancyMax);
        EXPECT_EQ(a.discrepancyMean, b.discrepancyMean);
        EXPECT_EQ(a.discrepancySum, b.discrepancySum);
    }
}

void expectEqual(const DetectionRecord& actual, const DetectionRecord& expected) {
    EXPECT_EQ(actual.parameters, expected.parameters);
    EXPECT_EQ(actual.floorHeight_m, expected.floorHeight_m);
    const RegistrationResult& a = actual.registration;
    const RegistrationResult& b = expected.registration;
    EXPECT_EQ(a.T_reference_from_map.matrix(), b.T_reference_from_map.matrix());
    EXPECT_EQ(a.quality, b.quality);
    EXPECT_EQ(a.converged, b.converged);
    EXPECT_EQ(a.rms_m, b.rms_m);
    EXPECT_EQ(a.overlap, b.overlap);
    EXPECT_EQ(a.explained, b.explained);
    EXPECT_EQ(a.summary, b.summary);
    ASSERT_EQ(a.start_T_reference_from_map.has_value(), b.start_T_reference_from_map.has_value());
    if (b.start_T_reference_from_map) {
        EXPECT_EQ(a.start_T_reference_from_map->matrix(), b.start_T_reference_from_map->matrix());
    }
    ASSERT_EQ(a.alternatives.size(), b.alternatives.size());
    for (std::size_t i = 0; i < b.alternatives.size(); ++i) {
        EXPECT_EQ(a.alternatives[i].T_reference_from_map.matrix(), b.alternatives[i].T_reference_from_map.matrix());
        EXPECT_EQ(a.alternatives[i].rms_m, b.alternatives[i].rms_m);
        EXPECT_EQ(a.alternatives[i].overlap, b.alternatives[i].overlap);
        EXPECT_EQ(a.alternatives[i].explained, b.alternatives[i].explained);
    }
    ASSERT_EQ(a.uncertainty.has_value(), b.uncertainty.has_value());
    if (b.uncertainty) {
        EXPECT_EQ(a.uncertainty->centre_reference, b.uncertainty->centre_reference);
        EXPECT_EQ(a.uncertainty->covariance, b.uncertainty->covariance);
        EXPECT_EQ(a.uncertainty->looseDirections, b.uncertainty->looseDirections);
        EXPECT_EQ(a.uncertainty->looseTurn, b.uncertainty->looseTurn);
    }
    ASSERT_EQ(actual.field != nullptr, expected.field != nullptr);
    if (expected.field) expectEqual(*actual.field, *expected.field);
    ASSERT_EQ(actual.candidates != nullptr, expected.candidates != nullptr);
    if (expected.candidates) expectEqual(*actual.candidates, *expected.candidates);
    ASSERT_EQ(actual.coverage != nullptr, expected.coverage != nullptr);
    if (!expected.coverage) return;
    EXPECT_EQ(actual.coverage->observed, expected.coverage->observed);
    EXPECT_EQ(actual.coverage->observedShare, expected.coverage->observedShare);
    EXPECT_EQ(actual.coverage->leftOut, expected.coverage->leftOut);
}

void expectEqual(const VisitPlan& actual, const VisitPlan& expected) {
    EXPECT_EQ(actual.length_m, expected.length_m);
    EXPECT_EQ(actual.start_map, expected.start_map);
    ASSERT_EQ(actual.waypoints.size(), expected.waypoints.size());
    for (std::size_t i = 0; i < expected.waypoints.size(); ++i) {
        const Waypoint& a = actual.waypoints[i];
        const Waypoint& b = expected.waypoints[i];
        EXPECT_EQ(a.id, b.id);
        EXPECT_EQ(a.candidateIds, b.candidateIds);
        EXPECT_EQ(a.pose_map, b.pose_map);
        EXPECT_EQ(a.cost, b.cost);
        EXPECT_EQ(a.status, b.status);
        EXPECT_EQ(a.drive.points_map, b.drive.points_map);
        EXPECT_EQ(a.drive.length_m, b.drive.length_m);
    }
}

void expectEqual(const Photo& a, const Photo& b) {
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.waypointId, b.waypointId);
    EXPECT_EQ(a.candidateIds, b.candidateIds);
    EXPECT_EQ(a.taken, b.taken);
    EXPECT_EQ(a.T_map_from_camera.matrix(), b.T_map_from_camera.matrix());
    EXPECT_EQ(a.intrinsics, b.intrinsics);
    EXPECT_EQ(a.mediaType, b.mediaType);
    EXPECT_EQ(a.bytes, b.bytes);
    EXPECT_EQ(a.sha256, b.sha256);
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
    std::string name = testing::TempDir() + "fodscope-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

InspectionHeader sampleHeader() {
    InspectionHeader header;
    header.id = "0123456789abcdef0123456789abcdef";
    header.title = "Tank 3, starboard";
    header.ship = "USS \"Example\"";
    header.tank = "3-64-1";
    header.workOrder = "WO-17";
    header.inspector = "Ingrid Sørensen";
    header.robot = "simulated robot";
    header.created = {1'795'000'000'123};
    header.softwareVersion = "0.1.0";
    return header;
}

ReferenceMap sampleReference() {
    ReferenceMap reference;
    reference.points = {{0.1, 0.2, 0.3}, {1.0 / 3.0, -2.5e-7, 4.0}, {5, 6, 7}};
    reference.occupancy = {3, 4, 5};
    reference.sampleCount = {10, 0, 30};
    Eigen::Matrix3d covariance;
    covariance << 1e-4, 2e-5, 3e-6, 2e-5, 4e-4, 5e-6, 3e-6, 5e-6, 6e-4;
    reference.covariance = {covariance, covariance * 2, covariance / 3};
    reference.untrained = {0, 1, 0};
    reference.provenance = {"from 15 nominal maps", "voxel 0.05 m"};
    return reference;
}

DetectionResult sampleDetection() {
    auto field = std::make_shared<DiscrepancyField>();
    field->points = {{0, 0, 0}, {0.02, 0, 0}, {0.5, 0.5, 0.1}, {0.52, 0.5, 0.1}, {2, 2, 2}};
    field->weights = {1, 2, 3, 4, 5};
    field->nearest = {0, 0, 1, 1, 2};
    field->euclidean_m = {0.1, 0.2, 0.3, 0.4, 0.0};
    field->mahalanobis = {3.5, 3.25, kUnknown, 4.0, 0.5};
    field->smoothedEuclidean_m = {0.11, 0.12, 0.13, 0.14, 0.15};
    field->smoothedMahalanobis = {3.0, 3.1, 3.2, 3.3, kUnknown};
    field->chiSquare = {1.5, 250.0, kUnknown, 3162.25, 4.5};

    auto candidates = std::make_shared<CandidateSet>();
    candidates->candidateOfVoxel = {0, 0, 1, 1, -1};
    candidates->pointsAboveThreshold = 4;
    for (int i = 0; i < 2; ++i) {
        Candidate candidate;
        candidate.id = "C-00" + std::to_string(i + 1);
        candidate.voxels = i == 0 ? std::vector<std::uint32_t>{0, 1} : std::vector<std::uint32_t>{2, 3};
        candidate.centroid_reference = {0.01 + i, 1.0 / 7.0, 0.05};
        candidate.centroid_map = {0.02 + i, -0.3, 0.04};
        candidate.size_m = {0.25, 0.1, 0.0625};
        candidate.lengthDirection_rad = 0.3;
        candidate.heightAboveFloor_m = 0.0375;
        candidate.discrepancyMax = 3.1 + i;
        candidate.discrepancyMean = 3.05 + i;
        candidate.discrepancySum = 6.1 + i;
        candidates->candidates.push_back(candidate);
    }
    auto coverage = std::make_shared<Coverage>();
    coverage->observed = {1, 0, 1};
    coverage->observedShare = 2.0 / 3.0;
    coverage->leftOut = 0;

    DetectionResult result;
    result.registration.T_reference_from_map = transformFromPose({0.125, -1.0 / 3.0, 0.7});
    result.registration.quality = RegistrationQuality::Good;
    result.registration.converged = true;
    result.registration.rms_m = 0.0081;
    result.registration.overlap = 0.94;
    result.registration.explained = 0.875;
    result.registration.summary = "aligned, 8 mm rms, 94 % overlap";
    result.registration.start_T_reference_from_map = transformFromPose({0.1, -0.3, 0.65});
    PoseUncertainty uncertainty;
    uncertainty.centre_reference = {1.0, 2.0, 1.0 / 3.0};
    uncertainty.covariance.diagonal() << 4e-6, 5e-6, 1e-6, 1e-7, 2e-7, 3e-7;
    uncertainty.covariance(0, 5) = uncertainty.covariance(5, 0) = 1e-7;
    result.registration.uncertainty = uncertainty;
    result.field = field;
    result.candidates = candidates;
    result.coverage = coverage;
    result.floorHeight_m = 0.0125;
    return result;
}

OccupancyGrid sampleGrid() {
    OccupancyGrid grid;
    grid.width = 3;
    grid.height = 2;
    grid.resolution_m = 0.05;
    grid.origin_map = {-1.5, 0.25, 0.0};
    grid.cells = {Cell::Free, Cell::Occupied, Cell::Unknown, Cell::Free, Cell::Free, Cell::Occupied};
    return grid;
}

VisitPlan samplePlan() {
    VisitPlan plan;
    plan.start_map = {0.1, 0.2, 0.3};
    plan.length_m = 1.75;
    Waypoint reached;
    reached.id = "W-01";
    reached.candidateIds = {"C-002"};
    reached.pose_map = Pose2{0.5, 1.0 / 3.0, -1.2};
    reached.cost = 12.5;
    reached.status = WaypointStatus::Ok;
    reached.drive.points_map = {{0.1, 0.2}, {0.3, 0.25}, {0.5, 1.0 / 3.0}};
    reached.drive.length_m = 1.75;
    Waypoint hidden;
    hidden.id = "W-02";
    hidden.candidateIds = {"C-001"};
    hidden.status = WaypointStatus::Hidden;
    plan.waypoints = {reached, hidden};
    return plan;
}

Photo samplePhoto(const std::string& waypointId, const std::string& candidateId, const std::string& content) {
    Photo photo;
    photo.waypointId = waypointId;
    photo.candidateIds = {candidateId};
    photo.taken = {1'795'000'100'000};
    photo.T_map_from_camera = transformFromPose({0.4, 0.3, 0.2});
    // 3 m off, so that both candidates lie in the picture.
    photo.T_map_from_camera.translation().z() = -3.0;
    photo.intrinsics = {1280, 720, 931.5, 931.5, 640, 360};
    photo.mediaType = "image/jpeg";
    for (const char c : content) {
        photo.bytes.push_back(static_cast<std::byte>(c));
    }
    return photo;
}

LabelSet sampleLabels() {
    return parseLabelSet("{name: Tools, labels: [hammer, drill]}", "sample");
}

void fillInspection(Inspection& inspection) {
    inspection.setHeader(sampleHeader());
    inspection.setReference({"reference.ply", std::string(64, 'a'), 3},
                            std::make_shared<const ReferenceMap>(sampleReference()));
    inspection.setMap({"map.pcd", std::string(64, 'b'), 259'681});
    Parameters parameters = presetParameters("paper-physical");
    parameters.candidates.threshold = 2.9;
    inspection.adoptDetection(parameters, sampleDetection());
    parameters.waypoints.minimumDistance_m = 0.45;
    inspection.setParameters(parameters);
    inspection.adoptPlan(sampleGrid(), samplePlan());
    inspection.updateVisit({"W-01", VisitState::Driving, "goal-1", {}, "", 1, 0});
    inspection.updateVisit({"W-01", VisitState::Done, "goal-1", {}, "", 1, 1});
    inspection.updateVisit({"W-02", VisitState::Skipped, "", VisitReason::NoPose, "hidden", 0, 0});
    inspection.addPhoto(samplePhoto("W-01", "C-002", "first photo"));
    inspection.addPhoto(samplePhoto("W-01", "C-002", std::string("second\0photo", 12)));
    inspection.setLabelSet(sampleLabels());
    inspection.decide("P-001", "Anna", {{"hammer", PixelBox{10, 20, 30.5, 40}}, {"drill", std::nullopt}},
                      "two, \"both\"", {1'795'000'200'000});
    inspection.decide("P-002", "Anna", {{kNotSure, std::nullopt}}, "", {1'795'000'201'000});
    inspection.undoDecision("Anna", {1'795'000'202'000});
    inspection.reportIssued({{1'795'000'300'000}, "Ingrid Sørensen", "report.pdf", std::string(64, 'c')});
}

void expectEqual(const InspectionState& actual, const InspectionState& expected) {
    EXPECT_EQ(actual.header, expected.header);
    EXPECT_EQ(actual.referenceSource, expected.referenceSource);
    EXPECT_EQ(actual.mapSource, expected.mapSource);
    ASSERT_EQ(actual.reference != nullptr, expected.reference != nullptr);
    if (expected.reference) expectEqual(*actual.reference, *expected.reference);
    EXPECT_EQ(actual.parameters, expected.parameters);
    ASSERT_EQ(actual.detection.has_value(), expected.detection.has_value());
    if (expected.detection) expectEqual(*actual.detection, *expected.detection);
    EXPECT_EQ(actual.highestCandidateNumber, expected.highestCandidateNumber);
    ASSERT_EQ(actual.grid_map.has_value(), expected.grid_map.has_value());
    if (expected.grid_map) {
        EXPECT_EQ(actual.grid_map->width, expected.grid_map->width);
        EXPECT_EQ(actual.grid_map->height, expected.grid_map->height);
        EXPECT_EQ(actual.grid_map->resolution_m, expected.grid_map->resolution_m);
        EXPECT_EQ(actual.grid_map->origin_map, expected.grid_map->origin_map);
        EXPECT_EQ(actual.grid_map->cells, expected.grid_map->cells);
    }
    ASSERT_EQ(actual.plan.has_value(), expected.plan.has_value());
    if (expected.plan) expectEqual(*actual.plan, *expected.plan);
    EXPECT_EQ(actual.visits, expected.visits);
    ASSERT_EQ(actual.photos.size(), expected.photos.size());
    for (std::size_t i = 0; i < expected.photos.size(); ++i) {
        expectEqual(actual.photos[i], expected.photos[i]);
    }
    EXPECT_EQ(actual.labelSet, expected.labelSet);
    EXPECT_EQ(actual.decisions, expected.decisions);
    EXPECT_EQ(actual.reports, expected.reports);
}

}  // namespace fodscope::test
