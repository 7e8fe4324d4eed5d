// SPDX-License-Identifier: MIT
#include "core/inspection/ReferenceFiles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
