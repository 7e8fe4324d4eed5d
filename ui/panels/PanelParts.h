// SPDX-License-Identifier: MIT
#pragma once

#include <QFormLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <vector>

#include "core/inspection/ReportModel.h"
#include "ui/theme/Theme.h"

namespace fodscope {

/// Names at the left in muted text, values at the right that can be selected and copied.
class FieldList : public QWidget {
  public:
    explicit FieldList(QWidget* parent = nullptr);

    void setFields(const std::vector<std::pair<QString, QString>>& fields);
    void setFields(const std::vector<ReportField>& fields);

  private:
    QFormLayout* form_ = nullptr;
    std::vector<std::pair<QLabel*, QLabel*>> rows_;
};

/// A column of cards that scrolls when the window is low.
class PanelColumn : public QScrollArea {
  public:
    /// @param leastWidth_px room for values that would else be wrapped
    explicit PanelColumn(QWidget* parent = nullptr, int leastWidth_px = 272);
    QVBoxLayout* column() const { return column_; }
    /// Puts something that is no card under the last one, with the margins of a card.
    void addBare(QWidget* widget);
    QSize sizeHint() const override;
    /// As wide as what it holds: a panel is never cut off at its side.
    QSize minimumSizeHint() const override;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QVBoxLayout* column_ = nullptr;
    int leastWidth_px_ = 0;
};

/// A wrapped sentence in a role.
QLabel* makeText(const QString& text, TextRole role, QWidget* parent);

}  // namespace fodscope
