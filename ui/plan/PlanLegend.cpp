// SPDX-License-Identifier: MIT
#include <QFontMetricsF>
#include <QObject>
#include <QPainter>
#include <algorithm>
#include <functional>
#include <set>

#include "ui/plan/PlanPainter.h"
#include "ui/plan/PlanSigns.h"
#include "ui/theme/Colours.h"

namespace fodscope {

namespace {

struct Entry {
    QString word;
    /// Paints the sign into a box of kSign_px square.
    std::function<void(QPainter&, const QRectF&)> sign;
};

constexpr double kSign_px = 20.0;
constexpr double kRow_px = 26.0;
constexpr double kGap_px = 16.0;

enum class Swatch { Free, NearObstacle, Obstacle, Unknown, Unreachable };

/// A swatch is a plan of one cell, so that it cannot differ from the drawing.
PlanScene oneCellScene(Swatch kind) {
    auto map = std::make_shared<CostMap>();
    map->grid.width = map->grid.height = 1;
    map->grid.cells = {kind == Swatch::Obstacle  ? Cell::Occupied
                       : kind == Swatch::Unknown ? Cell::Unknown
                                                 : Cell::Free};
    map->costs = {kind == Swatch::NearObstacle ? static_cast<std::uint8_t>(kCostInscribed - 60) : kCostFree};
    if (kind == Swatch::Unreachable) map->reachable = {0};
    PlanScene scene;
    scene.costMap = map;
    return scene;
}

void paintSwatchHatch(QPainter& painter, const QRectF& place, const QColor& colour, double lean) {
    painter.save();
    painter.setClipRect(place, Qt::IntersectClip);
    painter.setPen(QPen(colour, 1.0));
    for (double x = place.left() - 20.0; x < place.right() + 20.0; x += 5.0) {
        painter.drawLine(QPointF(x, place.top()), QPointF(x + lean * place.height(), place.bottom()));
    }
    painter.restore();
}

Entry swatch(const QString& word, Swatch kind, const Theme& theme) {
    return {word, [kind, theme](QPainter& painter, const QRectF& box) {
                const QRectF place = box.adjusted(2, 3, -2, -3);
                const PlanImages images = planImages(oneCellScene(kind), theme);
                painter.fillRect(place, theme.surface0);
                painter.drawImage(place, images.cells);
                if (kind == Swatch::Unknown) paintSwatchHatch(painter, place, hatchColour(theme, false), -1.0);
                if (kind == Swatch::Unreachable) paintSwatchHatch(painter, place, hatchColour(theme, true), 1.0);
                painter.setPen(QPen(theme.line, 1.0));
                painter.setBrush(Qt::NoBrush);
                painter.drawRect(place);
            }};
}

void addGridEntries(const PlanScene& scene, const Theme& theme, std::vector<Entry>& entries) {
    if (!scene.costMap) {
        if (scene.pointsFromAbove_map.empty()) return;
        entries.push_back({QObject::tr("map from above"), [theme](QPainter& painter, const QRectF& box) {
                               painter.setPen(Qt::NoPen);
                               painter.setBrush(theme.muted);
                               for (int dot = 0; dot < 6; ++dot) {
                                   painter.drawRect(
                                       QRectF(box.left() + 3 + dot * 2.5, box.center().y() - 4 + (dot * 5) % 9, 2, 2));
                               }
                           }});
        return;
    }
    const auto& cells = scene.costMap->grid.cells;
    entries.push_back(swatch(QObject::tr("free"), Swatch::Free, theme));
    entries.push_back(swatch(QObject::tr("near an obstacle"), Swatch::NearObstacle, theme));
    entries.push_back(swatch(QObject::tr("obstacle"), Swatch::Obstacle, theme));
    if (std::find(cells.begin(), cells.end(), Cell::Unknown) != cells.end()) {
        entries.push_back(swatch(QObject::tr("not observed"), Swatch::Unknown, theme));
    }
    const auto& reachable = scene.costMap->reachable;
    bool isAnyCut = false;
    for (std::size_t cell = 0; cell < reachable.size() && !isAnyCut; ++cell) {
        isAnyCut = !reachable[cell] && cells[cell] == Cell::Free && scene.costMap->costs[cell] < kCostInscribed;
    }
    if (isAnyCut) entries.push_back(swatch(QObject::tr("out of reach"), Swatch::Unreachable, theme));
}

void addCandidateEntries(const PlanScene& scene, const Theme& theme, std::vector<Entry>& entries) {
    const auto add = [&](const QString& word, Verdict verdict, bool hasNoWaypoint) {
        entries.push_back(
            {word, [=](QPainter& painter, const QRectF& box) {
                 paintCandidateSign(painter, {box.center(), 6.0, theme.text, verdict, false, hasNoWaypoint}, theme);
             }});
    };
    if (scene.candidates.empty()) return;
    add(QObject::tr("candidate"), Verdict::Undecided, false);
    const auto has = [&](auto test) { return std::any_of(scene.candidates.begin(), scene.candidates.end(), test); };
    if (has([](const PlanCandidate& each) { return each.verdict == Verdict::Finding; })) {
        add(QObject::tr("finding"), Verdict::Finding, false);
    }
    if (has([](const PlanCandidate& each) { return each.verdict == Verdict::NoFod; })) {
        add(QObject::tr("no FOD"), Verdict::NoFod, false);
    }
    if (has([](const PlanCandidate& each) { return !each.noWaypointReason.empty() && each.plannedShare == 0.0; })) {
        add(QObject::tr("no waypoint"), Verdict::Undecided, true);
    }
}

void addWaypointEntries(const PlanScene& scene, const Theme& theme, std::vector<Entry>& entries) {
    const auto add = [&](const QString& word, VisitState state) {
        entries.push_back({word, [=](QPainter& painter, const QRectF& box) {
                               painter.save();
                               painter.translate(box.center());
                               painter.scale(0.8, 0.8);
                               paintWaypointSign(painter, {0, 0}, QStringLiteral("1"), state, false, false, theme);
                               painter.restore();
                           }});
    };
    if (scene.start_map && !scene.waypoints.empty()) {
        entries.push_back({QObject::tr("start"), [theme](QPainter& painter, const QRectF& box) {
                               paintStartSign(painter, box.center(), theme);
                           }});
    }
    std::set<VisitState> shown;
    for (const PlanWaypoint& waypoint : scene.waypoints) {
        const bool underWay = statusOf(waypoint.state) == StatusKind::Running;
        shown.insert(underWay ? VisitState::Driving : waypoint.state);
    }
    for (const VisitState state : shown) {
        const bool toDo = state == VisitState::Draft;
        const QString word = toDo                           ? QObject::tr("waypoint to visit")
                             : state == VisitState::Driving ? QObject::tr("under way")
                                                            : QString::fromStdString(toString(state));
        add(word, state);
    }
}

std::vector<Entry> legendEntries(const PlanScene& scene, const PlanLook& look) {
    std::vector<Entry> entries;
    addGridEntries(scene, look.theme, entries);
    addCandidateEntries(scene, look.theme, entries);
    if (look.showVisits) addWaypointEntries(scene, look.theme, entries);
    if (look.robot) {
        entries.push_back({QObject::tr("robot"), [theme = look.theme](QPainter& painter, const QRectF& box) {
                               paintRobotSign(painter, box.center(), 8.0, 0.6, false, theme);
                           }});
    }
    return entries;
}

}  // namespace

double paintPlanLegend(QPainter& painter, const QRectF& area, const PlanScene& scene, const PlanLook& look,
                       bool paint) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font = painter.font();
    font.setPixelSize(std::max(1, static_cast<int>(look.fontPixels)));
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    QPointF at = area.topLeft() + QPointF(12.0, 5.0);
    const std::vector<Entry> entries = legendEntries(scene, look);
    for (const Entry& entry : entries) {
        const double width = kSign_px + 6.0 + metrics.horizontalAdvance(entry.word);
        if (at.x() + width > area.right() - 8.0 && at.x() > area.left() + 12.0) {
            at = QPointF(area.left() + 12.0, at.y() + kRow_px);
        }
        if (paint) {
            entry.sign(painter, QRectF(at + QPointF(0, 0.5 * (kRow_px - kSign_px)), QSizeF(kSign_px, kSign_px)));
            painter.setPen(look.theme.text);
            painter.drawText(QRectF(at.x() + kSign_px + 6.0, at.y(), width, kRow_px), Qt::AlignVCenter | Qt::AlignLeft,
                             entry.word);
        }
        at.rx() += width + kGap_px;
    }
    painter.restore();
    return entries.empty() ? 0.0 : at.y() + kRow_px + 5.0 - area.top();
}

}  // namespace fodscope
