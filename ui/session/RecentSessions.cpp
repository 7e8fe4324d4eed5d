// SPDX-License-Identifier: MIT
#include "ui/session/RecentSessions.h"

#include <QFileInfo>
#include <QSettings>
#include <algorithm>

namespace fodscope {
namespace {

constexpr const char* kFiles = "sessions/recent";
constexpr int kKept = 10;

QString stepKey(const std::string& inspectionId) {
    return QStringLiteral("sessions/step/") + QString::fromStdString(inspectionId);
}

}  // namespace

QStringList RecentSessions::files() const {
    QStringList files = QSettings().value(kFiles).toStringList();
    files.erase(
        std::remove_if(files.begin(), files.end(), [](const QString& file) { return !QFileInfo::exists(file); }),
        files.end());
    return files;
}

void RecentSessions::add(const QString& file) {
    const QString absolute = QFileInfo(file).absoluteFilePath();
    QStringList files = QSettings().value(kFiles).toStringList();
    files.removeAll(absolute);
    files.prepend(absolute);
    QSettings().setValue(kFiles, QStringList(files.mid(0, kKept)));
}

void RecentSessions::remove(const QString& file) {
    QStringList files = QSettings().value(kFiles).toStringList();
    files.removeAll(QFileInfo(file).absoluteFilePath());
    QSettings().setValue(kFiles, files);
}

std::optional<Step> RecentSessions::stepOf(const std::string& inspectionId) const {
    bool isNumber = false;
    const int step = QSettings().value(stepKey(inspectionId)).toInt(&isNumber);
    if (!isNumber || step < 0 || step >= kStepCount) return std::nullopt;
    return static_cast<Step>(step);
}

void RecentSessions::rememberStep(const std::string& inspectionId, Step step) {
    QSettings().setValue(stepKey(inspectionId), static_cast<int>(step));
}

}  // namespace fodscope
