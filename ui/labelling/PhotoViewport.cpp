// SPDX-License-Identifier: MIT
#include "ui/labelling/PhotoViewport.h"

#include <algorithm>

namespace fodscope {

namespace {

constexpr double kLargestScale = 16.0;

double keptInSight(double offset, double shown, double widget) {
    if (shown <= widget) return 0.5 * (widget - shown);
    return std::clamp(offset, widget - shown, 0.0);
}

}  // namespace

PhotoViewport fittedViewport(const QSizeF& image_px, const QSizeF& widget, double margin) {
    if (image_px.isEmpty()) return {};
    const double width = std::max(1.0, widget.width() - 2.0 * margin);
    const double height = std::max(1.0, widget.height() - 2.0 * margin);
    PhotoViewport viewport;
    viewport.scale = std::min(width / image_px.width(), height / image_px.height());
    return keptInSight(viewport, image_px, widget);
}

PhotoViewport zoomedViewport(const PhotoViewport& viewport, double factor, const QPointF& anchor,
                             const QSizeF& image_px, const QSizeF& widget) {
    const double fitted = fittedViewport(image_px, widget).scale;
    PhotoViewport zoomed;
    zoomed.scale = std::clamp(viewport.scale * factor, std::min(0.25 * fitted, 1.0), std::max(kLargestScale, fitted));
    zoomed.offset = anchor - viewport.toImage(anchor) * zoomed.scale;
    return keptInSight(zoomed, image_px, widget);
}

PhotoViewport keptInSight(PhotoViewport viewport, const QSizeF& image_px, const QSizeF& widget) {
    viewport.offset.setX(keptInSight(viewport.offset.x(), image_px.width() * viewport.scale, widget.width()));
    viewport.offset.setY(keptInSight(viewport.offset.y(), image_px.height() * viewport.scale, widget.height()));
    return viewport;
}

PixelBox boxBetween(const QPointF& a_px, const QPointF& b_px, const QSizeF& image_px) {
    const QRectF image(QPointF(0, 0), image_px);
    const QRectF box = QRectF(a_px, b_px).normalized().intersected(image);
    return {box.left(), box.top(), std::max(0.0, box.width()), std::max(0.0, box.height())};
}

}  // namespace fodscope
