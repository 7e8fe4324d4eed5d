// SPDX-License-Identifier: MIT
#include "ui/view3d/LabelPlacement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace fodscope {
namespace {

constexpr double kGap_px = 3.0;
constexpr std::array<double, 4> kRings_px = {26.0, 44.0, 68.0, 98.0};
// Up and to the right first, as a label is read; degrees counter-clockwise from the right.
constexpr std::array<double, 8> kDirections_deg = {50.0, 130.0, 20.0, 160.0, 90.0, -30.0, -150.0, -90.0};

QRectF boxAt(const LabelRequest& request, double ring_px, double direction_deg) {
    const double angle = direction_deg * 3.14159265358979323846 / 180.0;
    const QPointF tip(request.anchor.x() + ring_px * std::cos(angle), request.anchor.y() - ring_px * std::sin(angle));
    QRectF box(QPointF(0.0, 0.0), request.size);
    // The leader line ends at the box's near edge.
    box.moveCenter(QPointF(tip.x() + 0.5 * request.size.width() * std::cos(angle), tip.y()));
    return box;
}

bool isFree(const QRectF& box, const std::vector<QRectF>& taken) {
    const QRectF grown = box.adjusted(-kGap_px, -kGap_px, kGap_px, kGap_px);
    return std::none_of(taken.begin(), taken.end(), [&](const QRectF& other) { return grown.intersects(other); });
}

}  // namespace

std::vector<PlacedLabel> placeLabels(std::span<const LabelRequest> requests, const QRectF& area,
                                     std::span<const QRectF> blocked) {
    std::vector<std::size_t> order(requests.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return requests[a].priority > requests[b].priority; });

    std::vector<PlacedLabel> labels(requests.size());
    std::vector<QRectF> taken(blocked.begin(), blocked.end());
    for (const std::size_t index : order) {
        const LabelRequest& request = requests[index];
        if (!area.contains(request.anchor)) continue;
        for (const double ring : kRings_px) {
            for (const double direction : kDirections_deg) {
                const QRectF box = boxAt(request, ring, direction);
                if (!area.contains(box) || !isFree(box, taken)) continue;
                labels[index] = {box, true};
                taken.push_back(box);
                break;
            }
            if (labels[index].placed) break;
        }
    }
    return labels;
}

}  // namespace fodscope
