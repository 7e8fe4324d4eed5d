// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QWidget>

class QLabel;

namespace fodscope {

/// A number that matters, its unit in muted text, and what it is: "12 candidates", "8 mm rms".
class NumberReadout : public QWidget {
    Q_OBJECT

  public:
    explicit NumberReadout(const QString& caption, QWidget* parent = nullptr);

    void setNumber(const QString& number, const QString& unit = {});
    /// An en dash: not known, never zero.
    void setUnknown();
    void setCaption(const QString& caption);
    QString number() const;

  private:
    QLabel* number_ = nullptr;
    QLabel* unit_ = nullptr;
    QLabel* caption_ = nullptr;
};

}  // namespace fodscope
