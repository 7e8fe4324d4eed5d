// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QFont>
#include <QString>

class QAbstractButton;
class QApplication;
class QLabel;
class QPainter;
class QRectF;
class QWidget;

namespace fodscope {

enum class ThemeKind { Dark, Light };

/// The colours of the visual language. Each means one thing; see the comments.
struct Theme {
    ThemeKind kind = ThemeKind::Dark;
    QColor surface0;   ///< window, 3D view, photo surround
    QColor surface1;   ///< panels
    QColor surface2;   ///< raised: controls, cards, table headers
    QColor hover;      ///< a raised control under the pointer
    QColor line;       ///< 1 px separators
    QColor text;       ///< at least 7:1 on every surface
    QColor muted;      ///< captions, units; at least 4.5:1
    QColor accent;     ///< selection, focus ring, primary button: nothing else
    QColor onAccent;   ///< text on accent
    QColor finding;    ///< FOD confirmed, STOP, errors
    QColor onFinding;  ///< text on finding
    QColor attention;  ///< candidate undecided, stale, not sure
    QColor clear;      ///< decided no FOD, done, fresh
    QColor selection;  ///< background of a selected row (accent mixed into the surface)
    QColor disabled;   ///< text and icons of what cannot be used now
};

Theme makeTheme(ThemeKind kind);

/// Sizes in px of the visual language. Everything is a multiple of 4.
namespace metrics {
inline constexpr int kStep_px = 4;
inline constexpr int kPanelMargin_px = 12;
inline constexpr int kControlHeight_px = 28;
inline constexpr int kKeyHeight_px = 36;
inline constexpr int kRadius_px = 6;
inline constexpr int kIcon_px = 16;
inline constexpr int kLargeIcon_px = 24;
}  // namespace metrics

/// Must run before the QApplication is made: surface format for OpenGL, high-DPI pixmaps, application names.
void prepareApplication();

/// Sets style, palette, font and style sheet of the whole program; may be called again to change the theme.
void applyTheme(QApplication& application, ThemeKind kind);

/// The theme that applyTheme() set last (dark before that). Widgets that paint themselves read it in paintEvent.
Theme currentTheme();

/// Body is 10 pt. Numbers that matter are 16 pt. All of them with digits of equal width.
enum class TextRole { Body, Caption, Heading, Emphasis, Number, Muted };
QFont fontFor(TextRole role);
/// Gives a label the font and colour of a role.
void setTextRole(QLabel* label, TextRole role);

/// Primary: the accent, one a panel. Destructive: STOP and what cannot be undone. Quiet: no frame until hovered.
enum class ButtonRole { Normal, Primary, Destructive, Quiet };
void setButtonRole(QAbstractButton* button, ButtonRole role);

/// What a widget's background is. Panels are Surface1, the middle of the window is Surface0.
enum class SurfaceRole { Surface0, Surface1, Surface2 };
void setSurface(QWidget* widget, SurfaceRole role);

/// State is colour plus shape plus word; the same state has the same colour everywhere.
enum class StatusKind { Neutral, ToDo, Running, Attention, Clear, Finding, NotObserved };
QColor statusColour(const Theme& theme, StatusKind kind);

/// Diagonal hatching for "not observed" and "no value": never a plain colour.
void paintHatch(QPainter& painter, const QRectF& area, const QColor& colour);

/// @return WCAG contrast ratio of two opaque colours, 1..21
double contrastRatio(const QColor& a, const QColor& b);

}  // namespace fodscope
