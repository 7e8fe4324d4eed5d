// SPDX-License-Identifier: MIT
#pragma once

#include <QAbstractButton>

#include "ui/theme/Theme.h"

namespace fodscope {

/// A large label key: the key in a cap, the word beside it. Checked: this is the decision. The shortcut itself is set
/// by whoever owns the keys; clicking sends clicked().
class KeyCap : public QAbstractButton {
    Q_OBJECT

  public:
    KeyCap(const QString& key, const QString& word, QWidget* parent = nullptr);

    void setKey(const QString& key);
    QString key() const { return key_; }
    /// Colour of the stripe and of the checked state: Finding for FOD labels, Clear for no FOD, Attention for not sure.
    void setStatus(StatusKind kind);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEvent* event) override;
    void leaveEvent(QEvent* event) override;

  private:
    QString key_;
    StatusKind status_ = StatusKind::Neutral;
    bool hovered_ = false;
};

}  // namespace fodscope
