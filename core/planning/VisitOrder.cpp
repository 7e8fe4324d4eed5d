// SPDX-License-Identifier: MIT
#include "core/planning/VisitOrder.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace fodscope {
namespace {

using Order = std::vector<std::size_t>;

constexpr std::size_t kMostForExact = 12;
/// Shortenings smaller than this are rounding.
constexpr double kSlack_m = 1e-9;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Held and Karp: the shortest way over each subset that ends at each of its members.
Order exactOrder(const Eigen::MatrixXd& lengths_m) {
    const auto count = static_cast<std::size_t>(lengths_m.rows()) - 1;
    const auto length = [&](std::size_t a, std::size_t b) {
        return lengths_m(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
    };
    const std::size_t subsets = std::size_t{1} << count;
    std::vector<double> least_m(subsets * count, kInfinity);
    std::vector<std::size_t> before(subsets * count, count);
    for (std::size_t last = 0; last < count; ++last)
        least_m[(std::size_t{1} << last) * count + last] = length(0, last + 1);
    for (std::size_t subset = 1; subset < subsets; ++subset) {
        for (std::size_t last = 0; last < count; ++last) {
            const double here_m = least_m[subset * count + last];
            if (!(here_m < kInfinity)) continue;
            for (std::size_t next = 0; next < count; ++next) {
                if ((subset >> next & 1) != 0) continue;
                const std::size_t state = (subset | std::size_t{1} << next) * count + next;
                const double there_m = here_m + length(last + 1, next + 1);
                if (!(there_m < least_m[state])) continue;
                least_m[state] = there_m;
                before[state] = last;
            }
        }
    }
    Order order;
    std::size_t subset = subsets - 1;
    std::size_t last = 0;
    for (std::size_t end = 1; end < count; ++end)
        if (least_m[subset * count + end] < least_m[subset * count + last]) last = end;
    while (subset != 0) {
        order.push_back(last + 1);
        const std::size_t previous = before[subset * count + last];
        subset &= ~(std::size_t{1} << last);
        last = previous;
    }
    std::ranges::reverse(order);
    return order;
}

/// Puts each place where it lengthens the tour least, the one that lengthens it least first.
Order insertionOrder(const Eigen::MatrixXd& lengths_m) {
    const auto count = static_cast<std::size_t>(lengths_m.rows());
    const auto length = [&](std::size_t a, std::size_t b) {
        return lengths_m(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
    };
    Order tour{0};
    std::vector<std::uint8_t> isIn(count, 0);
    while (tour.size() < count) {
        double least_m = kInfinity;
        std::size_t bestPlace = 0, bestPosition = 0;
        for (std::size_t place = 1; place < count; ++place) {
            if (isIn[place] != 0) continue;
            for (std::size_t position = 1; position <= tour.size(); ++position) {
                double more_m = length(tour[position - 1], place);
                if (position < tour.size())
                    more_m += length(place, tour[position]) - length(tour[position - 1], tour[position]);
                if (!(more_m < least_m)) continue;
                least_m = more_m;
                bestPlace = place;
                bestPosition = position;
            }
        }
        tour.insert(tour.begin() + static_cast<std::ptrdiff_t>(bestPosition), bestPlace);
        isIn[bestPlace] = 1;
    }
    tour.erase(tour.begin());
    return tour;
}

/// Turns stretches round and moves up to three visits elsewhere, as long as that shortens the tour.
Order shortened(Order order, const Eigen::MatrixXd& lengths_m) {
    double length_m = lengthOf(order, lengths_m);
    const auto tryOut = [&](const Order& other) {
        const double other_m = lengthOf(other, lengths_m);
        if (!(other_m < length_m - kSlack_m)) return false;
        order = other;
        length_m = other_m;
        return true;
    };
    bool isShorter = true;
    while (isShorter) {
        isShorter = false;
        const auto count = static_cast<std::ptrdiff_t>(order.size());
        for (std::ptrdiff_t first = 0; first < count; ++first) {
            for (std::ptrdiff_t last = first + 1; last < count; ++last) {
                Order other = order;
                std::reverse(other.begin() + first, other.begin() + last + 1);
                isShorter = tryOut(other) || isShorter;
            }
        }
        for (std::ptrdiff_t size = 1; size <= std::min<std::ptrdiff_t>(3, count - 1); ++size) {
            for (std::ptrdiff_t from = 0; from + size <= count; ++from) {
                for (std::ptrdiff_t to = 0; to + size <= count; ++to) {
                    Order other = order;
                    const Order moved(other.begin() + from, other.begin() + from + size);
                    other.erase(other.begin() + from, other.begin() + from + size);
                    other.insert(other.begin() + to, moved.begin(), moved.end());
                    isShorter = tryOut(other) || isShorter;
                }
            }
        }
    }
    return order;
}

}  // namespace

VisitLegs::VisitLegs(const CostMap& collision, std::span<const Eigen::Vector2d> places_map, Progress& progress) {
    const auto count = static_cast<Eigen::Index>(places_map.size());
    lengths_m_ = Eigen::MatrixXd::Constant(count, count, kInfinity);
    lengths_m_.diagonal().setZero();
    for (std::size_t from = 0; from < places_map.size(); ++from) {
        progress.report("measuring the drives", static_cast<double>(from) / static_cast<double>(places_map.size()));
        std::optional<TravelField> field;
        if (from + 1 < places_map.size()) field.emplace(collision, places_map[from]);
        for (std::size_t to = from + 1; to < places_map.size(); ++to) {
            const auto path = field->pathTo(places_map[to]);
            drives_.push_back(path.value_or(DrivePath{{}, kInfinity}));
            const auto row = static_cast<Eigen::Index>(from), column = static_cast<Eigen::Index>(to);
            lengths_m_(row, column) = lengths_m_(column, row) = drives_.back().length_m;
        }
    }
}

DrivePath VisitLegs::drive(std::size_t from, std::size_t to) const {
    if (from == to) return {};
    const auto [low, high] = std::minmax(from, to);
    const auto count = static_cast<std::size_t>(lengths_m_.rows());
    DrivePath path = drives_[low * (2 * count - low - 1) / 2 + high - low - 1];
    if (from > to) std::ranges::reverse(path.points_map);
    return path;
}

std::vector<std::size_t> nearestNextOrder(const Eigen::MatrixXd& lengths_m) {
    Order left(static_cast<std::size_t>(std::max<Eigen::Index>(lengths_m.rows(), 1)) - 1);
    std::iota(left.begin(), left.end(), std::size_t{1});
    Order order;
    std::size_t here = 0;
    while (!left.empty()) {
        const auto next = std::ranges::min_element(left, {}, [&](std::size_t place) {
            return lengths_m(static_cast<Eigen::Index>(here), static_cast<Eigen::Index>(place));
        });
        here = *next;
        order.push_back(here);
        left.erase(next);
    }
    return order;
}

std::vector<std::size_t> shortestOrder(const Eigen::MatrixXd& lengths_m) {
    const Order nearest = nearestNextOrder(lengths_m);
    if (nearest.size() < 2) return nearest;
    if (nearest.size() <= kMostForExact) return exactOrder(lengths_m);
    const Order a = shortened(nearest, lengths_m);
    const Order b = shortened(insertionOrder(lengths_m), lengths_m);
    return lengthOf(b, lengths_m) < lengthOf(a, lengths_m) - kSlack_m ? b : a;
}

double lengthOf(std::span<const std::size_t> order, const Eigen::MatrixXd& lengths_m) {
    double length_m = 0.0;
    std::size_t here = 0;
    for (const std::size_t next : order) {
        length_m += lengths_m(static_cast<Eigen::Index>(here), static_cast<Eigen::Index>(next));
        here = next;
    }
    return length_m;
}

}  // namespace fodscope
