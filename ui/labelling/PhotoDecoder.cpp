// SPDX-License-Identifier: MIT
#include "ui/labelling/PhotoDecoder.h"

#include <QBuffer>
#include <QImageReader>
#include <cstdint>

namespace fodscope {

namespace {

constexpr std::int64_t kMostPixels = 100'000'000;

bool isPlausible(const QSize& size) {
    return size.width() > 0 && size.height() > 0 &&
           static_cast<std::int64_t>(size.width()) * size.height() <= kMostPixels;
}

QImage decode(const QByteArray& bytes, const QSize& atLeast) {
    QByteArray copy = bytes;
    QBuffer buffer(&copy);
    if (!buffer.open(QIODevice::ReadOnly)) return {};
    QImageReader reader(&buffer);
    // The photo's pixels are the frame of boxes and outlines, so a rotation noted in the file is not applied.
    reader.setAutoTransform(false);
    const QSize size = reader.size();
    if (!isPlausible(size)) return {};
    if (atLeast.isValid()) reader.setScaledSize(size.scaled(atLeast, Qt::KeepAspectRatioByExpanding));
    return reader.read();
}

}  // namespace

QImage decodePhoto(const QByteArray& bytes) {
    const QImage photo = decode(bytes, {});
    return photo.isNull() ? photo : photo.convertToFormat(QImage::Format_RGB32);
}

QImage decodeThumbnail(const QByteArray& bytes, const QSize& size) {
    const QImage photo = decode(bytes, size);
    if (photo.isNull()) return photo;
    const QRect middle(QPoint((photo.width() - size.width()) / 2, (photo.height() - size.height()) / 2), size);
    return photo.copy(middle.intersected(photo.rect()));
}

}  // namespace fodscope
