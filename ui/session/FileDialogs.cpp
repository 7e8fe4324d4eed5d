// SPDX-License-Identifier: MIT
#include "ui/session/FileDialogs.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

namespace fodscope {
namespace {

constexpr const char* kLastFolder = "files/lastFolder";

QString lastFolder() {
    return QSettings().value(kLastFolder, QDir::homePath()).toString();
}

void remember(const QString& file) {
    if (!file.isEmpty()) QSettings().setValue(kLastFolder, QFileInfo(file).absolutePath());
}

}  // namespace

QString DesktopFileDialogs::openFile(QWidget* parent, const QString& title, const QString& filter) {
    const QString file = QFileDialog::getOpenFileName(parent, title, lastFolder(), filter);
    remember(file);
    return file;
}

QStringList DesktopFileDialogs::openFiles(QWidget* parent, const QString& title, const QString& filter) {
    const QStringList files = QFileDialog::getOpenFileNames(parent, title, lastFolder(), filter);
    if (!files.isEmpty()) remember(files.first());
    return files;
}

QString DesktopFileDialogs::saveFile(QWidget* parent, const QString& title, const QString& proposal,
                                     const QString& filter) {
    const QString start = QFileInfo(proposal).isAbsolute() ? proposal : QDir(lastFolder()).filePath(proposal);
    const QString file = QFileDialog::getSaveFileName(parent, title, start, filter);
    remember(file);
    return file;
}

QString DesktopFileDialogs::chooseFolder(QWidget* parent, const QString& title, const QString& proposal) {
    return QFileDialog::getExistingDirectory(parent, title, proposal.isEmpty() ? lastFolder() : proposal);
}

}  // namespace fodscope
