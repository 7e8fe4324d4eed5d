// SPDX-License-Identifier: MIT
#include "ui/widgets/StatusChip.h"

#include <QPainter>

#include "ui/theme/Colours.h"

namespace fodscope {
namespace {

constexpr double kShape_px = 12.0;
constexpr int kGap_px = 6;

}  // namespace

void paintStatusShape(QPainter& painter, const QRectF& area, StatusKind kind, const Theme& theme) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor colour = statusColour(theme, kind);
    const double edge = std::min(area.width(), area.height());
    QRectF box(0.0, 0.0, edge, edge);
    box.moveCenter(area.center());
    const QRectF ring = box.adjusted(edge * 0.1, edge * 0.1, -edge * 0.1, -edge * 0.1);
    const double stroke = std::max(1.5, edge / 9.0);
    QPen pen(colour, stroke, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    const auto at = [&box](double x, double y) {
        return QPointF(box.left() + x * box.width(), box.top() + y * box.height());
    };
    switch (kind) {
        case StatusKind::Neutral:
            painter.setBrush(theme.muted);
            painter.setPen(Qt::NoPen);
            painter.drawEllipse(ring.adjusted(edge * 0.15, edge * 0.15, -edge * 0.15, -edge * 0.15));
            break;
        case StatusKind::ToDo:
            painter.drawEllipse(ring);
            break;
        case StatusKind::Running: {
            painter.setPen(QPen(mixed(theme.surface1, colour, 0.35), stroke));
            painter.drawEllipse(ring);
            painter.setPen(pen);
            painter.drawArc(ring, 0, 110 * 16);
            break;
        }
        case StatusKind::Attention:
            painter.setBrush(colour);
            painter.setPen(Qt::NoPen);
            painter.drawEllipse(ring);
            break;
        case StatusKind::Clear: {
            const QPointF tick[] = {at(0.12, 0.55), at(0.40, 0.80), at(0.90, 0.22)};
            painter.drawPolyline(tick, 3);
            break;
        }
        case StatusKind::Finding: {
            painter.setBrush(colour);
            painter.setPen(Qt::NoPen);
            const QPointF diamond[] = {at(0.5, 0.0), at(1.0, 0.5), at(0.5, 1.0), at(0.0, 0.5)};
            painter.drawPolygon(diamond, 4);
            break;
        }
        case StatusKind::NotObserved:
            paintHatch(painter, ring, colour);
            painter.setPen(QPen(colour, 1.0));
            painter.drawRect(ring);
            break;
    }
    painter.restore();
}

StatusChip::StatusChip(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

StatusChip::StatusChip(StatusKind kind, const QString& text, QWidget* parent) : StatusChip(parent) {
    setStatus(kind, text);
}

void StatusChip::setStatus(StatusKind kind, const QString& text) {
    if (kind_ == kind && text_ == text) return;
    kind_ = kind;
    text_ = text;
    setAccessibleName(text);
    updateGeometry();
    update();
}

void StatusChip::setDetail(const QString& detail) {
    if (detail_ == detail) return;
    detail_ = detail;
    updateGeometry();
    update();
}

QSize StatusChip::sizeHint() const {
    const QFontMetrics fonts(font());
    int width = static_cast<int>(kShape_px) + kGap_px + fonts.horizontalAdvance(text_) + 1;
    if (!detail_.isEmpty()) width += kGap_px + fonts.horizontalAdvance(detail_);
    return {width, metrics::kControlHeight_px};
}

QSize StatusChip::minimumSizeHint() const {
    return {std::min(sizeHint().width(), 64), metrics::kControlHeight_px};
}

void StatusChip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Theme theme = currentTheme();
    const QRectF shape(0.0, (height() - kShape_px) / 2.0, kShape_px, kShape_px);
    paintStatusShape(painter, shape, kind_, theme);
    const int left = static_cast<int>(kShape_px) + kGap_px;
    const QFontMetrics fonts(font());
    painter.setPen(isEnabled() ? theme.text : theme.disabled);
    const QString text = fonts.elidedText(text_, Qt::ElideRight, width() - left);
    painter.drawText(QRect(left, 0, width() - left, height()), Qt::AlignLeft | Qt::AlignVCenter, text);
    if (detail_.isEmpty()) return;
    const int start = left + fonts.horizontalAdvance(text) + kGap_px;
    painter.setPen(theme.muted);
    painter.drawText(QRect(start, 0, width() - start, height()), Qt::AlignLeft | Qt::AlignVCenter,
                     fonts.elidedText(detail_, Qt::ElideRight, width() - start));
}

}  // namespace fodscope
