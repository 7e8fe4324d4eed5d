// SPDX-License-Identifier: MIT
#include "ui/panels/Format.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fodscope::test {
namespace {

TEST(Format, PosesAndDeviationsCarryTheirUnits) {
    EXPECT_EQ(originText({1.234, -0.5, radiansFromDegrees(87.0)}), QStringLiteral("x 1.23 m, y -0.50 m, yaw 87°"));
    EXPECT_EQ(deviationText({0.0031, 0.0024, 0.0}, 1000.0, "mm", 1), QStringLiteral("± 3.1, 2.4, 0.0 mm"));
}

TEST(Format, SpreadOfACovarianceIsAStandardDeviation) {
    EXPECT_EQ(spreadText(std::log(1e-12)), QStringLiteral("10.0 mm"));
}

}  // namespace
}  // namespace fodscope::test
