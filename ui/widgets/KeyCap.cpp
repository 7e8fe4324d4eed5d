// SPDX-License-Identifier: MIT
#include "ui/widgets/KeyCap.h"

#include <QPainter>

#include "ui/theme/Colours.h"
#include "ui/widgets/StatusChip.h"

namespace fodscope {
namespace {

constexpr int kCap_px = 24;
constexpr int kPadding_px = 6;
constexpr double kMark_px = 12.0;

}  // namespace

KeyCap::KeyCap(const QString& key, const QString& word, QWidget* parent) : QAbstractButton(parent), key_(key) {
    setText(word);
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    setAccessibleName(tr("%1, key %2").arg(word, key));
}

void KeyCap::setKey(const QString& key) {
    key_ = key;
    setAccessibleName(tr("%1, key %2").arg(text(), key));
    updateGeometry();
    update();
}

void KeyCap::setStatus(StatusKind kind) {
    status_ = kind;
    update();
}

QSize KeyCap::sizeHint() const {
    const QFontMetrics fonts(font());
    const int cap = std::max(kCap_px, fonts.horizontalAdvance(key_) + 2 * kPadding_px);
    return {kPadding_px + cap + 8 + fonts.horizontalAdvance(text()) + 12 + static_cast<int>(kMark_px) + kPadding_px,
            metrics::kKeyHeight_px};
}

QSize KeyCap::minimumSizeHint() const {
    return {kPadding_px + kCap_px + 8 + 48, metrics::kKeyHeight_px};
}

void KeyCap::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme theme = currentTheme();
    const QColor mark = statusColour(theme, status_);
    QColor ground = hovered_ && isEnabled() ? theme.hover : theme.surface2;
    if (isChecked()) ground = mixed(theme.surface1, mark, 0.28);
    if (isDown()) ground = theme.line;
    const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setBrush(isEnabled() ? ground : theme.surface1);
    painter.setPen(QPen(hasFocus() ? theme.accent : isChecked() ? mark : theme.line, hasFocus() ? 2.0 : 1.0));
    painter.drawRoundedRect(box, metrics::kRadius_px, metrics::kRadius_px);

    const int capWidth = std::max(kCap_px, fontMetrics().horizontalAdvance(key_) + 2 * kPadding_px);
    const QRectF cap(kPadding_px + 0.5, (height() - kCap_px) / 2.0, capWidth, kCap_px);
    painter.setBrush(theme.surface0);
    painter.setPen(QPen(theme.line, 1.0));
    painter.drawRoundedRect(cap, 4.0, 4.0);
    painter.setPen(QPen(mixed(theme.line, theme.muted, 0.5), 2.0));
    painter.drawLine(QPointF(cap.left() + 4.0, cap.bottom()), QPointF(cap.right() - 4.0, cap.bottom()));
    painter.setFont(fontFor(TextRole::Emphasis));
    painter.setPen(isEnabled() ? theme.text : theme.disabled);
    painter.drawText(cap, Qt::AlignCenter, key_);

    painter.setFont(font());
    const int left = static_cast<int>(cap.right()) + 8;
    const int markRoom = isChecked() ? static_cast<int>(kMark_px) + 4 : 0;
    const QRect words(left, 0, width() - left - kPadding_px - markRoom, height());
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text(), Qt::ElideRight, words.width()));
    if (isChecked()) {
        const QRectF shape(width() - kPadding_px - 2 - kMark_px, (height() - kMark_px) / 2.0, kMark_px, kMark_px);
        paintStatusShape(painter, shape, status_ == StatusKind::Neutral ? StatusKind::Clear : status_, theme);
    }
}

void KeyCap::enterEvent(QEvent*) {
    hovered_ = true;
    update();
}

void KeyCap::leaveEvent(QEvent*) {
    hovered_ = false;
    update();
}

}  // namespace fodscope
