// SPDX-License-Identifier: MIT
#pragma once

#include <QStringList>
#include <QWidget>
#include <vector>

class QLabel;

namespace fodscope {

struct CandidateSettings;

/// Settings and what they come to, in columns beside each other: what was chosen and what is in effect.
class TuningValues : public QWidget {
    Q_OBJECT

  public:
    /// What the settings come to.
    struct Row {
        QString name;
        QString help;
    };

    explicit TuningValues(const std::vector<Row>& outcome, QWidget* parent = nullptr);

    /// @param outcome a text for each of the rows; none: not known
    void setChosen(const QString& heading, const CandidateSettings& settings, const QStringList& outcome);
    void setInEffect(const CandidateSettings& settings, const QStringList& outcome);

  private:
    void fill(std::size_t column, const CandidateSettings& settings, const QStringList& outcome);

    QLabel* heading_ = nullptr;
    std::vector<QLabel*> columns_[2];
};

}  // namespace fodscope
