// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QWidget>

#include "core/inspection/ParameterTable.h"

class QCheckBox;
class QComboBox;
class QLineEdit;

namespace fodscope {

/// The control for one parameter by its kind: a tick box, a choice, or a line for a number. All speak in the words of a
/// parameter file. The mouse wheel scrolls the page and never changes a value.
class ParameterEditor : public QWidget {
    Q_OBJECT

  public:
    explicit ParameterEditor(const ParameterField& field, QWidget* parent = nullptr);

    /// No signal is sent; a text that is being typed and means the same is left alone.
    void setText(const QString& text);
    QString text() const;
    void setInvalid(bool invalid);

  signals:
    /// While typing.
    void edited(const QString& text);
    /// When a choice was made or the line was left or confirmed.
    void committed(const QString& text);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QCheckBox* tick_ = nullptr;
    QComboBox* choice_ = nullptr;
    QLineEdit* line_ = nullptr;
};

}  // namespace fodscope
