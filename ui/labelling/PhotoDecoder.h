// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QImage>
#include <QSize>

namespace fodscope {

/// @return the photo, or a null image when the bytes are none or claim to be larger than 100 megapixels
QImage decodePhoto(const QByteArray& bytes);

/// @return the photo filling `size` and cut at the edges, or a null image as above
QImage decodeThumbnail(const QByteArray& bytes, const QSize& size);

}  // namespace fodscope
