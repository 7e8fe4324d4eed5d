// SPDX-License-Identifier: MIT
#include "ui/theme/Theme.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QPushButton>

#include "ui/theme/StyleSheet.h"

namespace fodscope {
namespace {

TEST(Theme, ContrastRatioIsWcags) {
    EXPECT_NEAR(contrastRatio(Qt::black, Qt::white), 21.0, 1e-6);
    EXPECT_NEAR(contrastRatio(QColor(0x77, 0x77, 0x77), Qt::white), 4.48, 0.01);
}

TEST(Theme, TextCanBeReadOnEverySurface) {
    for (const ThemeKind kind : {ThemeKind::Dark, ThemeKind::Light}) {
        const Theme theme = makeTheme(kind);
        for (const QColor& surface : {theme.surface0, theme.surface1, theme.surface2}) {
            EXPECT_GE(contrastRatio(theme.text, surface), 7.0);
            EXPECT_GE(contrastRatio(theme.muted, surface), 4.5);
        }
        EXPECT_GE(contrastRatio(theme.onAccent, theme.accent), 4.5);
        EXPECT_GE(contrastRatio(theme.onFinding, theme.finding), 4.5);
        EXPECT_GE(contrastRatio(theme.text, theme.selection), 7.0);
    }
}

TEST(Theme, StatesCanBeSeenOnPanels) {
    for (const ThemeKind kind : {ThemeKind::Dark, ThemeKind::Light}) {
        const Theme theme = makeTheme(kind);
        for (const StatusKind state :
             {StatusKind::Running, StatusKind::Attention, StatusKind::Clear, StatusKind::Finding, StatusKind::ToDo}) {
            EXPECT_GE(contrastRatio(statusColour(theme, state), theme.surface1), 3.0);
        }
    }
}

TEST(Theme, TheStyleSheetHasNoTokenLeft) {
    for (const ThemeKind kind : {ThemeKind::Dark, ThemeKind::Light}) {
        const QString sheet = styleSheetFor(makeTheme(kind));
        EXPECT_FALSE(sheet.isEmpty());
        const int comment = sheet.indexOf(QStringLiteral("*/"));
        EXPECT_EQ(sheet.indexOf(QLatin1Char('@'), comment), -1);
    }
}

TEST(Theme, CanBeChangedWhileRunning) {
    applyTheme(*qApp, ThemeKind::Light);
    EXPECT_EQ(currentTheme().kind, ThemeKind::Light);
    EXPECT_EQ(qApp->palette().color(QPalette::Window), makeTheme(ThemeKind::Light).surface1);
    applyTheme(*qApp, ThemeKind::Dark);
    EXPECT_EQ(currentTheme().kind, ThemeKind::Dark);
}

TEST(Theme, ControlsAreLargeEnough) {
    QPushButton button(QStringLiteral("Find candidates"));
    button.ensurePolished();
    EXPECT_GE(button.sizeHint().height(), metrics::kControlHeight_px);
}

TEST(Theme, APrimaryButtonHasTheAccent) {
    QPushButton button(QStringLiteral("Start"));
    setButtonRole(&button, ButtonRole::Primary);
    button.resize(120, 32);
    const QColor ground = button.grab().toImage().pixelColor(8, 16);
    EXPECT_EQ(ground, currentTheme().accent);
}

}  // namespace
}  // namespace fodscope
