// SPDX-License-Identifier: MIT
#include "ui/view3d/ViewOverlay.h"

#include <QLinearGradient>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/theme/Colours.h"
#include "ui/theme/Icons.h"
#include "ui/view3d/ScalarColours.h"
#include "ui/widgets/StatusChip.h"

namespace fodscope {
namespace {

constexpr double kMargin_px = 12.0;
constexpr double kLabelHeight_px = 22.0;
constexpr double kLabelPadding_px = 7.0;
constexpr double kSwatch_px = 8.0;
constexpr double kLegendBar_px = 12.0;
constexpr double kLegendHeight_px = 190.0;
constexpr double kAxesEdge_px = 76.0;
constexpr double kLongestScale_px = 160.0;
const QChar kThinSpace(0x202F);

QColor glass(const Theme& theme) {
    QColor ground = theme.surface1;
    ground.setAlphaF(0.90);
    return ground;
}

QString withUnit(double value, const ScalarStyle& style) {
    const QString number = QLocale().toString(value * style.displayFactor, 'f', style.decimals);
    return style.unit.isEmpty() ? number : number + kThinSpace + style.unit;
}

QString unknownWord(const ScalarStyle& style) {
    return style.unknownWord.isEmpty() ? ViewOverlay::tr("not known") : style.unknownWord;
}

void paintPanel(QPainter& painter, const QRectF& area, const Theme& theme, const QColor& edge) {
    painter.setBrush(glass(theme));
    painter.setPen(QPen(edge, 1.0));
    painter.drawRoundedRect(area, 4.0, 4.0);
}

/// @return 1, 2 or 5 times a power of ten, not more than `most`
double roundLength(double most) {
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (const double factor : {5.0, 2.0, 1.0}) {
        if (factor * power <= most) return factor * power;
    }
    return power;
}

QString lengthText(double length_m) {
    if (length_m >= 1.0) return QLocale().toString(length_m, 'f', 0) + kThinSpace + QStringLiteral("m");
    if (length_m >= 0.01) return QLocale().toString(length_m * 100.0, 'f', 0) + kThinSpace + QStringLiteral("cm");
    return QLocale().toString(length_m * 1000.0, 'f', 0) + kThinSpace + QStringLiteral("mm");
}

}  // namespace

ViewOverlay::ViewOverlay(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
}

void ViewOverlay::setLabels(std::vector<Label> labels) {
    labels_ = std::move(labels);
    place();
    update();
}

void ViewOverlay::setLegend(std::optional<Legend> legend) {
    legend_ = std::move(legend);
    update();
}

void ViewOverlay::setCamera(const OrbitCamera& camera) {
    camera_ = camera;
    update();
}

void ViewOverlay::setMeasurement(const Measurement& measurement) {
    measurement_ = measurement;
    update();
}

void ViewOverlay::setHint(const QPointF& position, const QString& text) {
    if (hint_.isEmpty() && text.isEmpty()) return;
    hintPosition_ = position;
    hint_ = text;
    update();
}

void ViewOverlay::setMessage(const QString& message) {
    if (message_ == message) return;
    message_ = message;
    update();
}

void ViewOverlay::setToolBarArea(const QRectF& area) {
    if (toolBar_ == area) return;
    toolBar_ = area;
    place();
}

const ViewOverlay::Label* ViewOverlay::labelAt(const QPointF& position) const {
    for (std::size_t i = 0; i < places_.size(); ++i) {
        if (places_[i].placed && places_[i].box.adjusted(-2.0, -2.0, 2.0, 2.0).contains(position)) return &labels_[i];
    }
    return nullptr;
}

void ViewOverlay::place() {
    QFontMetricsF fonts(fontFor(TextRole::Caption));
    std::vector<LabelRequest> requests;
    requests.reserve(labels_.size());
    for (const Label& label : labels_) {
        const double width = fonts.horizontalAdvance(label.id) + 2.0 * kLabelPadding_px + kSwatch_px + 5.0;
        const int priority = label.selected ? 2 : label.kind == LabelKind::Candidate ? 1 : 0;
        requests.push_back({label.anchor, QSizeF(width, kLabelHeight_px), priority});
    }
    std::vector<QRectF> blocked = {toolBar_};
    if (legend_) blocked.push_back(legendArea());
    places_ = placeLabels(requests, QRectF(rect()).adjusted(4.0, 4.0, -4.0, -4.0), blocked);
}

void ViewOverlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(fontFor(TextRole::Caption));
    if (!message_.isEmpty()) {
        paintMessage(painter);
        return;
    }
    paintCorner(painter);
    paintLabels(painter);
    if (legend_) paintLegend(painter);
    paintMeasurement(painter);
    if (!hint_.isEmpty()) paintHint(painter);
}

void ViewOverlay::resizeEvent(QResizeEvent*) {
    place();
}

void ViewOverlay::paintLabels(QPainter& painter) const {
    const Theme theme = currentTheme();
    for (std::size_t i = 0; i < labels_.size(); ++i) {
        if (!places_[i].placed) continue;
        const Label& label = labels_[i];
        const QRectF& box = places_[i].box;
        const QPointF end(std::clamp(label.anchor.x(), box.left() + 6.0, box.right() - 6.0),
                          label.anchor.y() > box.center().y() ? box.bottom() : box.top());
        painter.setPen(QPen(label.selected ? theme.accent : mixed(theme.muted, theme.text, 0.3), 1.0));
        painter.drawLine(label.anchor, end);
        painter.setBrush(label.selected ? theme.accent : theme.text);
        painter.setPen(Qt::NoPen);
        painter.drawEllipse(label.anchor, 2.0, 2.0);
    }
    for (std::size_t i = 0; i < labels_.size(); ++i) {
        if (!places_[i].placed) continue;
        const Label& label = labels_[i];
        const QRectF& box = places_[i].box;
        paintPanel(painter, box, theme, label.selected ? theme.accent : theme.line);
        if (label.selected) {
            painter.setPen(QPen(theme.accent, 2.0));
            painter.setBrush(Qt::NoBrush);
            painter.drawRoundedRect(box, 4.0, 4.0);
        }
        const QRectF swatch(box.left() + kLabelPadding_px, box.center().y() - kSwatch_px / 2.0, kSwatch_px, kSwatch_px);
        if (label.kind == LabelKind::Candidate) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(label.colour);
            painter.drawRoundedRect(swatch, 2.0, 2.0);
        } else {
            paintStatusShape(painter, swatch, label.state, theme);
        }
        painter.setPen(theme.text);
        painter.drawText(box.adjusted(kLabelPadding_px + kSwatch_px + 5.0, 0.0, 0.0, 0.0),
                         Qt::AlignLeft | Qt::AlignVCenter, label.id);
    }
}

QRectF ViewOverlay::legendArea() const {
    if (!legend_) return {};
    const QFontMetricsF fonts(fontFor(TextRole::Caption));
    const ScalarStyle& style = legend_->style;
    double numbers = std::max(fonts.horizontalAdvance(withUnit(style.maximum, style)) + 10.0,
                              fonts.horizontalAdvance(withUnit(style.minimum, style)) + 10.0);
    if (style.threshold) numbers = std::max(numbers, fonts.horizontalAdvance(withUnit(*style.threshold, style)) + 8.0);
    if (legend_->anyUnknown) numbers = std::max(numbers, fonts.horizontalAdvance(unknownWord(style)));
    const double width =
        std::max(kLegendBar_px + 10.0 + numbers, std::min(180.0, fonts.horizontalAdvance(style.title)));
    const double height =
        std::min(kLegendHeight_px, std::max(80.0, this->height() * 0.45)) + 36.0 + (legend_->anyUnknown ? 24.0 : 0.0);
    return QRectF(this->width() - kMargin_px - width - 20.0, kMargin_px, width + 20.0, height);
}

void ViewOverlay::paintLegend(QPainter& painter) const {
    const Theme theme = currentTheme();
    const ScalarStyle& style = legend_->style;
    const QRectF area = legendArea();
    paintPanel(painter, area, theme, theme.line);
    const QFontMetricsF fonts(painter.font());
    const QRectF inside = area.adjusted(10.0, 8.0, -10.0, -10.0);
    painter.setPen(theme.text);
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignTop,
                     fonts.elidedText(style.title, Qt::ElideRight, inside.width()));

    const double top = inside.top() + fonts.height() + 8.0;
    const double bottom = inside.bottom() - (legend_->anyUnknown ? 24.0 : 0.0);
    const QRectF bar(inside.left(), top, kLegendBar_px, bottom - top);
    const double span = style.maximum - style.minimum;
    const auto yOf = [&](double value) {
        const double share = span > 0.0 ? std::clamp((value - style.minimum) / span, 0.0, 1.0) : 0.0;
        return bar.bottom() - share * bar.height();
    };
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (int row = 0; row < static_cast<int>(bar.height()); ++row) {
        const double t = 1.0 - (row + 0.5) / bar.height();
        const double value = style.minimum + t * span;
        const bool above = !style.threshold || value > *style.threshold;
        const QColor full = scaleColour(t, style.scale);
        painter.fillRect(QRectF(bar.left(), bar.top() + row, bar.width(), 1.0),
                         above ? full : mixed(full, theme.surface2, 0.55));
    }
    painter.setRenderHint(QPainter::Antialiasing, true);

    const double left = bar.right() + 8.0;
    const double half = fonts.height() / 2.0;
    const auto write = [&](double y, const QString& text, const QColor& colour) {
        painter.setPen(colour);
        painter.drawText(QRectF(left, y - half, inside.right() - left + 4.0, 2.0 * half),
                         Qt::AlignLeft | Qt::AlignVCenter, text);
    };
    const double thresholdY = style.threshold ? yOf(*style.threshold) : -1e6;
    const auto writeUnlessHidden = [&](double y, const QString& text) {
        if (std::abs(y - thresholdY) > 1.6 * half) write(y, text, theme.muted);
    };
    // The colours end at the range's ends, the values do not.
    writeUnlessHidden(bar.top() + half - 2.0, QString(QChar(0x2265)) + kThinSpace + withUnit(style.maximum, style));
    writeUnlessHidden(0.5 * (bar.top() + bar.bottom()), withUnit(style.minimum + 0.5 * span, style));
    writeUnlessHidden(
        bar.bottom() - half + 2.0,
        (style.reachesBelow ? QString(QChar(0x2264)) + kThinSpace : QString()) + withUnit(style.minimum, style));
    if (style.threshold) {
        painter.setPen(QPen(theme.text, 2.0));
        painter.drawLine(QPointF(bar.left() - 3.0, thresholdY), QPointF(bar.right() + 4.0, thresholdY));
        write(std::clamp(thresholdY, bar.top() + half - 2.0, bar.bottom() - half + 2.0),
              withUnit(*style.threshold, style), theme.text);
    }
    if (legend_->anyUnknown) {
        const QRectF swatch(bar.left(), bottom + 10.0, kLegendBar_px, 12.0);
        paintHatch(painter, swatch, theme.muted);
        painter.setPen(QPen(theme.muted, 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(swatch);
        write(swatch.center().y(), unknownWord(style), theme.muted);
    }
}

void ViewOverlay::paintAxes(QPainter& painter) const {
    const Theme theme = currentTheme();
    constexpr double length_px = 22.0;
    const QPointF origin(kMargin_px + 0.5 * kAxesEdge_px, height() - kMargin_px - 0.5 * kAxesEdge_px);
    struct Axis {
        QString name;
        Eigen::Vector3d direction;
        double depth;
    };
    std::array<Axis, 3> axes = {Axis{QStringLiteral("x"), Eigen::Vector3d::UnitX(), 0.0},
                                Axis{QStringLiteral("y"), Eigen::Vector3d::UnitY(), 0.0},
                                Axis{QStringLiteral("z"), Eigen::Vector3d::UnitZ(), 0.0}};
    for (Axis& axis : axes)
        axis.depth = camera_.forward().dot(axis.direction);
    std::sort(axes.begin(), axes.end(), [](const Axis& a, const Axis& b) { return a.depth > b.depth; });
    for (const Axis& axis : axes) {
        const QPointF tip(camera_.right().dot(axis.direction) * length_px,
                          -camera_.up().dot(axis.direction) * length_px);
        const double reach = std::hypot(tip.x(), tip.y());
        const QColor colour = mixed(theme.muted, theme.text, axis.depth < 0.0 ? 0.5 : 0.0);
        painter.setPen(QPen(colour, 1.5, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(origin, origin + tip);
        if (reach < 6.0) continue;
        const QPointF word = origin + tip * ((reach + 9.0) / reach);
        painter.setPen(colour);
        painter.drawText(QRectF(word.x() - 8.0, word.y() - 9.0, 16.0, 18.0), Qt::AlignCenter, axis.name);
    }
}

double ViewOverlay::scaleLength_m() const {
    return roundLength(std::min(kLongestScale_px, width() * 0.2) * camera_.visibleHeight_m() / height());
}

void ViewOverlay::paintCorner(QPainter& painter) const {
    const double scale_px = scaleLength_m() * height() / camera_.visibleHeight_m();
    const QRectF area(kMargin_px, height() - kMargin_px - kAxesEdge_px, kAxesEdge_px + scale_px + 20.0, kAxesEdge_px);
    QColor ground = currentTheme().surface0;
    ground.setAlphaF(0.72);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(area, metrics::kRadius_px, metrics::kRadius_px);
    paintAxes(painter);
    paintScaleBar(painter);
}

void ViewOverlay::paintScaleBar(QPainter& painter) const {
    const Theme theme = currentTheme();
    const double length_m = scaleLength_m();
    const double length_px = length_m * height() / camera_.visibleHeight_m();
    const double left = kMargin_px + kAxesEdge_px + 6.0;
    const double y = height() - kMargin_px - 14.0;
    painter.setPen(QPen(theme.muted, 1.5));
    painter.drawLine(QPointF(left, y), QPointF(left + length_px, y));
    painter.drawLine(QPointF(left, y - 4.0), QPointF(left, y + 1.0));
    painter.drawLine(QPointF(left + length_px, y - 4.0), QPointF(left + length_px, y + 1.0));
    painter.drawText(QRectF(left, y - 22.0, length_px, 18.0), Qt::AlignHCenter | Qt::AlignBottom | Qt::TextDontClip,
                     lengthText(length_m));
}

void ViewOverlay::paintMeasurement(QPainter& painter) const {
    const Theme theme = currentTheme();
    if (!measurement_.from) return;
    painter.setBrush(theme.accent);
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(*measurement_.from, 4.0, 4.0);
    if (!measurement_.to) return;
    painter.drawEllipse(*measurement_.to, 4.0, 4.0);
    painter.setPen(QPen(theme.accent, 2.0));
    painter.drawLine(*measurement_.from, *measurement_.to);
    painter.setFont(fontFor(TextRole::Emphasis));
    const QPointF middle = 0.5 * (*measurement_.from + *measurement_.to);
    const double width = QFontMetricsF(painter.font()).horizontalAdvance(measurement_.text) + 16.0;
    const QRectF box(middle.x() - width / 2.0, middle.y() - 34.0, width, 24.0);
    paintPanel(painter, box, theme, theme.accent);
    painter.setPen(theme.text);
    painter.drawText(box, Qt::AlignCenter, measurement_.text);
    painter.setFont(fontFor(TextRole::Caption));
}

void ViewOverlay::paintHint(QPainter& painter) const {
    const Theme theme = currentTheme();
    const double width = QFontMetricsF(painter.font()).horizontalAdvance(hint_) + 16.0;
    QRectF box(hintPosition_.x() + 14.0, hintPosition_.y() + 14.0, width, 24.0);
    if (box.right() > this->width() - 4.0) box.moveRight(hintPosition_.x() - 10.0);
    if (box.bottom() > height() - 4.0) box.moveBottom(hintPosition_.y() - 10.0);
    paintPanel(painter, box, theme, theme.line);
    painter.setPen(theme.text);
    painter.drawText(box, Qt::AlignCenter, hint_);
}

void ViewOverlay::paintMessage(QPainter& painter) const {
    const Theme theme = currentTheme();
    const QPixmap picture = iconPixmap(Icon::Cube, theme.muted, 48, devicePixelRatioF());
    painter.drawPixmap(QPointF(width() / 2.0 - 24.0, height() * 0.4 - 48.0), picture);
    painter.setFont(fontFor(TextRole::Body));
    painter.setPen(theme.muted);
    const double side = std::max(24.0, (width() - 440.0) / 2.0);
    painter.drawText(QRectF(side, height() * 0.4 + 16.0, width() - 2.0 * side, 80.0),
                     Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, message_);
}

}  // namespace fodscope
