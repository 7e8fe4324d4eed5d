// SPDX-License-Identifier: MIT
#include "core/cloud/BlockOrder.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>

namespace fodscope {
namespace {

/// What the sorting moves about, so that it need not look the points up.
struct Item {
    std::array<double, 3> at;
    std::uint32_t index;
};

std::size_t longestSide(std::span<const Item> items) {
    std::array<double, 3> low = items.front().at;
    std::array<double, 3> high = low;
    for (const Item& item : items) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], item.at[axis]);
            high[axis] = std::max(high[axis], item.at[axis]);
        }
    }
    std::size_t longest = 0;
    // Halved before subtracting: the extent of points near the largest double would overflow.
    const auto length = [&](std::size_t axis) { return 0.5 * high[axis] - 0.5 * low[axis]; };
    for (std::size_t axis = 1; axis < 3; ++axis) {
        if (length(axis) > length(longest)) longest = axis;
    }
    return longest;
}

/// Divides into parts of `part` items, the last one shorter; `part` is a block, or 8, 64, … of them.
void divideInto(std::size_t part, std::span<Item> items);

/// Orders one such part within itself.
void orderWithin(std::size_t part, std::span<Item> items) {
    if (part > kBlockSize) divideInto(part / kBlockFan, items);
}

void divideInto(std::size_t part, std::span<Item> items) {
    constexpr std::size_t kWorthAThread = 1 << 13;
    if (items.size() <= part) {
        orderWithin(part, items);
        return;
    }
    const std::size_t parts = (items.size() + part - 1) / part;
    const std::size_t middle = (parts + 1) / 2 * part;
    const std::size_t axis = longestSide(items);
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(middle), items.end(),
                     [axis](const Item& a, const Item& b) { return a.at[axis] < b.at[axis]; });
    const auto left = [&] { divideInto(part, items.first(middle)); };
    const auto right = [&] { divideInto(part, items.subspan(middle)); };
    if (items.size() < kWorthAThread) {
        left();
        right();
    } else {
        tbb::parallel_invoke(left, right);
    }
}

}  // namespace

std::vector<std::uint32_t> blockOrder(std::span<const Eigen::Vector3d> points) {
    std::vector<Item> items(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        items[i] = {{points[i].x(), points[i].y(), points[i].z()}, static_cast<std::uint32_t>(i)};
    std::size_t part = kBlockSize;
    while (part < points.size())
        part *= kBlockFan;
    orderWithin(part, items);
    std::vector<std::uint32_t> order(points.size());
    std::ranges::transform(items, order.begin(), &Item::index);
    return order;
}

}  // namespace fodscope
