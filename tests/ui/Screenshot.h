// SPDX-License-Identifier: MIT
#pragma once

#include <QCoreApplication>
#include <QDir>
#include <QPixmap>
#include <QWidget>

namespace fodscope {

/// Saves what a widget looks like into the folder that FODSCOPE_SCREENSHOTS names, if it names one.
inline void saveScreenshot(QWidget& widget, const QString& name) {
    const QString folder = qEnvironmentVariable("FODSCOPE_SCREENSHOTS");
    if (folder.isEmpty()) return;
    QCoreApplication::processEvents();
    widget.grab().save(QDir(folder).filePath(name + QStringLiteral(".png")));
}

}  // namespace fodscope
