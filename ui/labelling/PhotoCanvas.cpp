// SPDX-License-Identifier: MIT
#include "ui/labelling/PhotoCanvas.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>

#include "ui/labelling/ContrastStretch.h"
#include "ui/theme/Colours.h"
#include "ui/theme/Icons.h"
#include "ui/theme/Theme.h"

namespace fodscope {

namespace {

QRectF toRect(const PixelBox& box) {
    return {box.left_px, box.top_px, box.width_px, box.height_px};
}

/// A line that shows on dark as on light ground.
void strokeTwice(QPainter& painter, const QPen& pen, const QPolygonF& polygon) {
    QPen under = pen;
    under.setColor(QColor(0, 0, 0, 150));
    under.setStyle(Qt::SolidLine);
    under.setWidthF(pen.widthF() + 2.0);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(under);
    painter.drawPolygon(polygon);
    painter.setPen(pen);
    painter.drawPolygon(polygon);
}

void paintTag(QPainter& painter, const QPointF& corner, const QString& text, const QColor& colour) {
    painter.setFont(fontFor(TextRole::Caption));
    const QFontMetricsF metrics(painter.font());
    const QSizeF size(metrics.horizontalAdvance(text) + 10.0, metrics.height() + 4.0);
    const QRectF tag(corner.x(), std::max(2.0, corner.y() - size.height() - 2.0), size.width(), size.height());
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(10, 13, 16, 215));
    painter.drawRoundedRect(tag, 3.0, 3.0);
    painter.fillRect(QRectF(tag.left(), tag.top() + 3.0, 2.0, tag.height() - 6.0), colour);
    painter.setPen(QColor(232, 237, 242));
    painter.drawText(tag.adjusted(3.0, 0.0, 0.0, 0.0), Qt::AlignCenter, text);
}

}  // namespace

PhotoCanvas::PhotoCanvas(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("photoCanvas"));
    setMinimumSize(240, 160);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setMouseTracking(true);
    setAccessibleName(tr("Photo"));
}

void PhotoCanvas::showPhoto(const QImage& photo, const std::vector<CandidateOutline>& outlines) {
    const bool sameSize = photo.size() == photo_.size();
    photo_ = photo;
    stretched_ = {};
    outlines_ = outlines;
    boxStart_px_.reset();
    // A zoom is a look at one photo; the next starts with the whole.
    if (!sameSize || !fitted_) fitted_ = true;
    fit();
}

void PhotoCanvas::showSentence(const QString& heading, const QString& sentence, bool isError) {
    photo_ = {};
    stretched_ = {};
    outlines_.clear();
    boxStart_px_.reset();
    heading_ = heading;
    sentence_ = sentence;
    isError_ = isError;
    emit zoomChanged();
    update();
}

void PhotoCanvas::setBoxes(std::vector<PhotoLabel> decided, const LabelDraft& draft) {
    decided_ = std::move(decided);
    draft_ = draft;
    update();
}

void PhotoCanvas::setOutlineShown(bool shown) {
    outlineShown_ = shown;
    update();
}

void PhotoCanvas::setContrast(bool on) {
    contrast_ = on;
    update();
}

void PhotoCanvas::setBoxDrawing(bool allowed) {
    boxDrawing_ = allowed;
    setCursor(allowed && !photo_.isNull() ? Qt::CrossCursor : Qt::ArrowCursor);
}

void PhotoCanvas::fit() {
    setViewport(fittedViewport(imageSize(), size()), true);
}

void PhotoCanvas::cycleZoom() {
    const QPointF middle(0.5 * width(), 0.5 * height());
    if (fitted_) {
        scaleTo(1.0, middle);
    } else if (viewport_.scale < 1.5) {
        scaleTo(2.0, middle);
    } else {
        fit();
    }
}

void PhotoCanvas::zoom(double factor) {
    if (photo_.isNull()) return;
    setViewport(zoomedViewport(viewport_, factor, {0.5 * width(), 0.5 * height()}, imageSize(), size()), false);
}

void PhotoCanvas::pan(const QPointF& step) {
    if (photo_.isNull()) return;
    PhotoViewport moved = viewport_;
    moved.offset += step;
    setViewport(keptInSight(moved, imageSize(), size()), fitted_);
}

QString PhotoCanvas::zoomInWords() const {
    return fitted_ ? tr("fit") : tr("%1 %").arg(std::lround(viewport_.scale * 100.0));
}

void PhotoCanvas::setViewport(const PhotoViewport& viewport, bool fitted) {
    viewport_ = viewport;
    fitted_ = fitted;
    emit zoomChanged();
    update();
}

void PhotoCanvas::scaleTo(double scale, const QPointF& anchor) {
    if (photo_.isNull()) return;
    setViewport(zoomedViewport(viewport_, scale / viewport_.scale, anchor, imageSize(), size()), false);
}

const QImage& PhotoCanvas::shown() {
    if (!contrast_) return photo_;
    if (stretched_.isNull()) stretched_ = contrastStretched(photo_);
    return stretched_;
}

void PhotoCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), currentTheme().surface0);
    if (photo_.isNull()) {
        paintSentence(painter);
        return;
    }
    painter.setRenderHint(QPainter::Antialiasing);
    // Smoothing hides what single pixels show, so large scales draw them as they are.
    painter.setRenderHint(QPainter::SmoothPixmapTransform, viewport_.scale < 3.0);
    painter.drawImage(viewport_.toWidget(QRectF(QPointF(0, 0), imageSize())), shown());
    if (outlineShown_) paintOutlines(painter);
    paintBoxes(painter);
}

void PhotoCanvas::paintOutlines(QPainter& painter) const {
    for (const CandidateOutline& outline : outlines_) {
        QPolygonF polygon;
        for (const QPointF& corner : outline.polygon_px)
            polygon << viewport_.toWidget(corner);
        const QString id = QString::fromStdString(outline.candidateId);
        const QColor colour = candidateColour(id);
        // Dark hues of the cycle would sink into a dark tank.
        strokeTwice(painter, QPen(mixed(colour, Qt::white, 0.3), 2.0, Qt::DashLine), polygon);
        paintTag(painter, polygon.boundingRect().topLeft(), id, colour);
    }
}

void PhotoCanvas::paintBoxes(QPainter& painter) const {
    const Theme theme = currentTheme();
    const auto paint = [&](const QRectF& box_px, const QString& word, const QColor& colour, Qt::PenStyle style) {
        const QRectF box = viewport_.toWidget(box_px);
        strokeTwice(painter, QPen(colour, 2.0, style), QPolygonF(box));
        if (!word.isEmpty()) paintTag(painter, box.topLeft(), word, colour);
    };
    const std::vector<PhotoLabel>& labels = draft_.isEmpty() ? decided_ : draft_.labels;
    for (const PhotoLabel& label : labels) {
        if (label.box) paint(toRect(*label.box), QString::fromStdString(label.label), theme.finding, Qt::SolidLine);
    }
    if (draft_.openBox) paint(toRect(*draft_.openBox), tr("which label?"), theme.accent, Qt::SolidLine);
    if (boxStart_px_) paint(QRectF(*boxStart_px_, boxEnd_px_).normalized(), {}, theme.accent, Qt::DotLine);
}

void PhotoCanvas::paintSentence(QPainter& painter) const {
    const Theme theme = currentTheme();
    const QColor colour = isError_ ? theme.finding : theme.muted;
    const QPixmap picture = iconPixmap(isError_ ? Icon::Warning : Icon::Camera, colour, 40, devicePixelRatioF());
    const QPointF middle(0.5 * width(), 0.5 * height());
    painter.drawPixmap(middle - QPointF(20.0, 70.0), picture);
    painter.setFont(fontFor(TextRole::Heading));
    painter.setPen(theme.text);
    painter.drawText(QRectF(24, middle.y() - 20, width() - 48, 24), Qt::AlignCenter, heading_);
    painter.setFont(fontFor(TextRole::Body));
    painter.setPen(theme.muted);
    const double wide = std::min(520.0, width() - 48.0);
    painter.drawText(QRectF(middle.x() - 0.5 * wide, middle.y() + 10, wide, 80),
                     Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, sentence_);
}

void PhotoCanvas::resizeEvent(QResizeEvent*) {
    if (fitted_) {
        fit();
    } else {
        setViewport(keptInSight(viewport_, imageSize(), size()), false);
    }
}

void PhotoCanvas::wheelEvent(QWheelEvent* event) {
    if (photo_.isNull()) return;
    const double factor = std::pow(1.2, event->angleDelta().y() / 120.0);
    setViewport(zoomedViewport(viewport_, factor, event->position(), imageSize(), size()), false);
    event->accept();
}

void PhotoCanvas::mousePressEvent(QMouseEvent* event) {
    if (photo_.isNull()) return QWidget::mousePressEvent(event);
    if (event->button() == Qt::LeftButton && boxDrawing_) {
        boxStart_px_ = boxEnd_px_ = viewport_.toImage(event->localPos());
    } else if (event->button() == Qt::RightButton || event->button() == Qt::MiddleButton) {
        panFrom_ = event->localPos();
        setCursor(Qt::ClosedHandCursor);
    }
}

void PhotoCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (boxStart_px_) {
        const QPointF end_px = viewport_.toImage(event->localPos());
        boxEnd_px_ = {std::clamp(end_px.x(), 0.0, imageSize().width()),
                      std::clamp(end_px.y(), 0.0, imageSize().height())};
        update();
    } else if (panFrom_) {
        pan(event->localPos() - *panFrom_);
        panFrom_ = event->localPos();
    }
}

void PhotoCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (panFrom_) {
        panFrom_.reset();
        setBoxDrawing(boxDrawing_);
        return;
    }
    if (!boxStart_px_ || event->button() != Qt::LeftButton) return;
    const PixelBox box = boxBetween(*boxStart_px_, viewport_.toImage(event->localPos()), imageSize());
    boxStart_px_.reset();
    update();
    if (box.width_px >= kSmallestBox_px && box.height_px >= kSmallestBox_px) emit boxDrawn(box);
}

void PhotoCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    boxStart_px_.reset();
    fitted_ ? scaleTo(1.0, event->localPos()) : fit();
}

}  // namespace fodscope
