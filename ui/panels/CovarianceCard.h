// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/inspection/Parameters.h"
#include "ui/widgets/Card.h"

class QComboBox;

namespace fodscope {

class CommandSet;
class InspectionController;

/// @return the preset whose way of making references a record has; empty: a way of its own
std::string referencePresetOf(const Parameters& parameters);

/// How the covariances of the next reference are fitted: a preset, or every choice by itself.
class CovarianceCard : public Card {
    Q_OBJECT

  public:
    CovarianceCard(InspectionController& controller, const CommandSet& commands, QWidget* parent = nullptr);

  private:
    void refresh();
    void usePreset();

    InspectionController& controller_;
    QComboBox* preset_ = nullptr;
};

}  // namespace fodscope
