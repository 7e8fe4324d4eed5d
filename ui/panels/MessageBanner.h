// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QWidget>

class QLabel;

namespace fodscope {

/// The place where errors are told: one sentence over the work area, until it is dismissed. It blocks nothing.
class MessageBanner : public QWidget {
    Q_OBJECT

  public:
    explicit MessageBanner(QWidget* parent = nullptr);

    void showError(const QString& sentence);
    QString message() const;

  public slots:
    void dismiss();

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QLabel* text_ = nullptr;
};

}  // namespace fodscope
