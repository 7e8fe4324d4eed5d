// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringList>
#include <map>

#include "core/inspection/ParameterTable.h"

namespace fodscope {

/// Parameters while they are being edited: what is in effect, what it is compared with, and what was typed, even where
/// that is no value yet. Knows no widgets.
class ParameterDraft {
  public:
    /// @param isFrozen the visits have begun: only what steers them may change
    ParameterDraft(const Parameters& inEffect, const Parameters& preset, bool isFrozen = false);

    const Parameters& edited() const { return edited_; }
    const Parameters& inEffect() const { return inEffect_; }
    /// What was edited and may not change any more goes back to what is in effect.
    void setFrozen(bool isFrozen);
    void setEdited(const Parameters& parameters);
    void setPreset(const Parameters& preset) { preset_ = preset; }

    /// Takes what was typed. A text that is no value is kept as it is and becomes a problem.
    void setText(const ParameterField& field, const QString& text);
    QString text(const ParameterField& field) const;
    /// Back to the preset's value.
    void reset(const ParameterField& field);
    void usePreset();
    /// Back to what is in effect.
    void discard();

    /// The preset's value; for a threshold and what goes with it, that of the metric that is chosen.
    QString presetText(const ParameterField& field) const;
    bool differsFromPreset(const ParameterField& field) const;
    bool isFrozen(const ParameterField& field) const;
    /// What is wrong with one parameter by itself; empty: nothing.
    QString problem(const ParameterField& field) const;
    /// Everything that is wrong, also between parameters, all at once.
    QStringList problems() const;

    bool hasChanges() const { return !unreadable_.empty() || edited_ != inEffect_; }
    /// Why it cannot be applied now; empty: it can.
    QString obstacle() const;

  private:
    ParameterValue presetValue(const ParameterField& field) const;

    Parameters inEffect_;
    Parameters preset_;
    Parameters edited_;
    bool isFrozen_ = false;
    std::map<const ParameterField*, QString> unreadable_;
};

/// @return the preset that differs from the record in the fewest parameters
std::string nearestPreset(const Parameters& parameters);

}  // namespace fodscope
