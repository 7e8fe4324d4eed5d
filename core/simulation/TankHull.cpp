// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "core/simulation/TankParts.h"

namespace fodscope {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr Rgb kPlate{202, 200, 190};
constexpr double kPi = std::numbers::pi;

std::vector<double> stations(double length, int count) {
    std::vector<double> values;
    for (int i = 0; i <= count; ++i)
        values.push_back(length * i / count);
    return values;
}

/// The plan of floor or deck: straight on three sides, along the shell on the fourth.
Outline planAt(const TankPlan& plan, double z) {
    Outline outline{{0.0, 0.0}, {plan.length, 0.0}};
    const std::vector<double> xs = stations(plan.length, 24);
    for (auto x = xs.rbegin(); x != xs.rend(); ++x)
        outline.emplace_back(*x, plan.shellY(*x, z));
    return outline;
}

TriangleMesh shell(const TankPlan& plan) {
    TriangleMesh mesh;
    const std::vector<double> xs = stations(plan.length, 24), zs = plan.shellHeights();
    const auto at = [&](double x, double z) { return Vector3d(x, plan.shellY(x, z), z); };
    for (std::size_t i = 0; i + 1 < xs.size(); ++i)
        for (std::size_t k = 0; k + 1 < zs.size(); ++k)
            append(mesh, quadMesh(at(xs[i], zs[k]), at(xs[i + 1], zs[k]), at(xs[i + 1], zs[k + 1]),
                                  at(xs[i], zs[k + 1]), kPlate));
    return mesh;
}

TriangleMesh endBulkhead(const TankPlan& plan, double x, bool facesForward) {
    Outline outline{{0.0, 0.0}};
    for (const double z : plan.shellHeights())
        outline.emplace_back(plan.shellY(x, z), z);
    outline.emplace_back(0.0, plan.height);
    TriangleMesh mesh = flatMesh(outline, kPlate);
    Transform pose = Transform::Identity();
    pose.linear().col(0) = Vector3d::UnitY();
    pose.linear().col(1) = Vector3d::UnitZ();
    pose.linear().col(2) = Vector3d::UnitX();
    pose.translation().x() = x;
    mesh = transformed(mesh, pose);
    if (!facesForward)
        for (auto& triangle : mesh.triangles)
            std::swap(triangle[1], triangle[2]);
    return mesh;
}

/// The deck with its hole: the outline runs to the hole over a bridge, round it clockwise, and back.
TriangleMesh deck(const TankPlan& plan) {
    const Vector2d centre = accessHoleCentre(plan), radii = accessHoleRadii(plan);
    Outline outline = planAt(plan, plan.height);
    outline.push_back(outline.front());
    constexpr int kSegments = 40;
    for (int i = 0; i <= kSegments; ++i) {
        // From the side of corner (0, 0), where the bridge starts.
        const double angle = -0.75 * kPi - 2.0 * kPi * i / kSegments;
        outline.emplace_back(centre + Vector2d(radii.x() * std::cos(angle), radii.y() * std::sin(angle)));
    }
    TriangleMesh mesh = flatMesh(outline, kPlate);
    for (auto& triangle : mesh.triangles)
        std::swap(triangle[1], triangle[2]);
    mesh = translated(mesh, {0.0, 0.0, plan.height});
    std::vector<Vector3d> low, high;
    for (int i = 0; i <= kSegments; ++i) {
        const double angle = 2.0 * kPi * i / kSegments;
        const Vector2d p = centre + Vector2d(radii.x() * std::cos(angle), radii.y() * std::sin(angle));
        low.emplace_back(p.x(), p.y(), plan.height);
        high.emplace_back(p.x(), p.y(), plan.height + 0.06);
    }
    for (std::size_t i = 0; i + 1 < low.size(); ++i)
        append(mesh, quadMesh(low[i + 1], low[i], high[i], high[i + 1], kPlate));
    return mesh;
}

}  // namespace

double TankPlan::shellY(double x, double z) const {
    const double along = (x / length - 0.35) / 0.65;
    const double side = width * (1.0 - 0.036 * along * along);
    const double radius = bilgeRadius();
    if (z >= radius) return side;
    const double below = radius - std::max(0.0, z);
    return side - (radius - std::sqrt(std::max(0.0, radius * radius - below * below)));
}

std::vector<double> TankPlan::shellHeights() const {
    std::vector<double> heights;
    constexpr int kArc = 12;
    for (int i = 0; i <= kArc; ++i)
        heights.push_back(bilgeRadius() * (1.0 - std::cos(0.5 * kPi * i / kArc)));
    for (int i = 1; i <= 4; ++i)
        heights.push_back(bilgeRadius() + (height - bilgeRadius()) * i / 4);
    return heights;
}

Eigen::Vector3d TankPlan::misplacement() {
    const double angle = random_.uniform(0.0, 2.0 * kPi);
    const double by = deviation_ * random_.uniform(0.5, 1.0);
    return {by * std::cos(angle), by * std::sin(angle), 0.0};
}

double TankPlan::slip() {
    return deviation_ * random_.uniform(-1.0, 1.0);
}

Vector2d accessHoleCentre(const TankPlan& plan) {
    return {0.22 * plan.length, 0.23 * plan.width};
}

Vector2d accessHoleRadii(const TankPlan& plan) {
    return {std::min(0.30, 0.15 * plan.length), std::min(0.20, 0.12 * plan.width)};
}

TriangleMesh tankHull(const TankPlan& plan) {
    TriangleMesh mesh = flatMesh(planAt(plan, 0.0), kPlate);
    append(mesh, shell(plan));
    append(mesh, quadMesh({plan.length, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, plan.height},
                          {plan.length, 0.0, plan.height}, kPlate));
    append(mesh, endBulkhead(plan, 0.0, true));
    append(mesh, endBulkhead(plan, plan.length, false));
    append(mesh, deck(plan));
    return mesh;
}

}  // namespace fodscope
