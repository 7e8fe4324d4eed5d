// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QLabel;
class QHBoxLayout;
class QVBoxLayout;
class QToolButton;

namespace fodscope {

/// A titled group on a panel: heading, optional widgets at its right, a body. No frame: a hairline above the heading.
class Card : public QWidget {
    Q_OBJECT

  public:
    explicit Card(const QString& title, QWidget* parent = nullptr);

    void setTitle(const QString& title);
    QVBoxLayout* body() const { return body_; }
    /// At the right end of the heading: a chip, a small button.
    void addHeaderWidget(QWidget* widget);
    /// A muted line under the heading; empty hides it.
    void setCaption(const QString& caption);
    void setCollapsible(bool collapsible);
    void setCollapsed(bool collapsed);
    bool isCollapsed() const;

  signals:
    void collapsedChanged(bool collapsed);

  private:
    QLabel* title_ = nullptr;
    QLabel* caption_ = nullptr;
    QHBoxLayout* header_ = nullptr;
    QToolButton* fold_ = nullptr;
    QWidget* content_ = nullptr;
    QVBoxLayout* body_ = nullptr;
};

}  // namespace fodscope
