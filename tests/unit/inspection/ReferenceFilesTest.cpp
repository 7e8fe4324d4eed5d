// SPDX-License-Identifier: MIT
#include "core/inspection/ReferenceFiles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/cloud/MeshIo.h"
#include "core/cloud/NeighbourIndex.h"
#include "core/cloud/PointCloudIo.h"
#include "core/common/Error.h"
#include "tests/fakes/SampleInspection.h"
#include "tests/unit/registration/SyntheticRoom.h"

namespace fodscope {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

/// Two maps of the room: the first in the room's frame, the second turned by a right angle and far away.
struct MapFiles {
    test::TemporaryFolder folder;
    Transform T_second_from_room = test::motion(90.0, {4.0, -6.0, 0.0});

    MapFiles() {
        PointCloud cloud;
        cloud.points = test::sample(test::roomPanels(), 700.0, 0.003, 1);
        writePointCloud(folder.file("first.pcd"), cloud);
        cloud.points = test::sample(test::roomPanels(), 700.0, 0.003, 2);
        for (Eigen::Vector3d& point : cloud.points)
            point = T_second_from_room * point;
        writePointCloud(folder.file("second.pcd"), cloud);
    }

    NominalMapsRequest request() const {
        NominalMapsRequest request;
        request.maps = {folder.file("first.pcd"), folder.file("second.pcd")};
        return request;
    }
};

void expectRoom(const ReferenceMap& reference) {
    const std::vector<Eigen::Vector3d> room = test::roomReference();
    const NeighbourIndex index(room);
    std::size_t near = 0;
    for (const Eigen::Vector3d& point : reference.points)
        near += index.nearest(point).squaredDistance_m2 < 0.0025;
    EXPECT_GT(static_cast<double>(near) / static_cast<double>(reference.size()), 0.97);
    EXPECT_TRUE(reference.hasCovariance());
}

TEST(ReferenceFiles, MapsAreMovedIntoTheFrameOfTheFirst) {
    const MapFiles files;
    Progress progress;
    const ReferenceMap reference = referenceFromMapFiles(files.request(), progress);
    expectRoom(reference);
    EXPECT_THAT(reference.provenance, Contains(HasSubstr("second.pcd: aligned")));
}

TEST(ReferenceFiles, MapsAreMovedIntoTheFrameOfAnotherMap) {
    const MapFiles files;
    NominalMapsRequest request = files.request();
    request.maps = {files.folder.file("second.pcd")};
    request.alignTo = files.folder.file("first.pcd");
    Progress progress;
    expectRoom(referenceFromMapFiles(request, progress));
}

TEST(ReferenceFiles, GivenTransformsReplaceTheRegistration) {
    const MapFiles files;
    NominalMapsRequest request = files.request();
    request.given_T_reference_from_map = {Transform::Identity(), files.T_second_from_room.inverse()};
    Progress progress;
    expectRoom(referenceFromMapFiles(request, progress));
    request.given_T_reference_from_map.pop_back();
    EXPECT_THROW(referenceFromMapFiles(request, progress), Error);
}

void writeRoomMesh(const std::filesystem::path& file) {
    TriangleMesh mesh;
    for (const test::Panel& panel : test::roomPanels()) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back(panel.corner);
        mesh.vertices.push_back(panel.corner + panel.first);
        mesh.vertices.push_back(panel.corner + panel.first + panel.second);
        mesh.vertices.push_back(panel.corner + panel.second);
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first, first + 2, first + 3});
    }
    writeMesh(file, mesh);
}

TEST(ReferenceFiles, NominalMapsGiveAMeshItsCovariances) {
    const MapFiles files;
    const std::filesystem::path mesh = files.folder.file("room.ply");
    writeRoomMesh(mesh);
    NominalMapsRequest request = files.request();
    request.mean.denoise.enabled = false;
    request.mean.covariance.smoothing.neighbourhood = SmoothingNeighbourhood::Ball;
    request.mean.covariance.smoothing.weights = SmoothingWeights::Gaussian;
    Progress progress;
    const ReferenceMap reference = referenceFromMeshAndMapFiles(mesh, {0.03, 1}, request, progress);
    EXPECT_EQ(reference.points, referenceFromMeshFile(mesh, 1.0, {0.03, 1}, progress).points);
    ASSERT_TRUE(reference.hasCovariance());
    EXPECT_TRUE(reference.occupancy.empty());
    std::size_t samples = 0;
    for (const auto& name : request.maps)
        samples += readPointCloud(name).size();
    EXPECT_EQ(std::accumulate(reference.sampleCount.begin(), reference.sampleCount.end(), std::size_t{0}), samples);
    EXPECT_THAT(reference.provenance, Contains("covariances from 2 nominal maps"));
    EXPECT_THAT(reference.provenance, Contains("covariance_radius_m 0.2 covariance_sigma_m 0.05"));
    EXPECT_THAT(reference.provenance, Contains(HasSubstr("second.pcd: aligned")));
    // In the middle of the floor the maps vary by their noise of 3 mm in z, and by the alignment's error.
    for (std::size_t i = 0; i < reference.size(); ++i) {
        if ((reference.points[i] - Eigen::Vector3d(2.0, 1.5, 0.0)).norm() > 0.3) continue;
        EXPECT_EQ(reference.untrained[i], 0);
        EXPECT_NEAR(std::sqrt(reference.covariance[i](2, 2)), 0.003, 0.002);
    }
}

TEST(ReferenceFiles, WhatIsWrongWithCovarianceMapsIsToldByTheirFile) {
    const MapFiles files;
    const std::filesystem::path mesh = files.folder.file("room.ply");
    writeRoomMesh(mesh);
    Progress progress;
    NominalMapsRequest request;
    EXPECT_THROW(referenceFromMeshAndMapFiles(mesh, {0.05, 1}, request, progress), Error);
    request.maps = {files.folder.file("missing.pcd")};
    try {
        referenceFromMeshAndMapFiles(mesh, {0.05, 1}, request, progress);
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("missing.pcd"));
    }
}

TEST(ReferenceFiles, AMeshThatIsTooSmallForTheSpacingIsRefused) {
    const test::TemporaryFolder folder;
    writeMesh(folder.file("speck.stl"), {{{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}}, {{0, 1, 2}}, {}});
    Progress progress;
    try {
        referenceFromMeshFile(folder.file("speck.stl"), 1.0, {0.01, 1}, progress);
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("speck.stl"));
        EXPECT_THAT(error.what(), HasSubstr("scale"));
    }
}

}  // namespace
}  // namespace fodscope
