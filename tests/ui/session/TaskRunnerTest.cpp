// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <atomic>
#include <new>

#include "core/common/Error.h"
#include "ui/session/TaskRunner.h"

namespace fodscope {
namespace {

TEST(TaskRunner, WorksOnAnotherThreadAndAdoptsOnThisOne) {
    TaskRunner tasks;
    QThread* worker = nullptr;
    QThread* adopter = nullptr;
    tasks.run("work", [&](Progress&) -> TaskRunner::Adopt {
        worker = QThread::currentThread();
        return [&] { adopter = QThread::currentThread(); };
    });
    ASSERT_TRUE(QTest::qWaitFor([&] { return !tasks.isBusy(); }));
    EXPECT_NE(worker, QThread::currentThread());
    EXPECT_EQ(adopter, QThread::currentThread());
}

TEST(TaskRunner, RunsOneAfterTheOther) {
    TaskRunner tasks;
    std::string order;
    for (const char letter : {'a', 'b', 'c'})
        tasks.run(QString(QLatin1Char(letter)),
                  [&order, letter](Progress&) -> TaskRunner::Adopt { return [&order, letter] { order += letter; }; });
    ASSERT_TRUE(QTest::qWaitFor([&] { return !tasks.isBusy(); }));
    EXPECT_EQ(order, "abc");
}

TEST(TaskRunner, ErrorIsOneSentence) {
    TaskRunner tasks;
    QSignalSpy failed(&tasks, &TaskRunner::failed);
    tasks.run("load", [](Progress&) -> TaskRunner::Adopt { throw Error("a.pcd", "it is empty", "choose another"); });
    ASSERT_TRUE(QTest::qWaitFor([&] { return failed.count() == 1; }));
    EXPECT_EQ(failed.front().at(1).toString(), "a.pcd: it is empty; choose another");
}

TEST(TaskRunner, ErrorWhileAdoptingIsToldToo) {
    TaskRunner tasks;
    QSignalSpy failed(&tasks, &TaskRunner::failed);
    tasks.run("keep", [](Progress&) -> TaskRunner::Adopt {
        return [] { throw Error("disk", "it is full", "free some space"); };
    });
    ASSERT_TRUE(QTest::qWaitFor([&] { return failed.count() == 1; }));
    EXPECT_FALSE(tasks.isBusy());
}

TEST(TaskRunner, OutOfMemoryIsTold) {
    TaskRunner tasks;
    QSignalSpy failed(&tasks, &TaskRunner::failed);
    tasks.run("load", [](Progress&) -> TaskRunner::Adopt { throw std::bad_alloc(); });
    ASSERT_TRUE(QTest::qWaitFor([&] { return failed.count() == 1; }));
    EXPECT_TRUE(failed.front().at(1).toString().contains("emory"));
}

TEST(TaskRunner, CancelledTaskIsOverAtOnceAndItsResultThrownAway) {
    TaskRunner tasks;
    QSignalSpy cancelled(&tasks, &TaskRunner::cancelled);
    std::atomic<bool> begun{false};
    std::atomic<bool> ended{false};
    bool adopted = false;
    tasks.run("long", [&](Progress& progress) -> TaskRunner::Adopt {
        begun = true;
        while (!progress.isCancelled())
            QThread::yieldCurrentThread();
        ended = true;
        return [&] { adopted = true; };
    });
    ASSERT_TRUE(QTest::qWaitFor([&] { return begun.load(); }));
    tasks.cancel();
    EXPECT_FALSE(tasks.isBusy());
    EXPECT_EQ(cancelled.count(), 1);
    ASSERT_TRUE(QTest::qWaitFor([&] { return ended.load(); }));
    // What comes after waits for the thread, and is not disturbed by the late result.
    bool second = false;
    tasks.run("next", [&](Progress&) -> TaskRunner::Adopt { return [&] { second = true; }; });
    ASSERT_TRUE(QTest::qWaitFor([&] { return second; }));
    EXPECT_FALSE(adopted);
}

TEST(TaskRunner, TellsStageAndFraction) {
    TaskRunner tasks;
    QSignalSpy progressed(&tasks, &TaskRunner::progressed);
    tasks.run("load", [](Progress& progress) -> TaskRunner::Adopt {
        progress.report("reading", 0.25);
        return [] {};
    });
    ASSERT_TRUE(QTest::qWaitFor([&] { return !tasks.isBusy(); }));
    ASSERT_GE(progressed.count(), 1);
    const auto report = progressed.front().front().value<TaskReport>();
    EXPECT_EQ(report.stage, "reading");
    EXPECT_DOUBLE_EQ(report.fraction, 0.25);
}

}  // namespace
}  // namespace fodscope
