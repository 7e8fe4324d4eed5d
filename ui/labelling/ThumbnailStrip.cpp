// SPDX-License-Identifier: MIT
#include "ui/labelling/ThumbnailStrip.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QTimer>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <utility>

#include "ui/labelling/PhotoDecoder.h"
#include "ui/theme/Colours.h"
#include "ui/widgets/StatusChip.h"

namespace fodscope {

namespace {

constexpr QSize kPicture_px(128, 72);
constexpr QSize kCompactPicture_px(124, 48);
constexpr int kCaptionHeight_px = 20;
constexpr int kGap_px = 8;

}  // namespace

StatusKind statusOf(PhotoState state) {
    switch (state) {
        case PhotoState::Undecided:
            return StatusKind::ToDo;
        case PhotoState::NotSure:
            return StatusKind::Attention;
        case PhotoState::NoFod:
            return StatusKind::Clear;
        case PhotoState::Fod:
            return StatusKind::Finding;
    }
    return StatusKind::Neutral;
}

ThumbnailStrip::ThumbnailStrip(QWidget* parent) : QWidget(parent), decoding_(new QTimer(this)) {
    setObjectName(QStringLiteral("thumbnails"));
    setFixedHeight(sizeHint().height());
    setFocusPolicy(Qt::NoFocus);
    decoding_->setInterval(0);
    connect(decoding_, &QTimer::timeout, this, &ThumbnailStrip::decodeOne);
}

QSize ThumbnailStrip::pictureSize() const {
    return compact_ ? kCompactPicture_px : kPicture_px;
}

QSize ThumbnailStrip::tileSize() const {
    return pictureSize() + QSize(0, kCaptionHeight_px);
}

QSize ThumbnailStrip::sizeHint() const {
    return {4 * (tileSize().width() + kGap_px), tileSize().height() + 2 * kGap_px};
}

void ThumbnailStrip::setCompact(bool compact) {
    if (compact == compact_) return;
    compact_ = compact;
    setFixedHeight(sizeHint().height());
    for (Tile& tile : tiles_)
        tile.decoded = false;
    decoding_->start();
    if (current_ >= 0) setCurrent(current_);
}

void ThumbnailStrip::setPhotos(const std::vector<LabelPhoto>* photos) {
    photos_ = photos;
    const std::vector<Tile> before = std::exchange(tiles_, {});
    tiles_.resize(photos ? photos->size() : 0);
    for (std::size_t index = 0; index < tiles_.size(); ++index) {
        const QByteArray& bytes = (*photos)[index].bytes;
        const auto same = std::find_if(before.begin(), before.end(),
                                       [&](const Tile& tile) { return tile.decoded && tile.bytes == bytes; });
        if (same != before.end()) tiles_[index] = *same;
        tiles_[index].bytes = bytes;
    }
    states_.assign(tiles_.size(), PhotoState::Undecided);
    current_ = -1;
    if (tiles_.empty()) {
        decoding_->stop();
    } else {
        decoding_->start();
    }
    scrollTo(scroll_);
}

void ThumbnailStrip::setStates(std::vector<PhotoState> states) {
    states_ = std::move(states);
    update();
}

void ThumbnailStrip::setCurrent(int index) {
    current_ = index;
    const QRect tile = tileRect(index);
    // The neighbours stay in sight, so that one sees what comes next.
    if (tile.left() < tileSize().width()) {
        scrollTo(scroll_ + tile.left() - tileSize().width());
    } else if (tile.right() > width() - tileSize().width()) {
        scrollTo(scroll_ + tile.right() - width() + tileSize().width());
    }
    update();
}

QRect ThumbnailStrip::tileRect(int index) const {
    return {QPoint(kGap_px + index * (tileSize().width() + kGap_px) - scroll_, kGap_px), tileSize()};
}

int ThumbnailStrip::tileAt(const QPoint& point) const {
    for (int index = 0; index < count(); ++index) {
        if (tileRect(index).contains(point)) return index;
    }
    return -1;
}

void ThumbnailStrip::scrollTo(int left) {
    const int whole = kGap_px + count() * (tileSize().width() + kGap_px);
    scroll_ = std::clamp(left, 0, std::max(0, whole - width()));
    update();
}

void ThumbnailStrip::decodeOne() {
    if (!photos_) return;
    int next = -1;
    for (int index = 0; index < count(); ++index) {
        if (tiles_[static_cast<std::size_t>(index)].decoded) continue;
        if (next < 0) next = index;
        if (rect().intersects(tileRect(index))) {
            next = index;
            break;
        }
    }
    if (next < 0) {
        decoding_->stop();
        return;
    }
    Tile& tile = tiles_[static_cast<std::size_t>(next)];
    const double ratio = devicePixelRatioF();
    const QSize size = pictureSize() * ratio;
    tile.picture = QPixmap::fromImage(decodeThumbnail(tile.bytes, size));
    tile.picture.setDevicePixelRatio(ratio);
    tile.decoded = true;
    update(tileRect(next));
}

void ThumbnailStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Theme theme = currentTheme();
    painter.fillRect(rect(), theme.surface1);
    painter.fillRect(0, 0, width(), 1, theme.line);
    painter.setRenderHint(QPainter::Antialiasing);
    for (int index = 0; index < count(); ++index) {
        if (rect().intersects(tileRect(index))) paintTile(painter, index);
    }
}

void ThumbnailStrip::paintTile(QPainter& painter, int index) {
    const Theme theme = currentTheme();
    const QRectF tile = tileRect(index);
    const QRectF picture(tile.topLeft(), QSizeF(pictureSize()));
    const Tile& content = tiles_[static_cast<std::size_t>(index)];
    const LabelPhoto& photo = (*photos_)[static_cast<std::size_t>(index)];
    const PhotoState state = states_[static_cast<std::size_t>(index)];

    painter.save();
    QPainterPath corners;
    corners.addRoundedRect(picture, 4.0, 4.0);
    painter.setClipPath(corners);
    painter.fillRect(picture, theme.surface2);
    if (!content.picture.isNull()) {
        const QSizeF size = QSizeF(content.picture.size()) / content.picture.devicePixelRatioF();
        painter.drawPixmap(picture.center() - QPointF(0.5 * size.width(), 0.5 * size.height()), content.picture);
    } else if (content.decoded) {
        paintHatch(painter, picture, theme.muted);
    }
    painter.restore();
    if (index == current_) {
        painter.setPen(QPen(theme.accent, 2.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(picture.adjusted(-1, -1, 1, 1), 5.0, 5.0);
    }

    const StatusKind kind = statusOf(state);
    const double line = tile.bottom() - 18.0;
    paintStatusShape(painter, QRectF(tile.left(), line + 3.0, 12.0, 12.0), kind, theme);
    painter.setFont(fontFor(TextRole::Caption));
    painter.setPen(state == PhotoState::Undecided ? theme.muted : statusColour(theme, kind));
    const QString word = content.decoded && content.picture.isNull() ? tr("unreadable") : toWords(state);
    painter.drawText(QRectF(tile.left() + 16.0, line, tile.width() - 16.0, 18.0), Qt::AlignVCenter | Qt::AlignLeft,
                     word);
    painter.setPen(index == current_ ? theme.text : theme.muted);
    painter.drawText(QRectF(tile.left(), line, tile.width(), 18.0), Qt::AlignVCenter | Qt::AlignRight,
                     QString::fromStdString(photo.id));
}

void ThumbnailStrip::mousePressEvent(QMouseEvent* event) {
    const int index = tileAt(event->pos());
    if (index >= 0 && event->button() == Qt::LeftButton) emit clicked(index);
}

void ThumbnailStrip::wheelEvent(QWheelEvent* event) {
    const QPoint delta = event->angleDelta();
    scrollTo(scroll_ - (delta.x() != 0 ? delta.x() : delta.y()));
    event->accept();
}

void ThumbnailStrip::resizeEvent(QResizeEvent*) {
    scrollTo(scroll_);
}

bool ThumbnailStrip::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const int index = tileAt(help->pos());
    if (index < 0) {
        QToolTip::hideText();
        return true;
    }
    const LabelPhoto& photo = (*photos_)[static_cast<std::size_t>(index)];
    QToolTip::showText(help->globalPos(),
                       QStringLiteral("%1 · %2\n%3")
                           .arg(QString::fromStdString(photo.id), toWords(states_[static_cast<std::size_t>(index)]),
                                shownInWords(photo).join(QStringLiteral(" · "))),
                       this);
    return true;
}

}  // namespace fodscope
