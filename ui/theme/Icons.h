// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QIcon>
#include <QPixmap>

namespace fodscope {

/// The icons of resources/icons; the file name is the name in lower case with hyphens (ViewTop: view-top.svg).
enum class Icon {
    Open,
    New,
    Save,
    Drop,
    Cube,
    Cloud,
    Layers,
    Eye,
    EyeOff,
    Fit,
    ViewTop,
    ViewFront,
    ViewSide,
    ViewIso,
    Pick,
    Ruler,
    Peel,
    Play,
    Pause,
    Skip,
    Stop,
    Retry,
    Camera,
    Check,
    Warning,
    EmptyCircle,
    Dot,
    HalfCircle,
    Spinner,
    Undo,
    Redo,
    Help,
    Search,
    Report,
    Export,
    Settings,
    Robot,
    Route,
    Label,
    ChevronDown,
    ChevronUp,
    ChevronLeft,
    ChevronRight,
    Close,
    Sun,
    Moon,
    Plus,
    Minus,
    Trash,
    Hide,
    Histogram,
    Info,
    Link,
    Target,
    Outline,
    Contrast,
    Comment,
    Table,
    Grid,
    Keyboard,
    Copy,
    Pin
};

/// An icon in the text colour of the current theme; follows a change of theme by itself, muted when disabled.
QIcon icon(Icon name);

/// An icon in a fixed colour.
QIcon icon(Icon name, const QColor& colour);

/// @param size_px edge in device-independent pixels
QPixmap iconPixmap(Icon name, const QColor& colour, int size_px, double devicePixelRatio = 1.0);

/// The application's icon.
QIcon applicationIcon();

}  // namespace fodscope
