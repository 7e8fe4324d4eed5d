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

/// Boxes by the squares of the area that they reach into, so that a new one is compared with those about it only.
class TakenBoxes {
  public:
    explicit TakenBoxes(const QRectF& area)
        : corner_(area.topLeft()),
          columns_(std::max(1, static_cast<int>(std::ceil(area.width() / kSquare_px)))),
          rows_(std::max(1, static_cast<int>(std::ceil(area.height() / kSquare_px)))),
          squares_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

    void add(const QRectF& box) {
        forEachSquare(box, [&](std::vector<QRectF>& boxes) {
            boxes.push_back(box);
            return true;
        });
    }

    bool isFree(const QRectF& box) {
        const QRectF grown = box.adjusted(-kGap_px, -kGap_px, kGap_px, kGap_px);
        return forEachSquare(grown, [&](const std::vector<QRectF>& boxes) {
            return std::none_of(boxes.begin(), boxes.end(),
                                [&](const QRectF& other) { return grown.intersects(other); });
        });
    }

  private:
    static constexpr double kSquare_px = 64.0;

    /// @return false as soon as `act` does
    template <typename Act>
    bool forEachSquare(const QRectF& box, const Act& act) {
        const auto square = [](double distance_px, int count) {
            return std::clamp(static_cast<int>(std::floor(distance_px / kSquare_px)), 0, count - 1);
        };
        const int right = square(box.right() - corner_.x(), columns_);
        const int bottom = square(box.bottom() - corner_.y(), rows_);
        for (int row = square(box.top() - corner_.y(), rows_); row <= bottom; ++row)
            for (int column = square(box.left() - corner_.x(), columns_); column <= right; ++column)
                if (!act(squares_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                                  static_cast<std::size_t>(column)]))
                    return false;
        return true;
    }

    QPointF corner_;
    int columns_;
    int rows_;
    std::vector<std::vector<QRectF>> squares_;
};

}  // namespace

std::vector<PlacedLabel> placeLabels(std::span<const LabelRequest> requests, const QRectF& area,
                                     std::span<const QRectF> blocked) {
    std::vector<std::size_t> order(requests.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return requests[a].priority > requests[b].priority; });

    std::vector<PlacedLabel> labels(requests.size());
    TakenBoxes taken(area);
    for (const QRectF& box : blocked)
        taken.add(box);
    for (const std::size_t index : order) {
        const LabelRequest& request = requests[index];
        if (!area.contains(request.anchor)) continue;
        for (const double ring : kRings_px) {
            for (const double direction : kDirections_deg) {
                const QRectF box = boxAt(request, ring, direction);
                if (!area.contains(box) || !taken.isFree(box)) continue;
                labels[index] = {box, true};
                taken.add(box);
                break;
            }
            if (labels[index].placed) break;
        }
    }
    return labels;
}

}  // namespace fodscope
