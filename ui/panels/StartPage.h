// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QVBoxLayout;

namespace fodscope {

class CommandSet;

/// What is seen while no inspection is open: three ways to begin, and the sessions opened lately.
class StartPage : public QWidget {
    Q_OBJECT

  public:
    explicit StartPage(const CommandSet& commands, QWidget* parent = nullptr);

  signals:
    void sessionChosen(const QString& file);

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void listRecent();

    QVBoxLayout* recent_ = nullptr;
};

}  // namespace fodscope
