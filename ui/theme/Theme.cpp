// SPDX-License-Identifier: MIT
#include "ui/theme/Theme.h"

#include <QAbstractButton>
#include <QApplication>
#include <QFontDatabase>
#include <QLabel>
#include <QPainter>
#include <QPalette>
#include <QStyle>
#include <QStyleFactory>
#include <QSurfaceFormat>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "ui/theme/Colours.h"
#include "ui/theme/Icons.h"
#include "ui/theme/StyleSheet.h"

namespace fodscope {
namespace {

// The theme's kind is kept at the application, which outlives every widget.
constexpr char kThemeProperty[] = "fodscopeTheme";

Theme darkTheme() {
    Theme theme;
    theme.kind = ThemeKind::Dark;
    theme.surface0 = QColor(0x12, 0x16, 0x1b);
    theme.surface1 = QColor(0x1a, 0x20, 0x27);
    theme.surface2 = QColor(0x24, 0x2c, 0x35);
    theme.hover = QColor(0x2e, 0x38, 0x43);
    theme.line = QColor(0x31, 0x3b, 0x46);
    theme.text = QColor(0xe8, 0xed, 0xf2);
    theme.muted = QColor(0x94, 0xa3, 0xb3);
    theme.disabled = QColor(0x5d, 0x6b, 0x79);
    theme.accent = QColor(0x4c, 0xc2, 0xff);
    theme.onAccent = QColor(0x0b, 0x1a, 0x24);
    theme.finding = QColor(0xff, 0x5a, 0x5f);
    theme.onFinding = QColor(0x1f, 0x06, 0x07);
    theme.attention = QColor(0xff, 0xb0, 0x20);
    theme.clear = QColor(0x3e, 0xcf, 0x8e);
    theme.selection = mixed(theme.surface1, theme.accent, 0.22);
    return theme;
}

Theme lightTheme() {
    Theme theme;
    theme.kind = ThemeKind::Light;
    theme.surface0 = QColor(0xf6, 0xf7, 0xf8);
    theme.surface1 = QColor(0xff, 0xff, 0xff);
    theme.surface2 = QColor(0xe9, 0xed, 0xf0);
    theme.hover = QColor(0xdd, 0xe3, 0xe8);
    theme.line = QColor(0xd3, 0xda, 0xe0);
    theme.text = QColor(0x16, 0x20, 0x2a);
    theme.muted = QColor(0x5b, 0x6a, 0x78);
    theme.disabled = QColor(0x9a, 0xa7, 0xb3);
    theme.accent = QColor(0x00, 0x6a, 0xa6);
    theme.onAccent = QColor(0xff, 0xff, 0xff);
    theme.finding = QColor(0xc9, 0x25, 0x2b);
    theme.onFinding = QColor(0xff, 0xff, 0xff);
    theme.attention = QColor(0x8f, 0x55, 0x00);
    theme.clear = QColor(0x11, 0x70, 0x44);
    theme.selection = mixed(theme.surface1, theme.accent, 0.16);
    return theme;
}

QPalette paletteFor(const Theme& theme) {
    QPalette palette;
    palette.setColor(QPalette::Window, theme.surface1);
    palette.setColor(QPalette::WindowText, theme.text);
    palette.setColor(QPalette::Base, theme.surface0);
    palette.setColor(QPalette::AlternateBase, theme.surface1);
    palette.setColor(QPalette::Text, theme.text);
    palette.setColor(QPalette::Button, theme.surface2);
    palette.setColor(QPalette::ButtonText, theme.text);
    palette.setColor(QPalette::BrightText, theme.finding);
    palette.setColor(QPalette::ToolTipBase, theme.surface2);
    palette.setColor(QPalette::ToolTipText, theme.text);
    palette.setColor(QPalette::PlaceholderText, theme.muted);
    palette.setColor(QPalette::Highlight, theme.accent);
    palette.setColor(QPalette::HighlightedText, theme.onAccent);
    palette.setColor(QPalette::Link, theme.accent);
    palette.setColor(QPalette::LinkVisited, theme.accent);
    palette.setColor(QPalette::Light, theme.hover);
    palette.setColor(QPalette::Midlight, theme.surface2);
    palette.setColor(QPalette::Mid, theme.line);
    palette.setColor(QPalette::Dark, theme.surface0);
    palette.setColor(QPalette::Shadow, theme.surface0);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText}) {
        palette.setColor(QPalette::Disabled, role, theme.disabled);
    }
    palette.setColor(QPalette::Disabled, QPalette::Highlight, theme.line);
    return palette;
}

double linear(double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& colour) {
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

// A style sheet rule that asks for a property is only looked up again when the widget is polished again.
void setStyleProperty(QWidget* widget, const char* name, const QString& value) {
    if (widget->property(name).toString() == value) return;
    widget->setProperty(name, value);
    widget->style()->unpolish(widget);
    widget->style()->polish(widget);
    widget->update();
}

}  // namespace

Theme makeTheme(ThemeKind kind) {
    return kind == ThemeKind::Dark ? darkTheme() : lightTheme();
}

void prepareApplication() {
    QCoreApplication::setApplicationName(QStringLiteral("Fodscope"));
    QCoreApplication::setOrganizationName(QStringLiteral("Fodscope"));
    QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
    QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
    // A 3D view that moves between windows keeps its textures and buffers.
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);

    // What the 3D view's renderer needs: OpenGL 3.2, core profile; it smooths edges by itself.
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setSwapBehavior(QSurfaceFormat::DoubleBuffer);
    format.setRedBufferSize(8);
    format.setGreenBufferSize(8);
    format.setBlueBufferSize(8);
    format.setAlphaBufferSize(8);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    format.setSamples(0);
    QSurfaceFormat::setDefaultFormat(format);
}

void applyTheme(QApplication& application, ThemeKind kind) {
    const Theme theme = makeTheme(kind);
    application.setProperty(kThemeProperty, static_cast<int>(kind));
    if (!application.styleSheet().isEmpty()) application.setStyleSheet({});
    application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    application.setFont(fontFor(TextRole::Body));
    application.setPalette(paletteFor(theme));
    application.setWindowIcon(applicationIcon());
    application.setStyleSheet(styleSheetFor(theme));
}

Theme currentTheme() {
    const QVariant kind = qApp ? qApp->property(kThemeProperty) : QVariant();
    return makeTheme(kind.isValid() ? static_cast<ThemeKind>(kind.toInt()) : ThemeKind::Dark);
}

QFont fontFor(TextRole role) {
    QFont font = QFontDatabase::systemFont(QFontDatabase::GeneralFont);
    font.setStyleHint(QFont::SansSerif);
    font.setWeight(QFont::Normal);
    switch (role) {
        case TextRole::Body:
        case TextRole::Muted:
            font.setPixelSize(13);
            break;
        case TextRole::Caption:
            font.setPixelSize(12);
            break;
        case TextRole::Heading:
            font.setPixelSize(14);
            font.setWeight(QFont::DemiBold);
            break;
        case TextRole::Emphasis:
            font.setPixelSize(13);
            font.setWeight(QFont::DemiBold);
            break;
        case TextRole::Number:
            font.setPixelSize(21);
            break;
    }
    return font;
}

void setTextRole(QLabel* label, TextRole role) {
    label->setFont(fontFor(role));
    switch (role) {
        case TextRole::Caption:
            setStyleProperty(label, "textRole", QStringLiteral("caption"));
            break;
        case TextRole::Muted:
            setStyleProperty(label, "textRole", QStringLiteral("muted"));
            break;
        default:
            setStyleProperty(label, "textRole", QStringLiteral("plain"));
            break;
    }
}

void setButtonRole(QAbstractButton* button, ButtonRole role) {
    switch (role) {
        case ButtonRole::Normal:
            setStyleProperty(button, "buttonRole", QStringLiteral("normal"));
            break;
        case ButtonRole::Primary:
            setStyleProperty(button, "buttonRole", QStringLiteral("primary"));
            break;
        case ButtonRole::Destructive:
            setStyleProperty(button, "buttonRole", QStringLiteral("destructive"));
            break;
        case ButtonRole::Quiet:
            setStyleProperty(button, "buttonRole", QStringLiteral("quiet"));
            break;
    }
}

void setSurface(QWidget* widget, SurfaceRole role) {
    widget->setAttribute(Qt::WA_StyledBackground);
    setStyleProperty(widget, "surface", QString::number(static_cast<int>(role)));
}

QColor statusColour(const Theme& theme, StatusKind kind) {
    switch (kind) {
        case StatusKind::Neutral:
            return theme.text;
        case StatusKind::ToDo:
        case StatusKind::NotObserved:
            return theme.muted;
        case StatusKind::Running:
            return theme.accent;
        case StatusKind::Attention:
            return theme.attention;
        case StatusKind::Clear:
            return theme.clear;
        case StatusKind::Finding:
            return theme.finding;
    }
    return theme.text;
}

void paintHatch(QPainter& painter, const QRectF& area, const QColor& colour) {
    painter.save();
    painter.setClipRect(area, Qt::IntersectClip);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, 1.0));
    constexpr double spacing_px = 5.0;
    for (double x = area.left() - area.height(); x < area.right(); x += spacing_px) {
        painter.drawLine(QPointF(x, area.bottom()), QPointF(x + area.height(), area.top()));
    }
    painter.restore();
}

double contrastRatio(const QColor& a, const QColor& b) {
    const double first = luminance(a);
    const double second = luminance(b);
    return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

}  // namespace fodscope
