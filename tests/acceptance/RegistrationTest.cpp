// SPDX-License-Identifier: MIT
// The alignment of the real tank's map val_03 against that of an independent implementation (Open3D's point-to-point
// ICP with the same voxels, distance and start).
//
// Tolerance. Both stop when a step changes the fit by less than 1e-6; along a shallow valley that is up to some 2 mm
// before its bottom, so the corners of the tank may differ by as much.
#include <gtest/gtest.h>

#include <array>

#include "core/cloud/OutlierRemoval.h"
#include "core/cloud/PointCloudIo.h"
#include "core/cloud/VoxelGrid.h"
#include "core/registration/Registration.h"
#include "tests/acceptance/CsvTable.h"
#include "tests/acceptance/SharedData.h"

namespace fodscope {
namespace {

Transform goldenTransform(const std::filesystem::path& file) {
    const CsvTable table(file, false);
    std::array<double, 16> rows{};
    for (std::size_t i = 0; i < 16; ++i)
        rows[i] = table[std::to_string(i % 4)][i / 4];
    return transformFromRows(rows, file.string());
}

double cornerDisplacement_m(const std::vector<Eigen::Vector3d>& points, const Transform& a, const Transform& b) {
    const Eigen::AlignedBox3d box(minimumCorner(points), maximumCorner(points));
    double worst_m = 0.0;
    for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3d corner = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
        worst_m = std::max(worst_m, (a * (b.inverse() * corner) - corner).norm());
    }
    return worst_m;
}

TEST(RegistrationOfARealTank, AgreesWithAnIndependentImplementation) {
    const std::filesystem::path tank = sharedData() / "nuwc-tank";
    if (!std::filesystem::exists(tank / "golden/mean_cloud.pcd")) {
        GTEST_SKIP() << tank << " is not there; set FODSCOPE_SHARED_DATA to the folder with the real tanks' data";
    }
    Progress progress;
    const PointCloud reference = readPointCloud(tank / "golden/mean_cloud.pcd");
    const PointCloud map = readPointCloud(tank / "val_03.pcd");
    const PointCloud denoised = select(map, keptByOutlierRemoval(map.points, {}, progress));
    const RegistrationResult result = registerMap(denoised.points, reference.points, std::nullopt, {}, progress);
    EXPECT_EQ(result.quality, RegistrationQuality::Good);
    const Transform golden = goldenTransform(tank / "golden/query_val_03_T.csv");
    EXPECT_LT(cornerDisplacement_m(reference.points, result.T_reference_from_map, golden), 0.002);

    // The same map turned by a right angle and put elsewhere: found by its features.
    Transform moved = transformFromPose({3.0, -4.0, 1.57});
    std::vector<Eigen::Vector3d> turned;
    for (const Eigen::Vector3d& point : denoised.points)
        turned.push_back(moved * point);
    const RegistrationResult found = registerMap(turned, reference.points, std::nullopt, {}, progress);
    EXPECT_EQ(found.quality, RegistrationQuality::Good) << found.summary;
    EXPECT_LT(cornerDisplacement_m(reference.points, found.T_reference_from_map * moved, golden), 0.006);
}

}  // namespace
}  // namespace fodscope
