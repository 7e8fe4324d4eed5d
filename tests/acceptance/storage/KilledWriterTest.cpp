// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <random>
#include <string>

#include "core/inspection/Inspection.h"
#include "storage/SessionFile.h"
#include "tests/fakes/SampleInspection.h"

namespace fodscope {
namespace {

/// Decides without end, each decision with its number as comment, and acknowledges each by one byte.
[[noreturn]] void decideUntilKilled(const std::filesystem::path& file, int acknowledgements) {
    try {
        const auto session = SessionFile::open(file);
        Inspection inspection(session->load(), *session);
        for (std::size_t number = inspection.state().decisions.size();; ++number) {
            const std::string label = number % 2 == 0 ? "hammer" : "drill";
            inspection.decide("P-001", "Anna", {{label, PixelBox{1, 2, 3, 4}}}, std::to_string(number), {1});
            if (::write(acknowledgements, "x", 1) != 1) ::_exit(3);
        }
    } catch (const std::exception&) {
        ::_exit(2);
    }
}

/// @return how many decisions were acknowledged before the writer died
std::size_t killAfter(const std::filesystem::path& file, std::size_t count) {
    int ends[2];
    if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
    const pid_t child = ::fork();
    if (child == 0) {
        ::close(ends[0]);
        decideUntilKilled(file, ends[1]);
    }
    ::close(ends[1]);
    std::size_t acknowledged = 0;
    char byte = 0;
    while (acknowledged < count && ::read(ends[0], &byte, 1) == 1) {
        ++acknowledged;
    }
    ::kill(child, SIGKILL);
    // What was acknowledged between the last byte read and the kill counts as well.
    while (::read(ends[0], &byte, 1) == 1) {
        ++acknowledged;
    }
    ::close(ends[0]);
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status)) << "the writer ended by itself with " << WEXITSTATUS(status);
    return acknowledged;
}

TEST(KilledWriter, NothingAcknowledgedIsLost) {
    const test::TemporaryFolder folder;
    const auto file = folder.file("a.fodscope");
    {
        const auto session = SessionFile::create(file, test::sampleHeader());
        Inspection inspection(session->load(), *session);
        inspection.setLabelSet(test::sampleLabels());
        inspection.addPhoto(test::samplePhoto("W-01", "C-001", "photo"));
    }
    std::mt19937 random(7);
    std::uniform_int_distribution<std::size_t> count(1, 40);
    std::size_t kept = 0;
    for (int round = 0; round < 12; ++round) {
        const std::size_t acknowledged = killAfter(file, count(random));
        const auto session = SessionFile::open(file);
        const InspectionState state = session->load();
        // One more may be on disk: the writer was killed before it could acknowledge it.
        EXPECT_GE(state.decisions.size(), kept + acknowledged);
        EXPECT_LE(state.decisions.size(), kept + acknowledged + 1);
        for (std::size_t number = 0; number < state.decisions.size(); ++number) {
            ASSERT_EQ(state.decisions[number].comment, std::to_string(number));
            ASSERT_EQ(state.decisions[number].labels.size(), 1u);
        }
        const SessionVerification verification = session->verify();
        EXPECT_TRUE(verification.intact) << verification.problem;
        kept = state.decisions.size();
    }
    EXPECT_GT(kept, 12u);
}

}  // namespace
}  // namespace fodscope
