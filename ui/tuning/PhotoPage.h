// SPDX-License-Identifier: MIT
#pragma once

#include "ui/tuning/PhotoTuning.h"
#include "ui/tuning/TuningPage.h"

class QLabel;

namespace fodscope {

class RecallPlot;

/// The search for the fewest photos: their precision over the recall, with the settings in effect on it.
class PhotoPage : public TuningPage {
    Q_OBJECT

  public:
    explicit PhotoPage(QWidget* parent = nullptr);

    void showOutcome(const PhotoTuningOutcome& outcome);
    const std::optional<PhotoTuningOutcome>& outcome() const { return outcome_; }

    TuningValues* values() const override { return values_; }
    std::optional<CandidateSettings> chosen() const override;
    bool canChooseBest() const override { return best_ && chosen_ != best_; }
    void chooseBest() override;
    void markInEffect(const CandidateSettings& settings) override;

  private:
    void choose(std::size_t point);
    void read(const std::optional<std::size_t>& point);

    std::optional<PhotoTuningOutcome> outcome_;
    /// Points of the curve.
    std::optional<std::size_t> chosen_;
    std::optional<std::size_t> best_;
    TuningValues* values_ = nullptr;
    RecallPlot* plot_ = nullptr;
    QLabel* reading_ = nullptr;
};

}  // namespace fodscope
