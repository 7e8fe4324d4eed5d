// SPDX-License-Identifier: MIT
#include "core/reference/LogDeterminant.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fodscope {
namespace {

TEST(LogDeterminant, IsKnownWhereThePointIsTrained) {
    ReferenceMap reference;
    EXPECT_TRUE(logDeterminants(reference).empty());
    reference.points.assign(3, Eigen::Vector3d::Zero());
    reference.covariance.assign(3, Eigen::Vector3d(1e-4, 2e-4, 5e-4).asDiagonal());
    reference.covariance[2].setConstant(std::nan(""));
    reference.untrained = {0, 1, 1};
    const std::vector<double> values = logDeterminants(reference);
    EXPECT_NEAR(values[0], std::log(1e-11), 1e-12);
    EXPECT_TRUE(std::isnan(values[1]));
    EXPECT_TRUE(std::isnan(values[2]));
}

TEST(LogDeterminant, TheHeatMapIsClampedToThe10thAnd90thPercentile) {
    // numpy.percentile([3, 1, 4, 1, 5, 9, 2, 6, 5, 3, 5], [10, 90]) = [1, 6]; without the last: [1, 6.3].
    const double nan = std::nan("");
    const std::vector<double> eleven{3, 1, 4, nan, 1, 5, 9, 2, 6, 5, 3, 5};
    ASSERT_TRUE(heatMapRange(eleven));
    EXPECT_DOUBLE_EQ(heatMapRange(eleven)->low, 1.0);
    EXPECT_DOUBLE_EQ(heatMapRange(eleven)->high, 6.0);
    const std::vector<double> ten{3, 1, 4, 1, 5, 9, 2, 6, 5, 3, nan};
    EXPECT_DOUBLE_EQ(heatMapRange(ten)->low, 1.0);
    EXPECT_DOUBLE_EQ(heatMapRange(ten)->high, 6.3);
    EXPECT_EQ(heatMapRange(std::vector<double>{2.5}), (HeatMapRange{2.5, 2.5}));
}

TEST(LogDeterminant, NothingKnownHasNoRange) {
    EXPECT_FALSE(heatMapRange({}));
    EXPECT_FALSE(heatMapRange(std::vector<double>{std::nan(""), std::nan("")}));
}

}  // namespace
}  // namespace fodscope
