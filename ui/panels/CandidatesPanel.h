// SPDX-License-Identifier: MIT
#pragma once

#include "core/detection/Candidates.h"
#include "ui/panels/PanelParts.h"

class QComboBox;

namespace fodscope {

class CommandSet;
class InspectionController;
class NumberReadout;
class ThresholdHistogram;
class ValueSlider;

/// Step 3: the histogram of the discrepancy and the three sliders; candidates follow while they are dragged.
class CandidatesPanel : public PanelColumn {
    Q_OBJECT

  public:
    CandidatesPanel(InspectionController& controller, const CommandSet& commands, QWidget* parent = nullptr);

    /// As a key press on the threshold's slider would.
    void stepThreshold(int steps, bool coarse);

  private:
    void refreshField();
    void refreshSettings();
    void refreshCounts();
    void applyRanges(const Parameters& parameters);
    CandidateSettings settings() const;
    void usePreset();
    void preview();
    void commit();

    InspectionController& controller_;
    QLabel* hint_ = nullptr;
    QWidget* body_ = nullptr;
    NumberReadout* candidates_ = nullptr;
    NumberReadout* above_ = nullptr;
    ThresholdHistogram* histogram_ = nullptr;
    ValueSlider* threshold_ = nullptr;
    ValueSlider* cutoff_ = nullptr;
    ValueSlider* leastPoints_ = nullptr;
    QComboBox* preset_ = nullptr;
    QComboBox* linkage_ = nullptr;
    QComboBox* centroid_ = nullptr;
    QLabel* note_ = nullptr;
    QLabel* frozen_ = nullptr;
    std::optional<CandidateSettings> rangedFor_;
    const DiscrepancyField* binnedField_ = nullptr;
    std::optional<Metric> binnedMetric_;
};

}  // namespace fodscope
