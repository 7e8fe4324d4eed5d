// SPDX-License-Identifier: MIT
#include "core/simulation/EarClipping.h"

#include <numeric>

namespace fodscope {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool inside(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& p) {
    return cross(a, b, p) > 0.0 && cross(b, c, p) > 0.0 && cross(c, a, p) > 0.0;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> earClipping(const std::vector<Eigen::Vector2d>& outline) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> left(outline.size());
    std::iota(left.begin(), left.end(), 0u);
    const auto isEar = [&](std::size_t i) {
        const std::size_t count = left.size();
        const Eigen::Vector2d &a = outline[left[(i + count - 1) % count]], &b = outline[left[i]],
                              &c = outline[left[(i + 1) % count]];
        if (cross(a, b, c) <= 0.0) return false;
        for (const std::uint32_t other : left)
            if (inside(a, b, c, outline[other])) return false;
        return true;
    };
    while (left.size() > 3) {
        std::size_t ear = left.size();
        for (std::size_t i = 0; i < left.size() && ear == left.size(); ++i)
            if (isEar(i)) ear = i;
        // What is left is flat: clipping any corner loses no area.
        const bool flat = ear == left.size();
        if (flat) ear = 0;
        const std::size_t count = left.size();
        if (!flat) triangles.push_back({left[(ear + count - 1) % count], left[ear], left[(ear + 1) % count]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    if (left.size() == 3) triangles.push_back({left[0], left[1], left[2]});
    return triangles;
}

}  // namespace fodscope
