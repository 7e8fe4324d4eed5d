// SPDX-License-Identifier: MIT
#pragma once

class QTableView;

namespace fodscope {

/// How all tables look: rows of 28 px without grid, whole rows selected, headings left-aligned, no row numbers.
void setUpTable(QTableView* table);

}  // namespace fodscope
