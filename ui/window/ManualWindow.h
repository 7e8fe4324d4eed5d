// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>
#include <optional>

#include "ui/session/Steps.h"

class QTextBrowser;

namespace fodscope {

/// The user manual in a window of its own, so that it can stay open beside the work.
class ManualWindow : public QWidget {
    Q_OBJECT

  public:
    /// @throws Error when the manual is not installed
    explicit ManualWindow(QWidget* parent = nullptr);

    /// Scrolls to the chapter of a step, or to the beginning when no inspection is open.
    void showStep(std::optional<Step> step);

  private:
    QTextBrowser* text_ = nullptr;
};

}  // namespace fodscope
