// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>
#include <optional>

#include "core/common/Geometry.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace fodscope {

class FileDialogs;
class InspectionController;

/// @return the pose that three texts stand for, yaw in degrees; empty when one is no number
std::optional<Pose2> typedPose(const QString& x, const QString& y, const QString& yaw_deg);

/// Asks where the map begins in the reference, when that is known: typed, or from a file.
class StartPoseDialog : public QDialog {
    Q_OBJECT

  public:
    StartPoseDialog(InspectionController& controller, FileDialogs& files, QWidget* parent = nullptr);

    /// Fills in the pose that the map has now.
    void open() override;

  private:
    void refresh();

    InspectionController& controller_;
    FileDialogs& files_;
    QLineEdit* x_ = nullptr;
    QLineEdit* y_ = nullptr;
    QLineEdit* yaw_ = nullptr;
    QPushButton* use_ = nullptr;
};

}  // namespace fodscope
