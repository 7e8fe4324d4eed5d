// SPDX-License-Identifier: MIT
#pragma once

#include "ui/session/Steps.h"

namespace fodscope {

/// What commands ask of the window. Implemented by the main window.
class Navigation {
  public:
    virtual ~Navigation() = default;

    virtual void showStep(Step step) = 0;
    virtual Step currentStep() const = 0;
    /// Moves the threshold by steps of the step's slider, as a key press on it would.
    virtual void stepThreshold(int steps, bool coarse) = 0;
    /// Asks where the map begins in the reference.
    virtual void askStartPose() = 0;
    virtual void showResiduals(bool shown) = 0;
    /// Opens the search for parameters.
    virtual void showTuning() = 0;
    /// Opens all settings of the inspection.
    virtual void showSettings() = 0;
    virtual void toggleShortcuts() = 0;
    /// Opens the manual at the current step.
    virtual void showManual() = 0;
    virtual void togglePalette() = 0;
    virtual void toggleTheme() = 0;
    virtual void fitViews() = 0;
    virtual void showReferenceHeatMap(bool shown) = 0;
    virtual void nextUndecidedPhoto() = 0;
    virtual void leave() = 0;
    virtual void quit() = 0;
};

}  // namespace fodscope
