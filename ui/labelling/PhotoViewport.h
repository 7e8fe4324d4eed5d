// SPDX-License-Identifier: MIT
#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include "core/labels/Decision.h"

namespace fodscope {

/// How a photo lies in a widget: widget = scale · image + offset.
struct PhotoViewport {
    double scale = 1.0;
    QPointF offset;

    QPointF toWidget(const QPointF& point_px) const { return point_px * scale + offset; }
    QPointF toImage(const QPointF& point) const { return (point - offset) / scale; }
    QRectF toWidget(const QRectF& rect_px) const { return {toWidget(rect_px.topLeft()), rect_px.size() * scale}; }
};

/// The whole photo, centred, with a margin.
PhotoViewport fittedViewport(const QSizeF& image_px, const QSizeF& widget, double margin = 8.0);

/// Zooms so that the image point under `anchor` stays under it; the scale stays between a quarter of the fitted one and
/// 16 widget pixels an image pixel.
PhotoViewport zoomedViewport(const PhotoViewport& viewport, double factor, const QPointF& anchor,
                             const QSizeF& image_px, const QSizeF& widget);

/// Keeps the photo in sight: an axis on which it fits is centred, on the other no gap opens at the edges.
PhotoViewport keptInSight(PhotoViewport viewport, const QSizeF& image_px, const QSizeF& widget);

/// The box between two corners in image pixels, in any order, clipped to the image; width or height 0 when it is none.
PixelBox boxBetween(const QPointF& a_px, const QPointF& b_px, const QSizeF& image_px);

/// Smaller boxes are slips of the hand, not boxes.
inline constexpr double kSmallestBox_px = 4.0;

}  // namespace fodscope
