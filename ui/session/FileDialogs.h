// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace fodscope {

/// Asks the operator for files. An interface, so that a test or an automatic run can answer instead.
class FileDialogs {
  public:
    virtual ~FileDialogs() = default;

    /// @param filter as QFileDialog takes it
    /// @return the file, or empty when the operator changed their mind
    virtual QString openFile(QWidget* parent, const QString& title, const QString& filter) = 0;
    virtual QStringList openFiles(QWidget* parent, const QString& title, const QString& filter) = 0;
    virtual QString saveFile(QWidget* parent, const QString& title, const QString& proposal, const QString& filter) = 0;
    virtual QString chooseFolder(QWidget* parent, const QString& title, const QString& proposal) = 0;
};

/// The desktop's own dialogs. They remember the last folder.
class DesktopFileDialogs : public FileDialogs {
  public:
    QString openFile(QWidget* parent, const QString& title, const QString& filter) override;
    QStringList openFiles(QWidget* parent, const QString& title, const QString& filter) override;
    QString saveFile(QWidget* parent, const QString& title, const QString& proposal, const QString& filter) override;
    QString chooseFolder(QWidget* parent, const QString& title, const QString& proposal) override;
};

}  // namespace fodscope
