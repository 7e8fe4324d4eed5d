// SPDX-License-Identifier: MIT
#include "ui/labelling/PhotoViewport.h"

#include <gtest/gtest.h>

#include "ui/labelling/ContrastStretch.h"

namespace fodscope {
namespace {

const QSizeF kPhoto(1280, 720);
const QSizeF kWidget(800, 600);

TEST(PhotoViewport, FitsTheWholePhotoInTheMiddle) {
    const PhotoViewport viewport = fittedViewport(kPhoto, kWidget, 0.0);
    EXPECT_DOUBLE_EQ(viewport.scale, 0.625);
    EXPECT_EQ(viewport.toWidget(QRectF(QPointF(0, 0), kPhoto)), QRectF(0, 75, 800, 450));
}

TEST(PhotoViewport, ZoomKeepsThePointUnderTheCursor) {
    const QPointF cursor(300, 320);
    PhotoViewport viewport = fittedViewport(kPhoto, kWidget, 0.0);
    viewport = zoomedViewport(viewport, 4.0, cursor, kPhoto, kWidget);
    const QPointF before = viewport.toImage(cursor);
    viewport = zoomedViewport(viewport, 1.5, cursor, kPhoto, kWidget);
    EXPECT_NEAR(viewport.toImage(cursor).x(), before.x(), 1e-9);
    EXPECT_NEAR(viewport.toImage(cursor).y(), before.y(), 1e-9);
}

TEST(PhotoViewport, NoGapOpensAtTheEdgesWhenZoomedIn) {
    PhotoViewport viewport;
    viewport.scale = 2.0;
    viewport.offset = {500, -5000};
    viewport = keptInSight(viewport, kPhoto, kWidget);
    EXPECT_EQ(viewport.offset, QPointF(0, 600 - 1440));
}

TEST(PhotoViewport, ZoomStopsBeforePixelsFillTheView) {
    PhotoViewport viewport = fittedViewport(kPhoto, kWidget);
    for (int step = 0; step < 100; ++step)
        viewport = zoomedViewport(viewport, 2.0, {1, 1}, kPhoto, kWidget);
    EXPECT_LE(viewport.scale, 16.0);
    for (int step = 0; step < 100; ++step)
        viewport = zoomedViewport(viewport, 0.5, {1, 1}, kPhoto, kWidget);
    EXPECT_GT(viewport.scale, 0.1);
}

TEST(PhotoViewport, AnEmptyPhotoDoesNotDivideByZero) {
    EXPECT_DOUBLE_EQ(fittedViewport({0, 0}, kWidget).scale, 1.0);
}

TEST(BoxBetween, TakesCornersInAnyOrderAndStaysOnThePhoto) {
    EXPECT_EQ(boxBetween({100, 90}, {40, 50}, kPhoto), (PixelBox{40, 50, 60, 40}));
    EXPECT_EQ(boxBetween({1200, 700}, {1400, 900}, kPhoto), (PixelBox{1200, 700, 80, 20}));
    const PixelBox beside = boxBetween({-50, -50}, {-10, -10}, kPhoto);
    EXPECT_LE(beside.width_px * beside.height_px, 0.0);
}

TEST(ContrastStretch, UsesTheWholeRangeAndLeavesTheOriginal) {
    QImage photo(100, 10, QImage::Format_RGB32);
    for (int x = 0; x < 100; ++x) {
        for (int y = 0; y < 10; ++y)
            photo.setPixel(x, y, qRgb(40 + x / 4, 40 + x / 4, 40 + x / 4));
    }
    const QImage before = photo.copy();
    const QImage stretched = contrastStretched(photo);
    EXPECT_EQ(photo, before);
    EXPECT_LT(qGray(stretched.pixel(0, 0)), 10);
    EXPECT_GT(qGray(stretched.pixel(99, 0)), 245);
    EXPECT_TRUE(contrastStretched({}).isNull());
    for (int x = 0; x < 100; ++x) {
        for (int y = 0; y < 10; ++y)
            photo.setPixel(x, y, qRgb(10 + x / 4, 20 + x / 2, 20 + x / 2));
    }
    const QRgb pixel = contrastStretched(photo).pixel(50, 5);
    EXPECT_GT(qGreen(pixel), 60);
    EXPECT_NEAR(qRed(pixel) * 2, qGreen(pixel), 3) << "hues stay";
}

}  // namespace
}  // namespace fodscope
