// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QLineEdit;
class QListWidget;

namespace fodscope {

class CommandSet;

/// Something laid over the window, left by Esc or a click beside it.
class Overlay : public QWidget {
    Q_OBJECT

  public:
    explicit Overlay(QWidget* window);

    virtual void open();

  protected:
    QWidget* sheet() const { return sheet_; }
    void placeSheet(const QSize& size);
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QWidget* sheet_ = nullptr;
    QSize size_;
};

/// All keys of the program, on one sheet.
class ShortcutsOverlay : public Overlay {
    Q_OBJECT

  public:
    ShortcutsOverlay(const CommandSet& commands, QWidget* window);
};

/// Finds any command by name and does it.
class CommandPalette : public Overlay {
    Q_OBJECT

  public:
    CommandPalette(const CommandSet& commands, QWidget* window);
    void open() override;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void filter(const QString& text);
    void runCurrent();

    const CommandSet& commands_;
    QLineEdit* line_ = nullptr;
    QListWidget* list_ = nullptr;
};

}  // namespace fodscope
