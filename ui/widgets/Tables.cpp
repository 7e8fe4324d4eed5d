// SPDX-License-Identifier: MIT
#include "ui/widgets/Tables.h"

#include <QHeaderView>
#include <QTableView>

#include "ui/theme/Theme.h"

namespace fodscope {

void setUpTable(QTableView* table) {
    table->setShowGrid(false);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    table->setTabKeyNavigation(false);
    table->setWordWrap(false);
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(metrics::kControlHeight_px);
    table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    QHeaderView* heading = table->horizontalHeader();
    heading->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    heading->setHighlightSections(false);
    heading->setMinimumSectionSize(40);
}

}  // namespace fodscope
