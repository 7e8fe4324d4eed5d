// SPDX-License-Identifier: MIT
#include "ui/widgets/ThresholdHistogram.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/theme/Colours.h"
#include "ui/theme/Theme.h"

namespace fodscope {
namespace {

constexpr int kBins = 160;
constexpr double kTopRoom_px = 26.0;
constexpr double kBottomRoom_px = 22.0;
constexpr double kSideRoom_px = 10.0;

/// Counts from 1 to millions must all be seen, hence the logarithm; an empty bin has no bar at all.
double barShare(std::size_t count, std::size_t largest) {
    if (count == 0) return 0.0;
    return (std::log10(static_cast<double>(count)) + 0.35) / (std::log10(static_cast<double>(largest)) + 0.35);
}

/// @return 1, 2 or 5 times a power of ten, so that about `wanted` ticks fit
double niceStep(double span, int wanted) {
    const double raw = span / std::max(1, wanted);
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= raw) return factor * power;
    }
    return 10.0 * power;
}

}  // namespace

ThresholdHistogram::ThresholdHistogram(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    setAccessibleName(tr("Threshold"));
    setToolTip(tr("Drag the line to set the threshold. Arrow keys: one step, with Shift a coarse one."));
}

void ThresholdHistogram::setValues(std::span<const double> values) {
    histogram_ = Histogram(values, kBins);
    update();
}

void ThresholdHistogram::clear() {
    histogram_ = Histogram();
    update();
}

void ThresholdHistogram::setDisplay(const QString& unit, double displayFactor, int decimals) {
    unit_ = unit;
    displayFactor_ = displayFactor;
    decimals_ = decimals;
    update();
}

void ThresholdHistogram::setSteps(double fine, double coarse) {
    fineStep_ = fine;
    coarseStep_ = coarse;
}

void ThresholdHistogram::setThreshold(double threshold) {
    if (threshold_ == threshold) return;
    threshold_ = threshold;
    update();
}

void ThresholdHistogram::stepThreshold(int steps, bool coarse) {
    const double step = coarse ? coarseStep_ : fineStep_;
    // Onto the grid of steps, so that a number read aloud can be reached again.
    const double before = threshold_;
    moveThreshold((std::round(threshold_ / step) + steps) * step);
    if (threshold_ != before) emit thresholdReleased(threshold_);
}

std::size_t ThresholdHistogram::countAbove() const {
    return histogram_.countAbove(threshold_);
}

double ThresholdHistogram::shareAbove() const {
    return histogram_.empty() ? 0.0 : static_cast<double>(countAbove()) / static_cast<double>(histogram_.total());
}

QSize ThresholdHistogram::sizeHint() const {
    return {260, 140};
}

QSize ThresholdHistogram::minimumSizeHint() const {
    return {160, 96};
}

QRectF ThresholdHistogram::plotArea() const {
    return QRectF(rect()).adjusted(kSideRoom_px, kTopRoom_px, -kSideRoom_px, -kBottomRoom_px);
}

double ThresholdHistogram::xOf(double value) const {
    const QRectF area = plotArea();
    const double share = (value - histogram_.minimum()) / (histogram_.maximum() - histogram_.minimum());
    return area.left() + std::clamp(share, 0.0, 1.0) * area.width();
}

double ThresholdHistogram::valueAt(double x) const {
    const QRectF area = plotArea();
    const double share = std::clamp((x - area.left()) / area.width(), 0.0, 1.0);
    const double value = histogram_.minimum() + share * (histogram_.maximum() - histogram_.minimum());
    return fineStep_ > 0.0 ? std::round(value / fineStep_) * fineStep_ : value;
}

void ThresholdHistogram::moveThreshold(double value) {
    const double top = histogram_.empty() ? std::max(threshold_, 1.0) : std::max(histogram_.largest(), threshold_);
    const double clamped = std::clamp(value, histogram_.minimum(), top);
    if (clamped == threshold_) return;
    threshold_ = clamped;
    update();
    emit thresholdDragged(threshold_);
}

QString ThresholdHistogram::text(double value) const {
    const QString number = QLocale().toString(value * displayFactor_, 'f', decimals_);
    return unit_.isEmpty() ? number : number + QChar(0x202F) + unit_;
}

void ThresholdHistogram::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme theme = currentTheme();
    const QRectF area = plotArea();
    if (histogram_.empty()) {
        painter.setPen(theme.muted);
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("No values yet"));
        return;
    }
    paintBars(painter, area);
    paintAxis(painter, area);
    paintThreshold(painter, area);
    if (hasFocus()) {
        painter.setPen(QPen(theme.accent, 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), metrics::kRadius_px,
                                metrics::kRadius_px);
    }
}

void ThresholdHistogram::paintBars(QPainter& painter, const QRectF& area) const {
    const Theme theme = currentTheme();
    const std::size_t largest = *std::max_element(histogram_.counts().begin(), histogram_.counts().end());
    const double width = area.width() / static_cast<double>(histogram_.counts().size());
    const double thresholdX = xOf(threshold_);
    const QColor below = mixed(theme.surface2, theme.muted, 0.45);
    const QColor above = theme.attention;
    painter.setPen(Qt::NoPen);
    painter.setRenderHint(QPainter::Antialiasing, false);
    const auto paintAll = [&](const QColor& colour) {
        for (std::size_t bin = 0; bin < histogram_.counts().size(); ++bin) {
            const double height = barShare(histogram_.counts()[bin], largest) * area.height();
            if (height <= 0.0) continue;
            const double left = area.left() + static_cast<double>(bin) * width;
            painter.fillRect(QRectF(left, area.bottom() - height, width + 0.3, height), colour);
        }
    };
    painter.save();
    painter.setClipRect(QRectF(area.left(), area.top(), thresholdX - area.left(), area.height()));
    paintAll(below);
    painter.setClipRect(QRectF(thresholdX, area.top(), area.right() + 1.0 - thresholdX, area.height()));
    paintAll(above);
    painter.restore();
    painter.setRenderHint(QPainter::Antialiasing, true);
}

void ThresholdHistogram::paintAxis(QPainter& painter, const QRectF& area) const {
    const Theme theme = currentTheme();
    painter.setPen(QPen(theme.line, 1.0));
    painter.drawLine(QPointF(area.left(), area.bottom() + 0.5), QPointF(area.right(), area.bottom() + 0.5));
    painter.setFont(fontFor(TextRole::Caption));
    const double span = histogram_.maximum() - histogram_.minimum();
    const double step = niceStep(span, std::max(2, static_cast<int>(area.width() / 56.0)));
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step * displayFactor_) - 1e-9)), 0, 6);
    for (double value = std::ceil(histogram_.minimum() / step) * step; value <= histogram_.maximum() + 1e-9 * span;
         value += step) {
        const double x = xOf(value);
        painter.setPen(QPen(theme.line, 1.0));
        painter.drawLine(QPointF(x, area.bottom()), QPointF(x, area.bottom() + 3.0));
        painter.setPen(theme.muted);
        const QRectF box(x - 30.0, area.bottom() + 4.0, 60.0, kBottomRoom_px - 4.0);
        const QString label = QLocale().toString(value * displayFactor_, 'f', decimals);
        const double half = painter.fontMetrics().horizontalAdvance(label) / 2.0;
        const double shift = std::max(0.0, half - x) - std::max(0.0, x + half - width());
        painter.drawText(box.translated(shift, 0.0), Qt::AlignHCenter | Qt::AlignTop, label);
    }
}

void ThresholdHistogram::paintThreshold(QPainter& painter, const QRectF& area) const {
    const Theme theme = currentTheme();
    const double x = std::round(xOf(threshold_)) + 0.5;
    const bool active = dragging_ || hovered_ || hasFocus();
    painter.setPen(QPen(active ? theme.accent : theme.text, active ? 2.0 : 1.5));
    painter.drawLine(QPointF(x, area.top() - 2.0), QPointF(x, area.bottom()));
    painter.setBrush(active ? theme.accent : theme.text);
    painter.setPen(Qt::NoPen);
    const std::array<QPointF, 3> handle = {QPointF(x - 5.0, area.top() - 7.0), QPointF(x + 5.0, area.top() - 7.0),
                                           QPointF(x, area.top())};
    painter.drawPolygon(handle.data(), static_cast<int>(handle.size()));

    const double share = shareAbove() * 100.0;
    const QString above = tr("%1 above  ·  %2 %")
                              .arg(QLocale().toString(static_cast<qulonglong>(countAbove())))
                              .arg(QLocale().toString(share, 'f', share < 10.0 ? 2 : 1));
    painter.setFont(fontFor(TextRole::Emphasis));
    const double valueWidth = painter.fontMetrics().horizontalAdvance(text(threshold_));
    painter.setPen(theme.text);
    const QRectF head(area.left(), 0.0, area.width(), kTopRoom_px - 8.0);
    painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter, text(threshold_));
    painter.setFont(fontFor(TextRole::Caption));
    painter.setPen(theme.muted);
    const QString shown =
        painter.fontMetrics().elidedText(above, Qt::ElideRight, static_cast<int>(head.width() - valueWidth - 12.0));
    painter.drawText(head, Qt::AlignRight | Qt::AlignVCenter, shown);
}

void ThresholdHistogram::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || histogram_.empty()) return;
    dragging_ = true;
    moveThreshold(valueAt(event->localPos().x()));
    update();
}

void ThresholdHistogram::mouseMoveEvent(QMouseEvent* event) {
    const bool near = std::abs(event->localPos().x() - xOf(threshold_)) < 8.0;
    if (near != hovered_) {
        hovered_ = near;
        setCursor(near ? Qt::SizeHorCursor : Qt::ArrowCursor);
        update();
    }
    if (dragging_) moveThreshold(valueAt(event->localPos().x()));
}

void ThresholdHistogram::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !dragging_) return;
    dragging_ = false;
    update();
    emit thresholdReleased(threshold_);
}

void ThresholdHistogram::keyPressEvent(QKeyEvent* event) {
    const bool coarse = event->modifiers().testFlag(Qt::ShiftModifier);
    switch (event->key()) {
        case Qt::Key_Left:
        case Qt::Key_Down:
            stepThreshold(-1, coarse);
            return;
        case Qt::Key_Right:
        case Qt::Key_Up:
            stepThreshold(1, coarse);
            return;
        case Qt::Key_PageDown:
            stepThreshold(-1, true);
            return;
        case Qt::Key_PageUp:
            stepThreshold(1, true);
            return;
        case Qt::Key_Home:
        case Qt::Key_End: {
            const double before = threshold_;
            moveThreshold(event->key() == Qt::Key_Home ? histogram_.minimum() : histogram_.maximum());
            if (threshold_ != before) emit thresholdReleased(threshold_);
            return;
        }
        default:
            QWidget::keyPressEvent(event);
    }
}

void ThresholdHistogram::leaveEvent(QEvent*) {
    hovered_ = false;
    update();
}

}  // namespace fodscope
