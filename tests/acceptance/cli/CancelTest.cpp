// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <sched.h>

#include "tests/acceptance/cli/Program.h"

namespace fodscope::test {
namespace {

TEST(Cancel, AnInterruptEndsTheWorkAndLeavesNothingBehind) {
    TestFolder folder;
    const std::filesystem::path out = folder / "out";
    Program program({"simulate", "--world", "builtin", "--kind", "nominal", "--count", "1000", "--out", out.string()});
    // The folder is there as soon as the work begins.
    while (program.isRunning() && !std::filesystem::exists(out))
        sched_yield();
    program.interrupt();
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.exitCode, 3) << outcome.err;
    EXPECT_EQ(outcome.err, "cancelled\n");
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Cancel, AnInterruptRightAfterTheStartIsHeardToo) {
    TestFolder folder;
    const std::filesystem::path out = folder / "out";
    Program program({"simulate", "--world", "builtin", "--kind", "nominal", "--count", "1000", "--out", out.string()});
    while (program.isRunning() && !program.hearsInterrupts())
        sched_yield();
    program.interrupt();
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.exitCode, 3) << outcome.err;
    EXPECT_EQ(outcome.err, "cancelled\n");
    EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace fodscope::test
