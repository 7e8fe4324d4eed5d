// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>
#include <vector>

class QGridLayout;
class QLabel;

namespace fodscope {

struct CandidateSettings;
struct SearchCost;

/// Settings and what they cost, in columns beside each other: what was chosen and what is in effect.
class TuningValues : public QWidget {
    Q_OBJECT

  public:
    explicit TuningValues(QWidget* parent = nullptr);

    void setChosen(const QString& heading, const CandidateSettings& settings, const SearchCost& cost);
    void setInEffect(const CandidateSettings& settings, const SearchCost& cost);

  private:
    void fill(std::size_t column, const CandidateSettings& settings, const SearchCost& cost);

    QLabel* heading_ = nullptr;
    std::vector<QLabel*> columns_[2];
};

}  // namespace fodscope
