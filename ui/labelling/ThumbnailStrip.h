// SPDX-License-Identifier: MIT
#pragma once

#include <QPixmap>
#include <QWidget>
#include <vector>

#include "ui/labelling/LabellingModel.h"
#include "ui/theme/Theme.h"

QT_BEGIN_NAMESPACE
class QTimer;
QT_END_NAMESPACE

namespace fodscope {

/// One tile a photo, with its state as colour, shape and word. Thumbnails are decoded one at a time when nothing else
/// is to be done, those in sight first.
class ThumbnailStrip : public QWidget {
    Q_OBJECT

  public:
    explicit ThumbnailStrip(QWidget* parent = nullptr);

    /// @param photos must live until the next call
    void setPhotos(const std::vector<LabelPhoto>* photos);
    void setStates(std::vector<PhotoState> states);
    void setCurrent(int index);
    /// Smaller tiles where the photo needs the height.
    void setCompact(bool compact);

    /// @return the tile's index at a point, or −1
    int tileAt(const QPoint& point) const;
    QSize sizeHint() const override;

  signals:
    void clicked(int index);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

  private:
    struct Tile {
        QByteArray bytes;
        QPixmap picture;
        bool decoded = false;
    };
    QSize pictureSize() const;
    QSize tileSize() const;
    int count() const { return static_cast<int>(tiles_.size()); }
    QRect tileRect(int index) const;
    void scrollTo(int left);
    void decodeOne();
    void paintTile(QPainter& painter, int index);

    const std::vector<LabelPhoto>* photos_ = nullptr;
    std::vector<Tile> tiles_;
    std::vector<PhotoState> states_;
    int current_ = -1;
    int scroll_ = 0;
    bool compact_ = false;
    QTimer* decoding_ = nullptr;
};

/// Colour and shape of a photo's state.
StatusKind statusOf(PhotoState state);

}  // namespace fodscope
