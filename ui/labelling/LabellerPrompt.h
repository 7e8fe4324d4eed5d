// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

QT_BEGIN_NAMESPACE
class QLineEdit;
QT_END_NAMESPACE

namespace fodscope {

/// Asks once who labels, in the view itself: every decision carries a name.
class LabellerPrompt : public QWidget {
    Q_OBJECT

  public:
    explicit LabellerPrompt(QWidget* parent = nullptr);

    void takeFocus();

  signals:
    void named(const QString& name);

  private:
    void confirm();

    QLineEdit* name_ = nullptr;
};

}  // namespace fodscope
