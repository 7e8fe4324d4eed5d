// SPDX-License-Identifier: MIT
#pragma once

#include "ui/panels/PanelParts.h"

namespace fodscope {

class Card;
class CommandSet;
class EmptyState;
class InspectionController;
class StatusChip;

/// What is known about the selected candidate, and about the point under the pointer.
class EvidencePanel : public PanelColumn {
    Q_OBJECT

  public:
    EvidencePanel(InspectionController& controller, const CommandSet& commands, QWidget* parent = nullptr);

  private:
    void refresh();
    void refreshCandidate();
    void refreshProbe();
    void showPhotos(const std::string& candidateId);

    InspectionController& controller_;
    EmptyState* empty_ = nullptr;
    Card* card_ = nullptr;
    StatusChip* chip_ = nullptr;
    QLabel* swatch_ = nullptr;
    FieldList* measures_ = nullptr;
    FieldList* visit_ = nullptr;
    Card* photosCard_ = nullptr;
    QVBoxLayout* photos_ = nullptr;
    std::vector<std::string> shownPhotos_;
    Card* probeCard_ = nullptr;
    FieldList* probe_ = nullptr;
};

}  // namespace fodscope
