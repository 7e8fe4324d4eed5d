// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/theme/Colours.h"
#include "ui/view3d/ScalarColours.h"
#include "ui/view3d/ViewScene.h"

// What the data of the scene looks like: colours, groups, marks.

namespace fodscope {
namespace {

constexpr double kStripeSpacings = 3.0;

Bounds boundsOf(std::span<const Eigen::Vector3d> points) {
    Bounds box;
    for (const auto& point : points)
        box.extend(point);
    return box;
}

/// A plain cloud gets lighter with height: enough to read its form without claiming a value.
std::vector<QRgb> heightTint(const PointLayer& layer, const QColor& low, const QColor& high) {
    const double bottom = layer.bounds().minimum.z();
    const double span = std::max(1e-6, layer.bounds().maximum.z() - bottom);
    std::array<QRgb, 64> table;
    for (std::size_t i = 0; i < table.size(); ++i) {
        table[i] = mixed(low, high, static_cast<double>(i) / (table.size() - 1)).rgb();
    }
    std::vector<QRgb> colours;
    colours.reserve(layer.points().size());
    for (const Eigen::Vector3f& point : layer.points()) {
        const double share = std::clamp((point.z() - bottom) / span, 0.0, 1.0);
        colours.push_back(table[static_cast<std::size_t>(share * (table.size() - 1))]);
    }
    return colours;
}

std::vector<PointGroup> groupsByValue(const PointValues& values) {
    IndexGroups indices = indexGroups(values.values, values.style);
    const double emphasis = values.style.threshold ? kAboveEmphasis : 1.0;
    return {PointGroup{std::move(indices.below), 1.0, 1.0}, PointGroup{std::move(indices.above), emphasis, 1.0},
            values.style.stripesUnknown ? PointGroup{std::move(indices.unknown), 1.0, 1.0}
                                        : PointGroup{std::move(indices.unknown), 0.6, 0.45}};
}

/// Oblique stripes through space, so that they are hatching on a floor and on a wall.
void stripeUnknown(std::vector<QRgb>& colours, const PointLayer& layer, const PointValues& values, const Theme& theme) {
    const double stripe_m = std::max(0.06, kStripeSpacings * layer.spacing_m());
    const QRgb dark = mixed(theme.surface0, theme.muted, 0.3).rgb();
    const QRgb light = mixed(theme.surface0, theme.muted, 0.8).rgb();
    for (std::size_t i = 0; i < colours.size(); ++i) {
        if (!std::isnan(values.values[i])) continue;
        const Eigen::Vector3f& point = layer.points()[i];
        const auto number = static_cast<long>(std::floor((point.x() + point.y() + point.z()) / stripe_m));
        colours[i] = number % 2 == 0 ? light : dark;
    }
}

}  // namespace

void ViewScene::colourReference() {
    if (reference_.empty()) return;
    if (referenceValues_.empty()) {
        reference_.setOneGroup();
        reference_.setColours(heightTint(reference_, mixed(theme_.surface0, theme_.muted, 0.42),
                                         mixed(theme_.surface0, theme_.muted, 0.85)));
        return;
    }
    std::vector<QRgb> colours = scalarColours(referenceValues_.values, referenceValues_.style, theme_);
    if (referenceValues_.style.stripesUnknown) stripeUnknown(colours, reference_, referenceValues_, theme_);
    reference_.setColours(colours);
    reference_.setGroups(groupsByValue(referenceValues_));
}

void ViewScene::colourMap() {
    if (map_.empty()) return;
    map_.setColours(heightTint(map_, mixed(theme_.muted, theme_.text, 0.1), mixed(theme_.muted, theme_.text, 0.8)));
}

void ViewScene::colourDiscrepancy() {
    if (discrepancy_.empty()) {
        discrepant_.setPoints({}, {}, {});
        return;
    }
    PointValues below = discrepancyValues_;
    if (below.style.threshold) below.style.threshold = std::numeric_limits<double>::infinity();
    discrepancy_.setColours(scalarColours(below.values, below.style, theme_));
    discrepancy_.setGroups(groupsByValue(below));
    drawDiscrepant();
}

/// The work grows with the points above the threshold, not with the cloud.
void ViewScene::drawDiscrepant() {
    std::vector<Eigen::Vector3d> points;
    std::vector<double> values;
    PointGroup group{{}, kAboveEmphasis, 1.0};
    if (discrepancyValues_.style.threshold) {
        for (const std::uint32_t index : byDiscrepancy_) {
            const double value = discrepancyValues_.values[index];
            if (!(value > *discrepancyValues_.style.threshold)) break;
            group.indices.push_back(static_cast<std::int64_t>(points.size()));
            points.push_back(discrepancy_.points()[index].cast<double>());
            values.push_back(value);
        }
    }
    discrepant_.setPoints(points, scalarColours(values, discrepancyValues_.style, theme_), {std::move(group)});
}

void ViewScene::buildCandidates() {
    std::vector<Eigen::Vector3d> points;
    std::vector<QRgb> colours;
    PointGroup shown;
    PointGroup faint{{}, 0.7, 0.35};
    candidateOfPoint_.clear();
    for (std::size_t index = 0; index < candidates_.size(); ++index) {
        ViewCandidate& candidate = candidates_[index];
        if (!candidate.colour.isValid()) candidate.colour = candidateColour(candidate.id);
        PointGroup& group = candidate.faint ? faint : shown;
        for (const Eigen::Vector3d& point : candidate.points) {
            group.indices.push_back(static_cast<std::int64_t>(points.size()));
            points.push_back(point);
            colours.push_back(candidate.colour.rgb());
            candidateOfPoint_.push_back(static_cast<std::uint32_t>(index));
        }
    }
    candidatePoints_.setPoints(points, colours, {std::move(shown), std::move(faint)});
    if (discrepancy_.empty()) candidatePoints_.measureSpacing();
    markSelection();
}

void ViewScene::markSelection() {
    Shapes brackets;
    for (const ViewCandidate& candidate : candidates_) {
        if (!candidate.selected) continue;
        Bounds box = boundsOf(candidate.points);
        if (box.empty()) box.extend(candidate.centroid);
        brackets = bracketShapes(box, theme_.accent);
    }
    selection_.setShapes(brackets);
    selection_.setVisible(isVisible(ViewLayer::Candidates));
}

void ViewScene::buildShapes() {
    grid_.setShapes(gridShapes(bounds(), floor_m_, theme_));
    waypointMarks_.setShapes(waypointShapes(waypoints_, floor_m_, theme_));
    routeLine_.setShapes(lineShapes(route_, theme_.text));
    trajectoryLine_.setShapes(lineShapes(trajectory_, theme_.muted));
    robotMark_.setShapes(robot_ ? robotShapes(*robot_, floor_m_, theme_) : Shapes());
    for (const ViewLayer layer :
         {ViewLayer::Grid, ViewLayer::Waypoints, ViewLayer::Route, ViewLayer::Trajectory, ViewLayer::Robot}) {
        apply(layer);
    }
}

}  // namespace fodscope
