// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>
#include <optional>

#include "core/detection/Candidates.h"

namespace fodscope {

class TuningValues;

/// What a search came to, and the values that are chosen from it.
class TuningPage : public QWidget {
    Q_OBJECT

  public:
    using QWidget::QWidget;

    /// The chosen values beside those in effect; owned by whoever shows them.
    virtual TuningValues* values() const = 0;
    /// Empty before a search, and when the search found nothing to choose.
    virtual std::optional<CandidateSettings> chosen() const = 0;
    /// There is a best one, and another is chosen.
    virtual bool canChooseBest() const = 0;
    virtual void chooseBest() = 0;
    /// Marks where the settings in effect lie, where that is known.
    virtual void markInEffect(const CandidateSettings& settings) = 0;

  signals:
    void chosenChanged();
};

}  // namespace fodscope
