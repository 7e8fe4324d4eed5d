// SPDX-License-Identifier: MIT
#include "ui/labelling/CandidateOutline.h"

#include <gtest/gtest.h>

#include <QRectF>

#include "core/inspection/PhotoProjection.h"
#include "tests/fakes/SamplePhoto.h"
#include "tests/fakes/TankInspection.h"

namespace fodscope {
namespace {

CameraIntrinsics camera() {
    CameraIntrinsics intrinsics;
    intrinsics.width_px = 640;
    intrinsics.height_px = 480;
    intrinsics.fx_px = 500.0;
    intrinsics.fy_px = 510.0;
    intrinsics.cx_px = 320.0;
    intrinsics.cy_px = 240.0;
    return intrinsics;
}

TEST(ProjectedOutline, SurroundsAVoxelWithItsHalo) {
    const std::vector<Eigen::Vector3d> voxel{{0, 0, 2}};
    const QPolygonF outline = projectedOutline(voxel, 0.2, Transform::Identity(), camera(), 10.0);
    // The near face of the cube is 1.9 m away and 0.1 m to each side: 500·0.1/1.9 = 26.3 px.
    EXPECT_NEAR(outline.boundingRect().left(), 320 - 26.3 - 10, 0.1);
    EXPECT_NEAR(outline.boundingRect().right(), 320 + 26.3 + 10, 0.1);
    EXPECT_NEAR(outline.boundingRect().height(), 2 * (510 * 0.1 / 1.9 + 10), 0.1);
}

TEST(ProjectedOutline, IsClippedToThePhotoAndEmptyBesideIt) {
    const QRectF photo(0, 0, 640, 480);
    const std::vector<Eigen::Vector3d> atTheEdge{{1.28, 0, 2}};
    const QPolygonF outline = projectedOutline(atTheEdge, 0.2, Transform::Identity(), camera());
    ASSERT_FALSE(outline.isEmpty());
    EXPECT_TRUE(photo.contains(outline.boundingRect()));
    EXPECT_TRUE(
        projectedOutline(std::vector<Eigen::Vector3d>{{5, 0, 2}}, 0.2, Transform::Identity(), camera()).isEmpty());
    EXPECT_TRUE(
        projectedOutline(std::vector<Eigen::Vector3d>{{0, 0, -2}}, 0.2, Transform::Identity(), camera()).isEmpty());
    EXPECT_TRUE(projectedOutline({}, 0.2, Transform::Identity(), camera()).isEmpty());
}

TEST(CandidateOutlines, LieWhereThePhotoShowsTheCandidate) {
    const InspectionState state = tankInspection({.candidates = 3});
    ASSERT_FALSE(state.photos.empty());
    for (const Photo& photo : state.photos) {
        const auto outlines = candidateOutlines(*state.detection, photo);
        ASSERT_EQ(outlines.size(), photo.candidateIds.size()) << photo.id;
        for (const CandidateOutline& outline : outlines) {
            const auto number = static_cast<std::size_t>(std::stoi(outline.candidateId.substr(2)) - 1);
            const std::vector<Eigen::Vector3d> centre{state.detection->candidates->candidates[number].centroid_map};
            const auto pixel = projectPoints(centre, photo.T_map_from_camera, photo.intrinsics);
            ASSERT_EQ(pixel.size(), 1U);
            EXPECT_TRUE(outline.polygon_px.containsPoint({pixel[0].x(), pixel[0].y()}, Qt::OddEvenFill));
        }
    }
}

}  // namespace
}  // namespace fodscope
