// SPDX-License-Identifier: MIT
#pragma once

#include "ui/tuning/CostGrid.h"
#include "ui/tuning/TuningPage.h"
#include "ui/tuning/TuningSearch.h"

class QLabel;

namespace fodscope {

class CostSurface;
class ValueSlider;

/// The paper's search: the cost of every setting as a picture.
class CostPage : public TuningPage {
    Q_OBJECT

  public:
    explicit CostPage(QWidget* parent = nullptr);

    void showOutcome(const TuningOutcome& outcome);
    const std::optional<TuningOutcome>& outcome() const { return outcome_; }

    TuningValues* values() const override { return values_; }
    std::optional<CandidateSettings> chosen() const override;
    bool canChooseBest() const override { return outcome_ && !(chosen_ == outcome_->result.best); }
    void chooseBest() override;
    void markInEffect(const CandidateSettings& settings) override;

  private:
    void showLeastPoints();
    void choose(const CostCell& cell);
    void read(const std::optional<CostCell>& cell);
    std::size_t leastIndex() const;

    std::optional<TuningOutcome> outcome_;
    GridPoint chosen_;
    TuningValues* values_ = nullptr;
    CostSurface* surface_ = nullptr;
    QLabel* reading_ = nullptr;
    ValueSlider* leastPoints_ = nullptr;
};

}  // namespace fodscope
