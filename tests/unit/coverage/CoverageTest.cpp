// SPDX-License-Identifier: MIT
#include "core/coverage/Coverage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/common/Error.h"

namespace fodscope {
namespace {

ReferenceMap row() {
    ReferenceMap reference;
    reference.points = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {2.0, 0.0, 0.7}};
    return reference;
}

DiscrepancyField fieldAt(std::vector<Eigen::Vector3d> points) {
    DiscrepancyField field;
    field.points = std::move(points);
    return field;
}

TEST(Coverage, CountsReferencePointsWithAVoxelWithinTheDistance) {
    Progress progress;
    const DiscrepancyField field = fieldAt({{0.0, 0.1, 0.0}, {1.0, 0.101, 0.0}, {2.0, 0.0, 0.65}});
    const Coverage coverage = measureCoverage(row(), field, {}, {0.1}, progress);
    EXPECT_EQ(coverage.observed, (std::vector<std::uint8_t>{1, 0, 0, 1}));
    EXPECT_DOUBLE_EQ(coverage.observedShare, 0.5);
    EXPECT_EQ(coverage.leftOut, 0u);
}

TEST(Coverage, DoesNotJudgeWhatTheCropHeightLeavesOut) {
    Progress progress;
    DiscrepancySettings crop;
    crop.cropHeight_m = 0.6;
    const Coverage coverage = measureCoverage(row(), fieldAt({{0.0, 0.0, 0.0}, {2.0, 0.0, 0.65}}), crop, {}, progress);
    EXPECT_EQ(coverage.observed, (std::vector<std::uint8_t>{1, 0, 0, 0}));
    EXPECT_DOUBLE_EQ(coverage.observedShare, 1.0 / 3.0);
    EXPECT_EQ(coverage.leftOut, 1u);
}

TEST(Coverage, OfAnEmptyMapIsNothing) {
    Progress progress;
    const Coverage coverage = measureCoverage(row(), {}, {}, {}, progress);
    EXPECT_EQ(coverage.observed, std::vector<std::uint8_t>(4, 0));
    EXPECT_EQ(coverage.observedShare, 0.0);
}

TEST(Coverage, RefusesADistanceThatIsNotPositive) {
    Progress progress;
    const DiscrepancyField field = fieldAt({{0.0, 0.0, 0.0}});
    EXPECT_THROW(measureCoverage(row(), field, {}, {0.0}, progress), Error);
    EXPECT_THROW(measureCoverage(row(), field, {}, {std::nan("")}, progress), Error);
}

}  // namespace
}  // namespace fodscope
