// SPDX-License-Identifier: MIT
#include "ui/tuning/RecallPlot.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "core/evaluation/PhotoSearch.h"
#include "ui/theme/Theme.h"

namespace fodscope {
namespace {

constexpr double kLeft_px = 64.0;
constexpr double kBottom_px = 44.0;
constexpr double kTop_px = 32.0;
constexpr double kRight_px = 150.0;
constexpr double kDot_px = 1.5;
constexpr double kCurveDot_px = 4.0;
/// Numbers of photos are written where they do not cover each other.
constexpr double kLeastNumberGap_px = 30.0;

void paintCross(QPainter& painter, const QPointF& at, double arm_px) {
    painter.drawLine(at + QPointF(-arm_px, -arm_px), at + QPointF(arm_px, arm_px));
    painter.drawLine(at + QPointF(-arm_px, arm_px), at + QPointF(arm_px, -arm_px));
}

QRectF squareAround(const QPointF& at, double half_px) {
    return {at.x() - half_px, at.y() - half_px, 2.0 * half_px, 2.0 * half_px};
}

}  // namespace

std::optional<RecallPoint> recallPointOf(const PhotoSearchResult& result, const PhotoOutcome& outcome) {
    const std::optional<double> precision = outcome.precision();
    if (!precision) return std::nullopt;
    return RecallPoint{result.recallOf(outcome), *precision, outcome.photos};
}

RecallPoints recallPointsOf(const PhotoSearchResult& result) {
    RecallPoints points;
    points.wantedRecall = result.settings.recall;
    for (const std::optional<PhotoOutcome>& outcome : result.outcomes) {
        if (!outcome) continue;
        if (const auto point = recallPointOf(result, *outcome)) points.all.push_back(*point);
    }
    const auto place = [](const RecallPoint& point) { return std::pair(point.recall, point.precision); };
    std::ranges::sort(points.all, {}, place);
    const auto same = std::ranges::unique(points.all, {}, place);
    points.all.erase(same.begin(), same.end());
    for (const PhotoChoice& choice : result.curve) {
        // Without photos there is neither recall nor precision: the curve begins at its next point.
        const auto point = recallPointOf(result, choice.outcome);
        points.curve.push_back(point.value_or(RecallPoint{result.recallOf(choice.outcome), std::nan(""), 0}));
    }
    return points;
}

RecallPlot::RecallPlot(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Precision of the photos over the recall of FOD"));
    setToolTip(tr("Click or use the arrow keys to choose another point of the curve"));
}

void RecallPlot::setPoints(const RecallPoints& points) {
    points_ = points;
    hovered_.reset();
    update();
}

void RecallPlot::setBest(std::optional<std::size_t> best) {
    best_ = best;
    update();
}

void RecallPlot::setChosen(std::optional<std::size_t> chosen) {
    chosen_ = chosen;
    update();
}

void RecallPlot::setInEffect(const std::optional<RecallPoint>& point) {
    inEffect_ = point;
    update();
}

QRectF RecallPlot::plotArea() const {
    return QRectF(rect()).adjusted(kLeft_px, kTop_px, -kRight_px, -kBottom_px);
}

QPointF RecallPlot::placeOf(const RecallPoint& point) const {
    const QRectF area = plotArea();
    const double precision = std::isnan(point.precision) ? 1.0 : point.precision;
    return {area.left() + area.width() * point.recall, area.bottom() - area.height() * precision};
}

std::optional<std::size_t> RecallPlot::pointAt(const QPointF& position) const {
    if (!plotArea().adjusted(-12.0, -12.0, 12.0, 12.0).contains(position)) return std::nullopt;
    std::optional<std::size_t> nearest;
    double least_px = 0.0;
    for (std::size_t i = 0; i < points_.curve.size(); ++i) {
        const double distance_px = std::abs(placeOf(points_.curve[i]).x() - position.x());
        if (nearest && distance_px >= least_px) continue;
        nearest = i;
        least_px = distance_px;
    }
    return nearest;
}

void RecallPlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setFont(fontFor(TextRole::Caption));
    const Theme theme = currentTheme();
    const QRectF area = plotArea();
    painter.fillRect(area, theme.surface0);
    if (points_.curve.empty()) {
        paintHatch(painter, area, theme.line);
        painter.setPen(theme.muted);
        painter.drawText(area, Qt::AlignCenter, tr("Nothing was searched yet."));
        return;
    }
    paintAxes(painter, area);
    painter.setRenderHint(QPainter::Antialiasing);
    paintCurve(painter);
    paintMarks(painter, area);
    paintLegend(painter, area);
}

void RecallPlot::paintAxes(QPainter& painter, const QRectF& area) const {
    const Theme theme = currentTheme();
    const double line = QFontMetricsF(painter.font()).height();
    for (int tick = 0; tick <= 5; ++tick) {
        const double share = 0.2 * tick;
        const QString text = tr("%1 %").arg(20 * tick);
        const double x = area.left() + share * area.width();
        const double y = area.bottom() - share * area.height();
        painter.setPen(theme.line);
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        painter.setPen(theme.muted);
        painter.drawText(QRectF(x - 30.0, area.bottom() + 4.0, 60.0, line), Qt::AlignHCenter | Qt::AlignTop, text);
        painter.drawText(QRectF(20.0, y - line / 2.0, area.left() - 26.0, line), Qt::AlignRight | Qt::AlignVCenter,
                         text);
    }
    painter.setPen(theme.text);
    painter.drawText(QRectF(area.left(), area.bottom() + 4.0 + line, area.width(), line + 4.0), Qt::AlignCenter,
                     tr("recall: FOD on a photo"));
    painter.save();
    painter.translate(line / 2.0 + 2.0, area.center().y());
    painter.rotate(-90.0);
    painter.drawText(QRectF(-area.height() / 2.0, -line / 2.0, area.height(), line), Qt::AlignCenter,
                     tr("precision: photos with FOD"));
    painter.restore();
}

void RecallPlot::paintCurve(QPainter& painter) const {
    const Theme theme = currentTheme();
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.muted);
    for (const RecallPoint& point : points_.all)
        painter.drawEllipse(placeOf(point), kDot_px, kDot_px);
    QPolygonF way;
    for (const RecallPoint& point : points_.curve)
        if (!std::isnan(point.precision)) way << placeOf(point);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.text, 1.5));
    painter.drawPolyline(way);
    painter.setBrush(theme.surface0);
    for (const QPointF& at : way)
        painter.drawEllipse(at, kCurveDot_px, kCurveDot_px);
    // From the right, where the most photos are.
    double nextFree = plotArea().right() + kLeastNumberGap_px;
    painter.setPen(theme.text);
    for (std::size_t i = points_.curve.size(); i-- > 0;) {
        const RecallPoint& point = points_.curve[i];
        const QPointF at = placeOf(point);
        if (std::isnan(point.precision) || nextFree - at.x() < kLeastNumberGap_px) continue;
        painter.drawText(QRectF(at.x() - 30.0, at.y() - 26.0, 60.0, 16.0), Qt::AlignCenter,
                         QLocale().toString(static_cast<qulonglong>(point.photos)));
        nextFree = at.x();
    }
}

void RecallPlot::paintMarks(QPainter& painter, const QRectF& area) const {
    const Theme theme = currentTheme();
    painter.setBrush(Qt::NoBrush);
    const double wanted = area.left() + points_.wantedRecall * area.width();
    painter.setPen(QPen(theme.muted, 1.0, Qt::DashLine));
    painter.drawLine(QPointF(wanted, area.top()), QPointF(wanted, area.bottom()));
    if (inEffect_) {
        painter.setPen(QPen(theme.surface0, 5.0));
        paintCross(painter, placeOf(*inEffect_), 6.0);
        painter.setPen(QPen(theme.text, 2.5));
        paintCross(painter, placeOf(*inEffect_), 6.0);
    }
    if (best_) {
        painter.setPen(QPen(theme.text, 2.0));
        painter.drawEllipse(placeOf(points_.curve[*best_]), 8.0, 8.0);
    }
    if (hovered_) {
        painter.setPen(QPen(theme.text, 1.0));
        painter.drawRect(squareAround(placeOf(points_.curve[*hovered_]), 11.0));
    }
    if (chosen_) {
        painter.setPen(QPen(theme.accent, 2.0));
        painter.drawRect(squareAround(placeOf(points_.curve[*chosen_]), 11.0));
    }
    if (!hasFocus()) return;
    painter.setPen(QPen(theme.accent, 1.0));
    painter.drawRect(area.adjusted(-1.0, -1.0, 1.0, 1.0));
}

void RecallPlot::paintLegend(QPainter& painter, const QRectF& area) const {
    const Theme theme = currentTheme();
    const double line = QFontMetricsF(painter.font()).height() + 6.0;
    const double left = area.right() + 24.0;
    double y = area.top() + line / 2.0;
    const auto key = [&](const QString& text, const auto& draw) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(theme.text, 2.0));
        draw(QPointF(left, y));
        painter.setPen(theme.muted);
        painter.drawText(QRectF(left + 14.0, y - line / 2.0, kRight_px - 40.0, line), Qt::AlignLeft | Qt::AlignVCenter,
                         text);
        y += line;
    };
    key(tr("fewest photos"), [&](const QPointF& at) {
        painter.setPen(QPen(theme.text, 1.5));
        painter.drawLine(at - QPointF(8.0, 0.0), at + QPointF(8.0, 0.0));
        painter.setBrush(theme.surface1);
        painter.drawEllipse(at, kCurveDot_px, kCurveDot_px);
    });
    key(tr("other settings"), [&](const QPointF& at) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme.muted);
        painter.drawEllipse(at, kDot_px, kDot_px);
    });
    key(tr("best"), [&](const QPointF& at) { painter.drawEllipse(at, 6.0, 6.0); });
    key(inEffect_ ? tr("in effect") : tr("in effect: not known"),
        [&](const QPointF& at) { paintCross(painter, at, 4.0); });
    key(tr("wanted recall"), [&](const QPointF& at) {
        painter.setPen(QPen(theme.muted, 1.0, Qt::DashLine));
        painter.drawLine(at - QPointF(0.0, 7.0), at + QPointF(0.0, 7.0));
    });
    painter.setPen(theme.muted);
    painter.drawText(QRectF(left - 8.0, y, kRight_px - 16.0, 4.0 * line), Qt::AlignLeft | Qt::TextWordWrap,
                     tr("Numbers: photos over all trials"));
}

void RecallPlot::hover(std::optional<std::size_t> point) {
    if (point == hovered_) return;
    hovered_ = point;
    update();
    emit pointHovered(point);
}

void RecallPlot::mousePressEvent(QMouseEvent* event) {
    const auto point = pointAt(event->localPos());
    if (event->button() != Qt::LeftButton || !point) return;
    setChosen(point);
    emit pointChosen(*point);
}

void RecallPlot::mouseMoveEvent(QMouseEvent* event) {
    hover(pointAt(event->localPos()));
}

void RecallPlot::leaveEvent(QEvent*) {
    hover(std::nullopt);
}

void RecallPlot::keyPressEvent(QKeyEvent* event) {
    const auto start = chosen_ ? chosen_ : best_;
    if (points_.curve.empty()) return QWidget::keyPressEvent(event);
    std::size_t point = start.value_or(points_.curve.size() - 1);
    switch (event->key()) {
        case Qt::Key_Left:
            point -= point > 0 ? 1 : 0;
            break;
        case Qt::Key_Right:
            point = std::min(point + 1, points_.curve.size() - 1);
            break;
        case Qt::Key_Home:
            point = best_.value_or(point);
            break;
        default:
            return QWidget::keyPressEvent(event);
    }
    setChosen(point);
    emit pointChosen(point);
}

}  // namespace fodscope
