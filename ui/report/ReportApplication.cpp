// SPDX-License-Identifier: MIT
#include "ui/report/ReportApplication.h"

#include <QGuiApplication>
#include <QtGlobal>
#include "core/common/Error.h"

namespace fodscope {

ReportApplication::ReportApplication() {
    if (!QCoreApplication::instance()) {
        for (std::size_t index = 0; index < words_.size(); ++index)
            arguments_[index] = words_[index].data();
        // Qt remarks on missing session directories; nobody asked, and standard error is the program's.
        const QtMessageHandler previous =
            qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
        application_ = std::make_unique<QGuiApplication>(argumentCount_, arguments_.data());
        qInstallMessageHandler(previous);
    } else if (!qobject_cast<QGuiApplication*>(QCoreApplication::instance())) {
        throw Error("report", "the program runs without the graphics that PDF and HTML need",
                    "write the report as CSV or JSON");
    }
}

ReportApplication::~ReportApplication() = default;

}  // namespace fodscope
