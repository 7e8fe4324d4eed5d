// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>
#include <vector>

#include "core/common/Geometry.h"

class QListWidget;
class QPushButton;

namespace fodscope {

class InspectionController;
struct RegistrationResult;

/// A pose that the map may have, and how well it fits there.
struct PoseChoice {
    Transform T_reference_from_map = Transform::Identity();
    double overlap = 0.0;
    double rms_m = 0.0;
};

/// @return the best pose and its alternatives; empty when there is nothing to choose from
std::vector<PoseChoice> poseChoices(const RegistrationResult& registration);

/// The poses that fit nearly alike: a click shows the map there, a button settles for one.
class PoseList : public QWidget {
    Q_OBJECT

  public:
    explicit PoseList(InspectionController& controller, QWidget* parent = nullptr);

    void setChoices(std::vector<PoseChoice> choices);

  private:
    void preview(int row);
    void use();

    InspectionController& controller_;
    std::vector<PoseChoice> choices_;
    QListWidget* list_ = nullptr;
    QPushButton* use_ = nullptr;
};

}  // namespace fodscope
