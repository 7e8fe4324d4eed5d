// SPDX-License-Identifier: MIT
#include "ui/panels/CandidateTable.h"

#include <QHeaderView>
#include <QPainter>
#include <QSortFilterProxyModel>
#include <QStackedLayout>
#include <QTableView>
#include <algorithm>

#include "ui/panels/Format.h"
#include "ui/session/InspectionController.h"
#include "ui/theme/Colours.h"
#include "ui/widgets/EmptyState.h"
#include "ui/widgets/StatusChip.h"

namespace fodscope {
namespace {

constexpr int kSwatch_px = 14;

QPixmap stateShape(StatusKind kind) {
    QPixmap picture(kSwatch_px * 2, kSwatch_px * 2);
    picture.setDevicePixelRatio(2.0);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    paintStatusShape(painter, QRectF(1, 1, kSwatch_px - 2, kSwatch_px - 2), kind, currentTheme());
    return picture;
}

/// As it is in every state of the row: a tinted swatch would be another candidate's.
QIcon untinted(const QPixmap& picture) {
    QIcon same;
    same.addPixmap(picture, QIcon::Normal);
    same.addPixmap(picture, QIcon::Selected);
    return same;
}

QPixmap swatch(const QString& id) {
    QPixmap picture(10, 10);
    picture.fill(candidateColour(id));
    return picture;
}

}  // namespace

CandidateTableModel::CandidateTableModel(const InspectionController& controller, QObject* parent)
    : QAbstractTableModel(parent), controller_(controller) {}

int CandidateTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !shown_ ? 0 : static_cast<int>(shown_->candidates.size());
}

int CandidateTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant CandidateTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>(Qt::AlignVCenter |
                                (section == Id || section == State ? Qt::AlignLeft : Qt::AlignRight));
    if (role != Qt::DisplayRole) return {};
    switch (section) {
        case Id:
            return tr("Candidate");
        case Size:
            return tr("Size l × w × h");
        case Height:
            return tr("Above floor");
        case Points:
            return tr("Points");
        case Greatest:
            return tr("Max. discrepancy");
        case State:
            return tr("State");
    }
    return {};
}

QVariant CandidateTableModel::textOf(const Candidate& candidate, int column) const {
    switch (column) {
        case Id:
            return QString::fromStdString(candidate.id);
        case Size:
            return sizeText(candidate.size_m);
        case Height:
            return centimetres(candidate.heightAboveFloor_m);
        case Points:
            return count(candidate.voxels.size());
        case Greatest:
            return discrepancyText(candidate.discrepancyMax, controller_.shownCandidateSettings().metric);
    }
    return {};
}

QVariant CandidateTableModel::sortValueOf(const Candidate& candidate, int column) const {
    switch (column) {
        case Id:
            return QString::fromStdString(candidate.id);
        case Size:
            return candidate.size_m.x();
        case Height:
            return candidate.heightAboveFloor_m;
        case Points:
            return static_cast<qulonglong>(candidate.voxels.size());
        case Greatest:
            return candidate.discrepancyMax;
    }
    return stateOf(candidate, Qt::DisplayRole);
}

QVariant CandidateTableModel::stateOf(const Candidate& candidate, int role) const {
    StateText text{StatusKind::Attention, tr("preview")};
    for (const CandidateVerdict& verdict : controller_.verdicts())
        if (verdict.candidateId == candidate.id) text = candidateState(controller_.state(), verdict);
    if (role == Qt::DisplayRole) return text.word;
    if (role == Qt::DecorationRole) return untinted(stateShape(text.kind));
    return {};
}

QVariant CandidateTableModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || !shown_) return {};
    const Candidate& candidate = shown_->candidates[static_cast<std::size_t>(index.row())];
    const int column = index.column();
    if (role == kSortRole) return sortValueOf(candidate, column);
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>(Qt::AlignVCenter | (column == Id || column == State ? Qt::AlignLeft : Qt::AlignRight));
    if (column == State) return stateOf(candidate, role);
    if (role == Qt::DecorationRole && column == Id) return untinted(swatch(QString::fromStdString(candidate.id)));
    if (role == Qt::DisplayRole) return textOf(candidate, column);
    return {};
}

int CandidateTableModel::rowOf(const QString& candidateId) const {
    if (!shown_) return -1;
    const auto found = std::ranges::find(shown_->candidates, candidateId.toStdString(), &Candidate::id);
    return found == shown_->candidates.end() ? -1 : static_cast<int>(found - shown_->candidates.begin());
}

QString CandidateTableModel::idAt(int row) const {
    return QString::fromStdString(shown_->candidates[static_cast<std::size_t>(row)].id);
}

void CandidateTableModel::takeCandidates() {
    beginResetModel();
    shown_ = controller_.shownCandidates();
    endResetModel();
}

void CandidateTableModel::takeStates() {
    if (rowCount() > 0) emit dataChanged(index(0, State), index(rowCount() - 1, State));
}

CandidateTable::CandidateTable(InspectionController& controller, QWidget* parent)
    : QWidget(parent), controller_(controller) {
    setObjectName(QStringLiteral("panel.table"));
    setSurface(this, SurfaceRole::Surface1);
    model_ = new CandidateTableModel(controller, this);
    sorted_ = new QSortFilterProxyModel(this);
    sorted_->setSourceModel(model_);
    sorted_->setSortRole(CandidateTableModel::kSortRole);
    view_ = new QTableView(this);
    view_->setObjectName(QStringLiteral("candidate.table"));
    view_->setModel(sorted_);
    view_->setSortingEnabled(true);
    // The order of suspicion until a column is clicked.
    view_->horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
    sorted_->sort(-1);
    view_->setSelectionBehavior(QAbstractItemView::SelectRows);
    view_->setSelectionMode(QAbstractItemView::SingleSelection);
    view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    view_->setTabKeyNavigation(false);
    view_->setShowGrid(false);
    view_->setFrameShape(QFrame::NoFrame);
    view_->verticalHeader()->hide();
    view_->verticalHeader()->setDefaultSectionSize(26);
    view_->horizontalHeader()->setHighlightSections(false);
    view_->horizontalHeader()->setStretchLastSection(true);
    view_->horizontalHeader()->setMinimumSectionSize(80);
    for (const auto& [column, width] : {std::pair{0, 100}, {1, 144}, {2, 104}, {3, 84}, {4, 144}})
        view_->setColumnWidth(column, width);
    empty_ = new EmptyState(this);
    stack_ = new QStackedLayout(this);
    stack_->addWidget(view_);
    stack_->addWidget(empty_);

    connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& index) {
        if (following_ || !index.isValid()) return;
        controller_.selectCandidate(model_->idAt(sorted_->mapToSource(index).row()));
    });
    connect(view_, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
        controller_.flyToCandidate(model_->idAt(sorted_->mapToSource(index).row()));
    });
    connect(&controller, &InspectionController::sessionChanged, this, &CandidateTable::refresh);
    connect(&controller, &InspectionController::candidatesChanged, this, &CandidateTable::refresh);
    connect(&controller, &InspectionController::selectionChanged, this, &CandidateTable::showSelection);
    for (const auto signal : {&InspectionController::planChanged, &InspectionController::visitsChanged,
                              &InspectionController::photosChanged, &InspectionController::decisionsChanged})
        connect(&controller, signal, model_, &CandidateTableModel::takeStates);
    refresh();
}

void CandidateTable::refresh() {
    following_ = true;
    model_->takeCandidates();
    following_ = false;
    const bool hasRows = model_->rowCount() > 0;
    stack_->setCurrentWidget(hasRows ? static_cast<QWidget*>(view_) : empty_);
    const auto& detection = controller_.state().detection;
    if (!hasRows)
        empty_->showEmpty(Icon::Table, !detection ? tr("Candidates are listed here once the map is aligned.")
                                       : !detection->candidates
                                           ? tr("No candidates are claimed, because the map is not aligned.")
                                           : tr("No candidate is above the threshold."));
    showSelection();
}

void CandidateTable::showSelection() {
    following_ = true;
    const int row = model_->rowOf(controller_.selectedCandidate());
    if (row < 0) {
        view_->clearSelection();
        view_->setCurrentIndex({});
    } else {
        const QModelIndex index = sorted_->mapFromSource(model_->index(row, 0));
        if (view_->currentIndex().row() != index.row() || !view_->selectionModel()->isRowSelected(index.row(), {}))
            view_->selectRow(index.row());
        view_->scrollTo(index);
    }
    following_ = false;
}

}  // namespace fodscope
