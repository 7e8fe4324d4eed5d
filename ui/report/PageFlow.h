// SPDX-License-Identifier: MIT
#pragma once

#include <QPointF>
#include <functional>
#include <memory>
#include <vector>

QT_BEGIN_NAMESPACE
class QPainter;
QT_END_NAMESPACE

namespace fodscope::report {

/// Something that is placed on a page as a whole.
struct FlowItem {
    double height = 0.0;
    double spaceBefore = 0.0;
    bool keepWithNext = false;
    bool startsPage = false;
    /// Painted again above this item when it comes first on a page (the header of a table).
    std::shared_ptr<const FlowItem> repeatedHeader;
    /// @param corner upper left corner of the item; it is as wide as the content
    std::function<void(QPainter& painter, const QPointF& corner)> paint;
};

using Flow = std::vector<FlowItem>;

struct PlacedItem {
    const FlowItem* item = nullptr;
    double top = 0.0;
};

using PlacedPage = std::vector<PlacedItem>;

/// Breaks a flow into pages. Items that keep with the next one stay on its page, unless together they are higher than a
/// page; an item higher than a page gets one of its own.
/// @param flow must outlive the result
std::vector<PlacedPage> paginate(const Flow& flow, double contentHeight);

}  // namespace fodscope::report
