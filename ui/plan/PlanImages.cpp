// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>

#include "ui/plan/PlanPainter.h"
#include "ui/theme/Colours.h"

namespace fodscope {

namespace {

constexpr int kLargestEdge = 4096;

struct CellColours {
    QRgb free;
    QRgb occupied;
    QRgb shadedFrom;
    QRgb shadedTo;
    QRgb inscribed;
};

CellColours cellColours(const Theme& theme) {
    const bool dark = theme.kind == ThemeKind::Dark;
    const QColor free = dark ? theme.surface2 : theme.surface1;
    const QColor wall = dark ? mixed(theme.muted, theme.surface2, 0.15) : mixed(theme.text, theme.muted, 0.35);
    return {free.rgba(), wall.rgba(), mixed(free, wall, 0.06).rgba(), mixed(free, wall, 0.38).rgba(),
            mixed(free, wall, 0.5).rgba()};
}

QRgb cellColour(const CostMap& map, CellIndex index, const CellColours& colours) {
    const Cell cell = map.grid.at(index);
    if (cell == Cell::Occupied) return colours.occupied;
    if (cell == Cell::Unknown) return qRgba(0, 0, 0, 0);
    const std::uint8_t cost = map.costs.empty() ? kCostFree : map.costAt(index);
    if (cost == kCostFree) return colours.free;
    if (cost >= kCostInscribed) return colours.inscribed;
    return mixed(QColor(colours.shadedFrom), QColor(colours.shadedTo), cost / 252.0).rgba();
}

bool isUnreachable(const CostMap& map, CellIndex index) {
    if (map.reachable.empty() || map.costs.empty() || map.grid.at(index) != Cell::Free) return false;
    return map.costAt(index) < kCostInscribed && !map.isReachable(index);
}

/// The cell that stands for a block of cells: an obstacle in it must not vanish.
CellIndex mostTelling(const CostMap& map, CellIndex first, int edge) {
    CellIndex best = first;
    int bestCost = -1;
    for (int row = first.row; row < std::min(first.row + edge, map.grid.height); ++row) {
        for (int column = first.column; column < std::min(first.column + edge, map.grid.width); ++column) {
            const CellIndex index{column, row};
            const Cell cell = map.grid.at(index);
            int cost = cell == Cell::Occupied ? 300 : cell == Cell::Unknown ? 0 : 1;
            if (cell == Cell::Free && !map.costs.empty()) cost += map.costAt(index);
            if (cost > bestCost) {
                bestCost = cost;
                best = index;
            }
        }
    }
    return best;
}

}  // namespace

QColor hatchColour(const Theme& theme, bool unreachable) {
    return unreachable ? mixed(theme.surface2, theme.attention, 0.6) : mixed(theme.surface0, theme.muted, 0.4);
}

PlanImages planImages(const PlanScene& scene, const Theme& theme) {
    PlanImages images;
    if (!scene.costMap) return images;
    const CostMap& map = *scene.costMap;
    const int longest = std::max(map.grid.width, map.grid.height);
    const int edge = std::max(1, (longest + kLargestEdge - 1) / kLargestEdge);
    images.cellsPerPixel = edge;
    const QSize size((map.grid.width + edge - 1) / edge, (map.grid.height + edge - 1) / edge);
    images.cells = QImage(size, QImage::Format_ARGB32_Premultiplied);
    images.unknown = QImage(size, QImage::Format_ARGB32_Premultiplied);
    images.unreachable = QImage(size, QImage::Format_ARGB32_Premultiplied);
    const CellColours colours = cellColours(theme);
    constexpr QRgb kOpaque = 0xff000000U;
    for (int y = 0; y < size.height(); ++y) {
        auto* cells = reinterpret_cast<QRgb*>(images.cells.scanLine(y));
        auto* unknown = reinterpret_cast<QRgb*>(images.unknown.scanLine(y));
        auto* unreachable = reinterpret_cast<QRgb*>(images.unreachable.scanLine(y));
        for (int x = 0; x < size.width(); ++x) {
            const CellIndex first{x * edge, y * edge};
            const CellIndex index = edge == 1 ? first : mostTelling(map, first, edge);
            cells[x] = cellColour(map, index, colours);
            unknown[x] = map.grid.at(index) == Cell::Unknown ? kOpaque : 0U;
            unreachable[x] = isUnreachable(map, index) ? kOpaque : 0U;
        }
    }
    return images;
}

PlanImages forPrint(const PlanImages& images) {
    constexpr int kEdge_px = 1600;
    const int longest = std::max(images.cells.width(), images.cells.height());
    if (longest == 0 || longest > kEdge_px / 2) return images;
    const int factor = kEdge_px / longest;
    const auto enlarged = [factor](const QImage& image) {
        return image.scaled(image.size() * factor, Qt::IgnoreAspectRatio, Qt::FastTransformation);
    };
    return {enlarged(images.cells), enlarged(images.unknown), enlarged(images.unreachable),
            images.cellsPerPixel / factor};
}

}  // namespace fodscope
