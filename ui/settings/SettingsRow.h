// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>

#include "core/inspection/ParameterTable.h"

class QGridLayout;
class QLabel;
class QToolButton;

namespace fodscope {

class ParameterDraft;
class ParameterEditor;

/// One parameter in a grid: name, control, unit, and where it differs the preset's value with a button back to it.
class SettingsRow : public QObject {
    Q_OBJECT

  public:
    SettingsRow(const ParameterField& field, QGridLayout& grid, int row, QWidget* parent);

    const ParameterField& field() const { return field_; }
    void show(const ParameterDraft& draft);
    void setVisible(bool visible);
    ParameterEditor& editor() { return *editor_; }

  signals:
    void edited(const QString& text);
    void resetAsked();

  private:
    /// Whether the reset button takes up room while it is hidden, so that the columns stand still.
    void keepResetsPlace(bool kept);

    const ParameterField& field_;
    QLabel* name_ = nullptr;
    ParameterEditor* editor_ = nullptr;
    QLabel* unit_ = nullptr;
    QLabel* note_ = nullptr;
    QToolButton* reset_ = nullptr;
};

}  // namespace fodscope
