// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "ui/session/FileDialogs.h"

namespace fodscope {

/// Answers every question for a file with one folder: the autopilot has nobody to ask.
class FolderAnswers : public FileDialogs {
  public:
    explicit FolderAnswers(QString folder) : folder_(std::move(folder)) {}

    QString openFile(QWidget*, const QString&, const QString&) override { return {}; }
    QStringList openFiles(QWidget*, const QString&, const QString&) override { return {}; }
    QString saveFile(QWidget*, const QString&, const QString&, const QString&) override { return {}; }
    QString chooseFolder(QWidget*, const QString&, const QString&) override { return folder_; }

  private:
    QString folder_;
};

}  // namespace fodscope
