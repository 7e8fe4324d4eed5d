// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <functional>

#include "core/common/Error.h"
#include "core/inspection/Inspection.h"
#include "storage/SessionFile.h"
#include "tests/fakes/SampleInspection.h"

namespace fodscope {
namespace {

/// No file of this process may grow past that size: writing then fails as on a full disk.
void limitFiles(rlim_t bytes) {
    rlimit limit{};
    if (::getrlimit(RLIMIT_FSIZE, &limit) != 0) throw std::runtime_error("no limit");
    limit.rlim_cur = std::min(bytes, limit.rlim_max);
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) throw std::runtime_error("the limit could not be set");
}

#define REQUIRE_IN_CHILD(condition)                                          \
    if (!(condition)) {                                                      \
        std::fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
        ::_exit(1);                                                          \
    }

/// The limit holds for a whole process, so each check has one of its own.
bool holdsInChild(const std::function<void()>& check) {
    const pid_t child = ::fork();
    if (child == 0) {
        ::signal(SIGXFSZ, SIG_IGN);
        try {
            check();
        } catch (const std::exception& exception) {
            std::fprintf(stderr, "%s\n", exception.what());
            ::_exit(1);
        }
        ::_exit(0);
    }
    int status = 0;
    return ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

bool failsWithError(const std::function<void()>& act) {
    try {
        act();
    } catch (const Error& error) {
        return std::string(error.what()).find("disk") != std::string::npos;
    }
    return false;
}

TEST(FullDisk, AnActThatDoesNotFitLeavesTheInspectionAsItWasAndWorkGoesOn) {
    const test::TemporaryFolder folder;
    const auto file = folder.file("a.fodscope");
    EXPECT_TRUE(holdsInChild([&] {
        const auto session = SessionFile::create(file, test::sampleHeader());
        Inspection inspection(session->load(), *session);
        inspection.setLabelSet(test::sampleLabels());
        inspection.addPhoto(test::samplePhoto("W-01", "C-001", "photo"));
        const std::string head = session->headHash();

        limitFiles(std::filesystem::file_size(file.string() + "-wal"));
        for (int attempt = 0; attempt < 3; ++attempt) {
            REQUIRE_IN_CHILD(failsWithError([&] {
                inspection.decide("P-001", "Anna", {{"hammer", std::nullopt}}, "", {1});
            }));
            REQUIRE_IN_CHILD(failsWithError(
                [&] { inspection.addPhoto(test::samplePhoto("W-01", "C-001", std::string(1'000'000, 'x'))); }));
            REQUIRE_IN_CHILD(inspection.state().decisions.empty() && inspection.state().photos.size() == 1);
            REQUIRE_IN_CHILD(session->headHash() == head);
        }

        limitFiles(RLIM_INFINITY);
        inspection.decide("P-001", "Anna", {{"drill", std::nullopt}}, "", {2});
        const SessionVerification verification = session->verify();
        REQUIRE_IN_CHILD(verification.intact);
    }));
    const auto session = SessionFile::open(file);
    const InspectionState state = session->load();
    ASSERT_EQ(state.decisions.size(), 1u);
    EXPECT_EQ(state.decisions[0].labels[0].label, "drill");
    EXPECT_TRUE(session->verify().intact);
}

TEST(FullDisk, ANewSessionThatDoesNotFitLeavesNoFileBehind) {
    const test::TemporaryFolder folder;
    const auto file = folder.file("a.fodscope");
    EXPECT_TRUE(holdsInChild([&] {
        limitFiles(8192);
        REQUIRE_IN_CHILD(failsWithError([&] { SessionFile::create(file, test::sampleHeader()); }));
        REQUIRE_IN_CHILD(std::filesystem::is_empty(folder.path()));
    }));
}

}  // namespace
}  // namespace fodscope
