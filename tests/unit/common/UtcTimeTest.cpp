// SPDX-License-Identifier: MIT
#include "core/common/UtcTime.h"

#include <gtest/gtest.h>

TEST(UtcTime, IsWrittenAsIso8601WithMilliseconds) {
    EXPECT_EQ(fodscope::toIso8601({0}), "1970-01-01T00:00:00.000Z");
    EXPECT_EQ(fodscope::toIso8601({1'000'000'000'123}), "2001-09-09T01:46:40.123Z");
    EXPECT_EQ(fodscope::toIso8601({-1}), "1969-12-31T23:59:59.999Z");
}
