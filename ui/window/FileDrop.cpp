// SPDX-License-Identifier: MIT
#include "ui/window/FileDrop.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include "ui/session/InspectionController.h"

namespace fodscope {
namespace {

bool beginInspection(InspectionController& controller) {
    const QString folder =
        QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + QStringLiteral("/Fodscope");
    QDir().mkpath(folder);
    const QString name =
        QObject::tr("Inspection %1").arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd HHmmss")));
    InspectionHeader header = newInspectionHeader();
    header.title = name.toStdString();
    return controller.createSession(folder + QLatin1Char('/') + name + QStringLiteral(".fodscope"), header);
}

}  // namespace

void takeDroppedFiles(InspectionController& controller, const QStringList& files) {
    if (files.isEmpty()) return;
    const QString first = files.first();
    const QString kind = QFileInfo(first).suffix().toLower();
    if (kind == QStringLiteral("fodscope")) {
        controller.openSession(first);
        return;
    }
    if (!controller.isOpen() && !beginInspection(controller)) return;
    if (kind == QStringLiteral("csv")) {
        controller.loadGivenTransform(first);
    } else if (kind == QStringLiteral("yaml") || kind == QStringLiteral("yml")) {
        controller.loadGrid(first);
    } else if (kind == QStringLiteral("json")) {
        controller.connectWorldRobot(first);
    } else if (files.size() == 1 && controller.state().reference) {
        controller.loadMap(first);
    } else {
        std::vector<std::filesystem::path> paths;
        for (const QString& file : files)
            paths.emplace_back(file.toStdString());
        ReferenceRequest request = requestFor(paths);
        request.meshScale = controller.meshScale();
        controller.loadReference(request);
    }
}

}  // namespace fodscope
