// SPDX-License-Identifier: MIT
#include "ui/theme/Icons.h"

#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>
#include <array>
#include <optional>

#include "ui/theme/Theme.h"

// Must be outside of every namespace; the icons live in a static library.
static void loadIconResource() {
    Q_INIT_RESOURCE(icons);
}

namespace fodscope {
namespace {

struct IconFile {
    Icon name;
    const char* file;
};

constexpr std::array kFiles = {
    IconFile{Icon::Open, "open"},
    IconFile{Icon::New, "new"},
    IconFile{Icon::Save, "save"},
    IconFile{Icon::Drop, "drop"},
    IconFile{Icon::Cube, "cube"},
    IconFile{Icon::Cloud, "cloud"},
    IconFile{Icon::Layers, "layers"},
    IconFile{Icon::Eye, "eye"},
    IconFile{Icon::EyeOff, "eye-off"},
    IconFile{Icon::Fit, "fit"},
    IconFile{Icon::ViewTop, "view-top"},
    IconFile{Icon::ViewFront, "view-front"},
    IconFile{Icon::ViewSide, "view-side"},
    IconFile{Icon::ViewIso, "view-iso"},
    IconFile{Icon::Pick, "pick"},
    IconFile{Icon::Ruler, "ruler"},
    IconFile{Icon::Peel, "peel"},
    IconFile{Icon::Play, "play"},
    IconFile{Icon::Pause, "pause"},
    IconFile{Icon::Skip, "skip"},
    IconFile{Icon::Stop, "stop"},
    IconFile{Icon::Retry, "retry"},
    IconFile{Icon::Camera, "camera"},
    IconFile{Icon::Check, "check"},
    IconFile{Icon::Warning, "warning"},
    IconFile{Icon::EmptyCircle, "empty-circle"},
    IconFile{Icon::Dot, "dot"},
    IconFile{Icon::HalfCircle, "half-circle"},
    IconFile{Icon::Spinner, "spinner"},
    IconFile{Icon::Undo, "undo"},
    IconFile{Icon::Redo, "redo"},
    IconFile{Icon::Help, "help"},
    IconFile{Icon::Search, "search"},
    IconFile{Icon::Report, "report"},
    IconFile{Icon::Export, "export"},
    IconFile{Icon::Settings, "settings"},
    IconFile{Icon::Robot, "robot"},
    IconFile{Icon::Route, "route"},
    IconFile{Icon::Label, "label"},
    IconFile{Icon::ChevronDown, "chevron-down"},
    IconFile{Icon::ChevronUp, "chevron-up"},
    IconFile{Icon::ChevronLeft, "chevron-left"},
    IconFile{Icon::ChevronRight, "chevron-right"},
    IconFile{Icon::Close, "close"},
    IconFile{Icon::Sun, "sun"},
    IconFile{Icon::Moon, "moon"},
    IconFile{Icon::Plus, "plus"},
    IconFile{Icon::Minus, "minus"},
    IconFile{Icon::Trash, "trash"},
    IconFile{Icon::Hide, "hide"},
    IconFile{Icon::Histogram, "histogram"},
    IconFile{Icon::Info, "info"},
    IconFile{Icon::Link, "link"},
    IconFile{Icon::Target, "target"},
    IconFile{Icon::Outline, "outline"},
    IconFile{Icon::Contrast, "contrast"},
    IconFile{Icon::Comment, "comment"},
    IconFile{Icon::Table, "table"},
    IconFile{Icon::Grid, "grid"},
    IconFile{Icon::Keyboard, "keyboard"},
    IconFile{Icon::Copy, "copy"},
    IconFile{Icon::Pin, "pin"},
};

QString pathOf(Icon name) {
    loadIconResource();
    for (const IconFile& entry : kFiles) {
        if (entry.name == name) return QStringLiteral(":/fodscope/icons/%1.svg").arg(QLatin1String(entry.file));
    }
    return {};
}

// QtSvg does not know currentColor, so it is replaced by the colour itself.
QByteArray colouredSvg(Icon name, const QColor& colour) {
    QFile file(pathOf(name));
    if (!file.open(QIODevice::ReadOnly)) return {};
    QByteArray svg = file.readAll();
    svg.replace("currentColor", colour.name(QColor::HexRgb).toLatin1());
    return svg;
}

class ThemedIconEngine : public QIconEngine {
  public:
    ThemedIconEngine(Icon name, std::optional<QColor> colour) : name_(name), colour_(std::move(colour)) {}

    void paint(QPainter* painter, const QRect& area, QIcon::Mode mode, QIcon::State) override {
        const double ratio = painter->device() ? painter->device()->devicePixelRatioF() : 1.0;
        const int size_px = std::min(area.width(), area.height());
        QRect square(0, 0, size_px, size_px);
        square.moveCenter(area.center());
        painter->drawPixmap(square, iconPixmap(name_, colourOf(mode), size_px, ratio));
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State) override {
        return iconPixmap(name_, colourOf(mode), std::min(size.width(), size.height()));
    }

    QIconEngine* clone() const override { return new ThemedIconEngine(*this); }

  private:
    QColor colourOf(QIcon::Mode mode) const {
        const Theme theme = currentTheme();
        if (mode == QIcon::Disabled) return theme.disabled;
        return colour_.value_or(theme.text);
    }

    Icon name_;
    std::optional<QColor> colour_;
};

}  // namespace

QIcon icon(Icon name) {
    return QIcon(new ThemedIconEngine(name, std::nullopt));
}

QIcon icon(Icon name, const QColor& colour) {
    return QIcon(new ThemedIconEngine(name, colour));
}

QPixmap iconPixmap(Icon name, const QColor& colour, int size_px, double devicePixelRatio) {
    const int edge = std::max(1, qRound(size_px * devicePixelRatio));
    const QString key =
        QStringLiteral("fodscope-icon-%1-%2-%3").arg(static_cast<int>(name)).arg(colour.rgba()).arg(edge);
    QPixmap pixmap;
    if (!QPixmapCache::find(key, &pixmap)) {
        pixmap = QPixmap(edge, edge);
        pixmap.fill(Qt::transparent);
        QSvgRenderer renderer(colouredSvg(name, colour));
        QPainter painter(&pixmap);
        painter.setOpacity(colour.alphaF());
        renderer.render(&painter, QRectF(0, 0, edge, edge));
        painter.end();
        QPixmapCache::insert(key, pixmap);
    }
    pixmap.setDevicePixelRatio(devicePixelRatio);
    return pixmap;
}

QIcon applicationIcon() {
    loadIconResource();
    return QIcon(QStringLiteral(":/fodscope/icons/fodscope.svg"));
}

}  // namespace fodscope
