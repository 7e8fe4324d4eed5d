// SPDX-License-Identifier: MIT
#include "ui/report/ReportApplication.h"

#include <QGuiApplication>

#include "core/common/Error.h"

namespace fodscope {

namespace {

// QGuiApplication keeps references to these for as long as it lives.
char programName[] = "fodscope-report";
char platformOption[] = "-platform";
char platform[] = "offscreen";
char* arguments[] = {programName, platformOption, platform, nullptr};
int argumentCount = 3;

}  // namespace

ReportApplication::ReportApplication() {
    if (!QCoreApplication::instance()) {
        application_ = std::make_unique<QGuiApplication>(argumentCount, arguments);
    } else if (!qobject_cast<QGuiApplication*>(QCoreApplication::instance())) {
        throw Error("report", "the program runs without the graphics that PDF and HTML need",
                    "write the report as CSV or JSON");
    }
}

ReportApplication::~ReportApplication() = default;

}  // namespace fodscope
