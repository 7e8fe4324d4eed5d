// SPDX-License-Identifier: MIT
#include "ui/tuning/CostSurface.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/theme/Colours.h"
#include "ui/theme/Theme.h"

namespace fodscope {
namespace {

constexpr double kLeft_px = 64.0;
constexpr double kBottom_px = 44.0;
constexpr double kTop_px = 12.0;
constexpr double kRight_px = 128.0;
constexpr double kLegendBar_px = 14.0;
constexpr double kLeastTickGap_px = 56.0;

QString written(double value, const AxisStyle& axis) {
    return QLocale().toString(value * axis.displayFactor, 'f', axis.decimals);
}

QString titled(const AxisStyle& axis) {
    return axis.unit.isEmpty() ? axis.title : QStringLiteral("%1 (%2)").arg(axis.title, axis.unit);
}

/// Where a value lies among ascending ones, in steps from the first; empty outside of half a step.
std::optional<double> stepsTo(const std::vector<double>& values, double value) {
    if (values.size() < 2) return std::nullopt;
    const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
    const double steps = step > 0.0 ? (value - values.front()) / step : -1.0;
    if (steps < -0.5 || steps > static_cast<double>(values.size()) - 0.5) return std::nullopt;
    return steps;
}

std::size_t tickStride(std::size_t count, double length_px, double gap_px) {
    const auto most = std::max<std::size_t>(2, static_cast<std::size_t>(length_px / gap_px));
    return std::max<std::size_t>(1, (count + most - 1) / most);
}

}  // namespace

CostSurface::CostSurface(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Cost of the settings"));
    setToolTip(tr("Click or use the arrow keys to choose other values than the best ones"));
}

void CostSurface::setGrid(const CostGrid& grid, const CostRange& range) {
    grid_ = grid;
    range_ = range;
    image_ = costImage(grid, range);
    hovered_.reset();
    update();
}

void CostSurface::setAxes(const AxisStyle& cutoff, const AxisStyle& threshold) {
    cutoffAxis_ = cutoff;
    thresholdAxis_ = threshold;
    update();
}

void CostSurface::setBest(std::optional<CostCell> best) {
    best_ = best;
    update();
}

void CostSurface::setChosen(std::optional<CostCell> chosen) {
    chosen_ = chosen;
    update();
}

void CostSurface::setCurrent(double cutoff_m, double threshold) {
    current_ = QPointF(cutoff_m, threshold);
    update();
}

QRectF CostSurface::plotArea() const {
    return QRectF(rect()).adjusted(kLeft_px, kTop_px, -kRight_px, -kBottom_px);
}

QRectF CostSurface::cellArea(const CostCell& cell) const {
    const QRectF area = plotArea();
    const double width = area.width() / static_cast<double>(grid_.cutoffs_m.size());
    const double height = area.height() / static_cast<double>(grid_.thresholds.size());
    return {area.left() + width * static_cast<double>(cell.cutoff),
            area.bottom() - height * static_cast<double>(cell.threshold + 1), width, height};
}

QPointF CostSurface::centreOf(const CostCell& cell) const {
    return cellArea(cell).center();
}

std::optional<CostCell> CostSurface::cellAt(const QPointF& position) const {
    const QRectF area = plotArea();
    if (grid_.empty() || !area.contains(position)) return std::nullopt;
    const double x = (position.x() - area.left()) / area.width() * static_cast<double>(grid_.cutoffs_m.size());
    const double y = (area.bottom() - position.y()) / area.height() * static_cast<double>(grid_.thresholds.size());
    return CostCell{std::min(static_cast<std::size_t>(x), grid_.cutoffs_m.size() - 1),
                    std::min(static_cast<std::size_t>(y), grid_.thresholds.size() - 1)};
}

void CostSurface::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setFont(fontFor(TextRole::Caption));
    const Theme theme = currentTheme();
    const QRectF area = plotArea();
    painter.fillRect(area, theme.surface0);
    if (grid_.empty()) {
        paintHatch(painter, area, theme.line);
        painter.setPen(theme.muted);
        painter.drawText(area, Qt::AlignCenter, tr("Nothing was searched yet."));
        return;
    }
    paintHatch(painter, area, theme.muted);
    painter.drawImage(area, image_);
    paintAxes(painter, area);
    painter.setRenderHint(QPainter::Antialiasing);
    paintMarks(painter, area);
    paintLegend(painter, area);
}

void CostSurface::paintAxes(QPainter& painter, const QRectF& area) const {
    const Theme theme = currentTheme();
    const double line = QFontMetricsF(painter.font()).height();
    painter.setPen(theme.muted);
    const std::size_t acrossStep = tickStride(grid_.cutoffs_m.size(), area.width(), kLeastTickGap_px);
    for (std::size_t i = 0; i < grid_.cutoffs_m.size(); i += acrossStep) {
        const double x = cellArea({i, 0}).center().x();
        painter.drawLine(QPointF(x, area.bottom()), QPointF(x, area.bottom() + 4.0));
        painter.drawText(QRectF(x - 30.0, area.bottom() + 4.0, 60.0, line), Qt::AlignHCenter | Qt::AlignTop,
                         written(grid_.cutoffs_m[i], cutoffAxis_));
    }
    const std::size_t upStep = tickStride(grid_.thresholds.size(), area.height(), 2.0 * line);
    for (std::size_t i = 0; i < grid_.thresholds.size(); i += upStep) {
        const double y = cellArea({0, i}).center().y();
        painter.drawLine(QPointF(area.left() - 4.0, y), QPointF(area.left(), y));
        painter.drawText(QRectF(20.0, y - line / 2.0, area.left() - 26.0, line), Qt::AlignRight | Qt::AlignVCenter,
                         written(grid_.thresholds[i], thresholdAxis_));
    }
    painter.setPen(theme.text);
    painter.drawText(QRectF(area.left(), area.bottom() + 4.0 + line, area.width(), line + 4.0), Qt::AlignCenter,
                     titled(cutoffAxis_));
    painter.save();
    painter.translate(line / 2.0 + 2.0, area.center().y());
    painter.rotate(-90.0);
    painter.drawText(QRectF(-area.height() / 2.0, -line / 2.0, area.height(), line), Qt::AlignCenter,
                     titled(thresholdAxis_));
    painter.restore();
}

void CostSurface::paintMarks(QPainter& painter, const QRectF& area) const {
    const Theme theme = currentTheme();
    painter.setBrush(Qt::NoBrush);
    // White on black shows on every colour of the scale.
    const auto twice = [&](double width, const QColor& colour, const auto& draw) {
        painter.setPen(QPen(Qt::black, width + 2.0));
        draw();
        painter.setPen(QPen(colour, width));
        draw();
    };
    if (current_) {
        const auto x = stepsTo(grid_.cutoffs_m, current_->x());
        const auto y = stepsTo(grid_.thresholds, current_->y());
        if (x && y) {
            const QPointF at(area.left() + (*x + 0.5) * area.width() / static_cast<double>(grid_.cutoffs_m.size()),
                             area.bottom() - (*y + 0.5) * area.height() / static_cast<double>(grid_.thresholds.size()));
            twice(2.0, Qt::white, [&] {
                painter.drawLine(at + QPointF(-5, -5), at + QPointF(5, 5));
                painter.drawLine(at + QPointF(-5, 5), at + QPointF(5, -5));
            });
        }
    }
    if (best_) {
        const QPointF at = centreOf(*best_);
        twice(2.0, Qt::white, [&] { painter.drawEllipse(at, 7.0, 7.0); });
    }
    if (hovered_) twice(1.0, Qt::white, [&] { painter.drawRect(cellArea(*hovered_)); });
    if (chosen_) twice(2.0, theme.accent, [&] { painter.drawRect(cellArea(*chosen_)); });
}

void CostSurface::paintLegend(QPainter& painter, const QRectF& area) const {
    const Theme theme = currentTheme();
    const double line = QFontMetricsF(painter.font()).height();
    const double left = area.right() + 16.0;
    painter.setPen(theme.text);
    painter.drawText(QRectF(left, area.top(), kRight_px - 16.0, line), Qt::AlignLeft | Qt::AlignTop, tr("cost (m)"));
    const QRectF bar(left, area.top() + line + 6.0, kLegendBar_px, area.height() - 3.0 * line - 30.0);
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (int row = 0; row < static_cast<int>(bar.height()); ++row)
        painter.fillRect(QRectF(bar.left(), bar.top() + row, bar.width(), 1.0),
                         viridis(1.0 - (row + 0.5) / bar.height()));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(theme.muted);
    const auto write = [&](double y, const QString& text) {
        painter.drawText(QRectF(bar.right() + 6.0, y - line / 2.0, kRight_px, line), Qt::AlignLeft | Qt::AlignVCenter,
                         text);
    };
    write(bar.top() + line / 2.0, QStringLiteral("≥ %1").arg(QLocale().toString(range_.most_m, 'f', 2)));
    write(bar.center().y(), QLocale().toString(0.5 * (range_.least_m + range_.most_m), 'f', 2));
    write(bar.bottom() - line / 2.0, QLocale().toString(range_.least_m, 'f', 2));
    painter.setBrush(Qt::NoBrush);
    const auto key = [&](double y, const QString& text, const auto& draw) {
        painter.setPen(QPen(theme.text, 2.0));
        draw(QPointF(left + kLegendBar_px / 2.0, y));
        painter.setPen(theme.muted);
        write(y, text);
    };
    key(bar.bottom() + 14.0 + line / 2.0, tr("best"), [&](const QPointF& at) { painter.drawEllipse(at, 5.0, 5.0); });
    key(bar.bottom() + 20.0 + 1.5 * line, tr("in effect"), [&](const QPointF& at) {
        painter.drawLine(at + QPointF(-4, -4), at + QPointF(4, 4));
        painter.drawLine(at + QPointF(-4, 4), at + QPointF(4, -4));
    });
    if (!hasFocus()) return;
    painter.setPen(QPen(theme.accent, 1.0));
    painter.drawRect(area.adjusted(-1.0, -1.0, 1.0, 1.0));
}

void CostSurface::hover(std::optional<CostCell> cell) {
    if (cell == hovered_) return;
    hovered_ = cell;
    update();
    emit cellHovered(cell);
}

void CostSurface::mousePressEvent(QMouseEvent* event) {
    const auto cell = cellAt(event->localPos());
    if (event->button() != Qt::LeftButton || !cell) return;
    setChosen(cell);
    emit cellChosen(*cell);
}

void CostSurface::mouseMoveEvent(QMouseEvent* event) {
    hover(cellAt(event->localPos()));
}

void CostSurface::leaveEvent(QEvent*) {
    hover(std::nullopt);
}

void CostSurface::keyPressEvent(QKeyEvent* event) {
    const auto start = chosen_ ? chosen_ : best_;
    if (!start) return QWidget::keyPressEvent(event);
    CostCell cell = *start;
    switch (event->key()) {
        case Qt::Key_Left:
            cell.cutoff -= cell.cutoff > 0 ? 1 : 0;
            break;
        case Qt::Key_Right:
            cell.cutoff = std::min(cell.cutoff + 1, grid_.cutoffs_m.size() - 1);
            break;
        case Qt::Key_Down:
            cell.threshold -= cell.threshold > 0 ? 1 : 0;
            break;
        case Qt::Key_Up:
            cell.threshold = std::min(cell.threshold + 1, grid_.thresholds.size() - 1);
            break;
        case Qt::Key_Home:
            if (best_) cell = *best_;
            break;
        default:
            return QWidget::keyPressEvent(event);
    }
    setChosen(cell);
    emit cellChosen(cell);
}

}  // namespace fodscope
