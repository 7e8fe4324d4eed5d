// SPDX-License-Identifier: MIT
#include "core/reference/CadReference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/cloud/ExpectError.h"

namespace fodscope {
namespace {

/// A 2 × 1 rectangle in two triangles at z = 0 and a triangle of area 1 at z = 1.
TriangleMesh example() {
    TriangleMesh mesh;
    mesh.vertices = {{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {2.0, 1.0, 0.0}, {0.0, 1.0, 0.0},
                     {0.0, 0.0, 1.0}, {2.0, 0.0, 1.0}, {0.0, 1.0, 1.0}};
    mesh.triangles = {{0, 1, 2}, {4, 4, 5}, {0, 2, 3}, {4, 5, 6}};
    return mesh;
}

TEST(CadReference, HasOneSamplePerSquareOfTheSpacing) {
    Progress progress;
    const ReferenceMap reference = referenceFromCad(example(), {0.01, 1}, progress);
    EXPECT_EQ(reference.size(), 30000u);
    EXPECT_FALSE(reference.hasCovariance());
    EXPECT_FALSE(reference.provenance.empty());
}

TEST(CadReference, LiesOnTheSurfaceUniformlyByArea) {
    Progress progress;
    const ReferenceMap reference = referenceFromCad(example(), {0.01, 7}, progress);
    std::size_t onTriangle = 0;
    std::vector<int> squares(8);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : reference.points) {
        if (point.z() > 0.5) {
            EXPECT_NEAR(point.z(), 1.0, 1e-12);
            EXPECT_LE(point.x() / 2.0 + point.y(), 1.0 + 1e-12);
            ++onTriangle;
            sum += point;
            continue;
        }
        EXPECT_NEAR(point.z(), 0.0, 1e-12);
        const int column = std::clamp(static_cast<int>(point.x() * 2.0), 0, 3);
        const int row = std::clamp(static_cast<int>(point.y() * 2.0), 0, 1);
        ++squares[static_cast<std::size_t>(column + 4 * row)];
    }
    EXPECT_NEAR(static_cast<double>(onTriangle), 10000.0, 1.0);
    // Uniform: 2500 a square with a standard deviation of less than 50; the triangle's centroid is its mean.
    for (const int count : squares)
        EXPECT_NEAR(count, 2500, 200);
    EXPECT_NEAR((sum / static_cast<double>(onTriangle) - Eigen::Vector3d(2.0 / 3.0, 1.0 / 3.0, 1.0)).norm(), 0.0, 0.02);
}

TEST(CadReference, IsTheSameForTheSameSeed) {
    Progress progress;
    EXPECT_EQ(referenceFromCad(example(), {0.05, 3}, progress).points,
              referenceFromCad(example(), {0.05, 3}, progress).points);
    EXPECT_NE(referenceFromCad(example(), {0.05, 3}, progress).points,
              referenceFromCad(example(), {0.05, 4}, progress).points);
    EXPECT_EQ(referenceFromCad(example(), {100.0, 3}, progress).size(), 1u);
}

TEST(CadReference, RefusesBadSpacingsAndMeshesWithoutArea) {
    Progress progress;
    const auto sample = [&](const TriangleMesh& mesh, double spacing) {
        return referenceFromCad(mesh, {spacing, 1}, progress);
    };
    expectError([&] { sample(example(), 0.0); }, "spacing");
    expectError([&] { sample(example(), -0.01); }, "spacing");
    expectError([&] { sample(example(), std::nan("")); }, "spacing");
    expectError([&] { sample(example(), 1e-6); }, "200 million");
    expectError([&] { sample({}, 0.01); }, "no area");
    TriangleMesh flat = example();
    flat.triangles = {{4, 4, 5}};
    expectError([&] { sample(flat, 0.01); }, "no area");
    TriangleMesh torn = example();
    torn.triangles.push_back({0, 1, static_cast<std::uint32_t>(torn.vertices.size())});
    expectError([&] { sample(torn, 0.01); }, "a vertex that is not there");
    for (const double bad : {std::nan(""), HUGE_VAL}) {
        TriangleMesh broken = example();
        broken.vertices[broken.triangles.front()[1]].y() = bad;
        expectError([&] { sample(broken, 0.01); }, "a coordinate is not finite");
    }
    progress.cancel();
    EXPECT_THROW(sample(example(), 0.01), Cancelled);
}

}  // namespace
}  // namespace fodscope
