// SPDX-License-Identifier: MIT
#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <span>
#include <vector>

namespace fodscope {

/// A word that belongs to a spot of the picture.
struct LabelRequest {
    QPointF anchor;
    QSizeF size;
    /// Greater is placed first.
    int priority = 0;
};

struct PlacedLabel {
    QRectF box;
    bool placed = false;
};

/// Puts each label near its anchor, up and to the right if there is room, so that no two overlap and none leaves the
/// area. The same input gives the same places; a label that finds none is left out (`placed` is false).
/// @param blocked areas to keep free: tool bar, legend
std::vector<PlacedLabel> placeLabels(std::span<const LabelRequest> requests, const QRectF& area,
                                     std::span<const QRectF> blocked);

}  // namespace fodscope
