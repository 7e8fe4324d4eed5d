// SPDX-License-Identifier: MIT
#include "core/simulation/MeshShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/simulation/EarClipping.h"

namespace fodscope {
namespace {

/// By the divergence theorem; positive when the faces of a closed mesh look outwards.
double volumeOf(const TriangleMesh& mesh) {
    double volume = 0.0;
    for (const auto& t : mesh.triangles)
        volume += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6.0;
    return volume;
}

double areaOf(const TriangleMesh& mesh) {
    double area = 0.0;
    for (const auto& t : mesh.triangles)
        area +=
            0.5 * (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).norm();
    return area;
}

TEST(MeshShapes, ABoxHasTheVolumeOfABox) {
    EXPECT_NEAR(volumeOf(boxMesh({1, 2, 3}, {2, 4, 6}, {})), 6.0, 1e-12);
}

TEST(MeshShapes, ACylinderFacesOutwardsWhicheverWayItLies) {
    for (const Eigen::Vector3d& end : {Eigen::Vector3d(2, 0, 0), Eigen::Vector3d(0, 0, 2), Eigen::Vector3d(0, -2, 0)})
        EXPECT_NEAR(volumeOf(cylinderMesh({0, 0, 0}, end, 0.5, {}, 256)), 0.5 * std::numbers::pi, 1e-3);
}

TEST(MeshShapes, ACapsuleIsACylinderAndABall) {
    const double expected = std::numbers::pi * 0.25 * 1.0 + 4.0 / 3.0 * std::numbers::pi * 0.125;
    EXPECT_NEAR(volumeOf(capsuleMesh({0, 0, 0}, {1, 0, 0}, 0.5, {}, 200)), expected, 2e-3);
}

TEST(MeshShapes, AnExtrudedConcaveOutlineKeepsItsNotch) {
    const Outline letterL{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
    EXPECT_NEAR(volumeOf(extrudedMesh(letterL, 0.0, 0.5, {})), 0.5 * 4.0, 1e-12);
    EXPECT_LT(volumeOf(extrudedMesh(letterL, 0.0, 0.5, {}, 0.05)), 0.5 * 4.0);
}

TEST(MeshShapes, AHoleCutInByABridgeStaysOpen) {
    const Outline withHole{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}};
    EXPECT_NEAR(areaOf(flatMesh(withHole, {})), 16.0 - 4.0, 1e-9);
}

TEST(MeshShapes, EarClippingOfTooFewPointsIsEmpty) {
    EXPECT_TRUE(earClipping({}).empty());
    EXPECT_TRUE(earClipping({{0, 0}, {1, 0}}).empty());
}

TEST(MeshShapes, TheSurfaceCentroidWeighsByArea) {
    // Two squares of area 1 and 4.
    TriangleMesh mesh = quadMesh({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {});
    append(mesh, quadMesh({2, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 2, 0}, {}));
    EXPECT_TRUE(surfaceCentroid(mesh).isApprox(Eigen::Vector3d(0.2 * 0.5 + 0.8 * 3.0, 0.2 * 0.5 + 0.8 * 1.0, 0.0)));
}

}  // namespace
}  // namespace fodscope
