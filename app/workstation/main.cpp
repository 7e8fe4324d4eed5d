// SPDX-License-Identifier: MIT
#include <QApplication>
#include <QDateTime>
#include <QDir>
#include <QSettings>
#include <QStandardPaths>
#include <chrono>
#include <cstdio>
#include <memory>

#include "app/workstation/Autopilot.h"
#include "app/workstation/FolderAnswers.h"
#include "app/workstation/Options.h"
#include "ui/window/MainWindow.h"

namespace {

using namespace fodscope;

constexpr int kInputAtFault = 1;
constexpr double kDriveFactor = 8.0;

ThemeKind themeOf(const Options& options) {
    if (options.theme) return *options.theme;
    const bool light = QSettings().value("window/theme").toString() == QStringLiteral("light");
    // Pictures for the manual look the same wherever they are taken.
    return light && !options.autopilot ? ThemeKind::Light : ThemeKind::Dark;
}

QString demoSession() {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/demo");
    QDir().mkpath(folder);
    const QString time = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd-HHmmss-zzz"));
    return QStringLiteral("%1/demo-%2.fodscope").arg(folder, time);
}

/// The simulated robot need not keep anybody waiting while it drives; its photos take the time they take.
VisitDriver::Clock fasterClock(const VisitDriver& visits) {
    auto last = std::chrono::steady_clock::now();
    double now_s = 0.0;
    return [&visits, last, now_s]() mutable {
        const auto now = std::chrono::steady_clock::now();
        const bool moving = visits.robotState() && visits.robotState()->moving;
        now_s += (moving ? kDriveFactor : 1.0) * std::chrono::duration<double>(now - last).count();
        last = now;
        return now_s;
    };
}

int fail(const QString& sentence) {
    std::fprintf(stderr, "error: %s\n", qUtf8Printable(sentence));
    return kInputAtFault;
}

}  // namespace

int main(int argc, char** argv) {
    const fodscope::ParsedOptions parsed = fodscope::parseOptions(argc, argv);
    if (parsed.exitCode) return *parsed.exitCode;
    const Options& options = parsed.options;
    if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") &&
        qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        return fail(QStringLiteral("display: there is no screen to open a window on; start it under xvfb-run"));

    fodscope::prepareApplication();
    QApplication application(argc, argv);
    fodscope::applyTheme(application, themeOf(options));
    std::unique_ptr<FileDialogs> files;
    if (options.autopilot)
        files = std::make_unique<FolderAnswers>(QDir(QString::fromStdString(options.screenshots)).absolutePath());
    else
        files = std::make_unique<DesktopFileDialogs>();
    InspectionController controller;
    MainWindow window(controller, *files);
    if (options.autopilot && !options.size) window.resize(1920, 1080);
    if (options.size) window.resize(*options.size);
    window.show();

    QString problem;
    if (options.autopilot) {
        auto* autopilot =
            new Autopilot(window, controller, QDir(QString::fromStdString(options.screenshots)).absolutePath());
        QObject::connect(autopilot, &Autopilot::pictureSaved, &application, [](const QString& file) {
            std::printf("saved %s\n", qPrintable(file));
            std::fflush(stdout);
        });
        QObject::connect(autopilot, &Autopilot::finished, &application, &QApplication::quit);
        QObject::connect(autopilot, &Autopilot::failed, &application, [&](const QString& sentence) {
            problem = sentence;
            application.quit();
        });
        controller.visits().setClock(fasterClock(controller.visits()));
        QMetaObject::invokeMethod(autopilot, &Autopilot::start, Qt::QueuedConnection);
    } else if (options.demo) {
        QMetaObject::invokeMethod(
            &controller, [&controller] { controller.createBuiltinTank(demoSession()); }, Qt::QueuedConnection);
    } else if (!options.session.empty()) {
        const QString session = QString::fromStdString(options.session);
        QMetaObject::invokeMethod(
            &controller, [&controller, session] { controller.openSession(session); }, Qt::QueuedConnection);
    }
    QApplication::exec();
    return problem.isEmpty() ? 0 : fail(problem);
}
