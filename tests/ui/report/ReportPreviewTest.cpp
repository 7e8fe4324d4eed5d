// SPDX-License-Identifier: MIT
#include "ui/report/ReportPreview.h"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QTest>

#include "core/inspection/ReportModel.h"
#include "tests/fakes/TankInspection.h"
#include "tests/ui/Screenshot.h"
#include "ui/report/PageStack.h"
#include "ui/report/ReportWriter.h"

namespace fodscope {
namespace {

TEST(ReportPreviewWidget, ShowsPagesAndKeepsItsPlace) {
    ReportPreview preview;
    preview.resize(900, 760);
    preview.show();
    EXPECT_EQ(preview.pageCount(), 0);
    saveScreenshot(preview, QStringLiteral("report-empty"));
    InspectionState state = tankInspection();
    preview.setReport(state, "");
    EXPECT_GT(preview.pageCount(), 3);
    saveScreenshot(preview, QStringLiteral("report-preview"));
    auto* pages = preview.findChild<report::PageStack*>();
    preview.goToPage(2);
    EXPECT_EQ(pages->currentPage(), 2);
    saveScreenshot(preview, QStringLiteral("report-preview-3"));
    state.header.ship.clear();
    preview.setReport(state, "");
    EXPECT_EQ(pages->currentPage(), 2);
    QTest::keyClick(pages, Qt::Key_PageDown);
    EXPECT_EQ(pages->currentPage(), 3);
    preview.goToPage(10000);
    EXPECT_EQ(pages->currentPage(), preview.pageCount() - 1);
    preview.clear();
    EXPECT_EQ(preview.pageCount(), 0);
}

TEST(ReportSamples, AreWrittenForLookingAt) {
    const std::string folder = qEnvironmentVariable("FODSCOPE_SCREENSHOTS").toStdString();
    if (folder.empty()) GTEST_SKIP() << "FODSCOPE_SCREENSHOTS names no folder";
    writeReport(tankInspection(), "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08",
                folder + "/sample.pdf");
    writeReport(tankInspection({.decided = false}), "", folder + "/sample-draft.pdf");
    writeReport(tankInspection(), "9f86", folder + "/sample.html");
    writeReport(tankInspection({.visited = false}), "", folder + "/sample-early.pdf");
    const InspectionState many = tankInspection({.candidates = 130});
    for (const char* name : {"/sample-many.pdf", "/sample-many.html"}) {
        QElapsedTimer clock;
        clock.start();
        writeReport(many, "", folder + name);
        qInfo("%s: %zu findings, %lld ms", name, makeReportModel(many).findings.size(), clock.elapsed());
    }
}

}  // namespace
}  // namespace fodscope
