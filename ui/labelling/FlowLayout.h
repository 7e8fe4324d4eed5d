// SPDX-License-Identifier: MIT
#pragma once

#include <QLayout>
#include <QList>

namespace fodscope {

/// Items side by side, in as many rows as the width asks for.
class FlowLayout : public QLayout {
  public:
    explicit FlowLayout(QWidget* parent = nullptr, int spacing_px = 8);
    ~FlowLayout() override;

    void addItem(QLayoutItem* item) override { items_.append(item); }
    int count() const override { return items_.size(); }
    QLayoutItem* itemAt(int index) const override { return items_.value(index); }
    QLayoutItem* takeAt(int index) override;
    Qt::Orientations expandingDirections() const override { return {}; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize minimumSize() const override;
    QSize sizeHint() const override;
    void setGeometry(const QRect& area) override;

  private:
    int arrange(const QRect& area, bool move) const;

    QList<QLayoutItem*> items_;
    int spacing_px_;
};

}  // namespace fodscope
