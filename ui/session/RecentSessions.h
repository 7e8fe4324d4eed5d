// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringList>
#include <optional>

#include "ui/session/Steps.h"

namespace fodscope {

/// Session files opened lately, newest first, and the step each was left at. Kept in the user's settings.
class RecentSessions {
  public:
    /// Only those that still exist.
    QStringList files() const;
    void add(const QString& file);
    void remove(const QString& file);

    std::optional<Step> stepOf(const std::string& inspectionId) const;
    void rememberStep(const std::string& inspectionId, Step step);
};

}  // namespace fodscope
