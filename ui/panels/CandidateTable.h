// SPDX-License-Identifier: MIT
#pragma once

#include <QAbstractTableModel>
#include <QWidget>

#include "core/detection/Candidates.h"
#include "core/labels/Decision.h"

class QSortFilterProxyModel;
class QStackedLayout;
class QTableView;

namespace fodscope {

class EmptyState;
class InspectionController;

/// The candidates on the screen as rows.
class CandidateTableModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    enum Column { Id, Size, Height, Points, Greatest, State, ColumnCount };
    /// What rows are sorted by.
    static constexpr int kSortRole = Qt::UserRole;

    explicit CandidateTableModel(const InspectionController& controller, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    int rowOf(const QString& candidateId) const;
    QString idAt(int row) const;

    void takeCandidates();
    void takeStates();

  private:
    QVariant textOf(const Candidate& candidate, int column) const;
    QVariant sortValueOf(const Candidate& candidate, int column) const;
    QVariant stateOf(const Candidate& candidate, int role) const;

    const InspectionController& controller_;
    std::shared_ptr<const CandidateSet> shown_;
};

/// The list that goes through all steps: one row a candidate, selected here as everywhere.
class CandidateTable : public QWidget {
    Q_OBJECT

  public:
    explicit CandidateTable(InspectionController& controller, QWidget* parent = nullptr);

  private:
    void refresh();
    void showSelection();

    InspectionController& controller_;
    CandidateTableModel* model_ = nullptr;
    QSortFilterProxyModel* sorted_ = nullptr;
    QTableView* view_ = nullptr;
    EmptyState* empty_ = nullptr;
    QStackedLayout* stack_ = nullptr;
    bool following_ = false;
};

}  // namespace fodscope
