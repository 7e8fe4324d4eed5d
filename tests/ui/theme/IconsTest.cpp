// SPDX-License-Identifier: MIT
#include "ui/theme/Icons.h"

#include <gtest/gtest.h>

#include <QApplication>

#include "ui/theme/Theme.h"

namespace fodscope {
namespace {

/// The strongest pixel, which a stroke's middle is.
QColor strongest(const QPixmap& pixmap) {
    const QImage image = pixmap.toImage();
    QColor best(0, 0, 0, 0);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor pixel = image.pixelColor(x, y);
            if (pixel.alpha() > best.alpha()) best = pixel;
        }
    }
    return best;
}

TEST(Icons, EveryNameHasAPictureInTheColourAskedFor) {
    const QColor colour(255, 90, 95);
    for (int name = 0; name <= static_cast<int>(Icon::Pin); ++name) {
        const QColor drawn = strongest(iconPixmap(static_cast<Icon>(name), colour, 24));
        ASSERT_GT(drawn.alpha(), 100) << "icon " << name << " is empty";
        EXPECT_NEAR(drawn.red(), colour.red(), 6) << name;
        EXPECT_NEAR(drawn.green(), colour.green(), 6) << name;
    }
}

TEST(Icons, AreSharpOnDenseScreens) {
    const QPixmap pixmap = iconPixmap(Icon::Check, Qt::white, 16, 2.0);
    EXPECT_EQ(pixmap.width(), 32);
    EXPECT_EQ(pixmap.devicePixelRatio(), 2.0);
}

TEST(Icons, FollowTheTheme) {
    const QIcon robot = icon(Icon::Robot);
    applyTheme(*qApp, ThemeKind::Dark);
    const QColor dark = strongest(robot.pixmap(24));
    applyTheme(*qApp, ThemeKind::Light);
    const QColor light = strongest(robot.pixmap(24));
    applyTheme(*qApp, ThemeKind::Dark);
    EXPECT_GT(dark.lightness(), 200);
    EXPECT_LT(light.lightness(), 80);
}

TEST(Icons, TheApplicationHasOne) {
    EXPECT_FALSE(applicationIcon().pixmap(64).isNull());
}

}  // namespace
}  // namespace fodscope
