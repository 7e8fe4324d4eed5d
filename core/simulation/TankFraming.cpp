// SPDX-License-Identifier: MIT
#include "core/simulation/TankParts.h"

namespace fodscope {
namespace {

using Eigen::Vector3d;

constexpr Rgb kFrame{194, 191, 180};
constexpr Rgb kStiffener{197, 195, 184};
constexpr double kWebThickness_m = 0.012;
constexpr double kFrameDepth_m = 0.10;

/// An outline in (y, z) as a plate across x.
TriangleMesh plateAcross(const Outline& outline, double x, double thickness, Rgb colour) {
    Transform pose = Transform::Identity();
    pose.linear().col(0) = Vector3d::UnitY();
    pose.linear().col(1) = Vector3d::UnitZ();
    pose.linear().col(2) = Vector3d::UnitX();
    pose.translation().x() = x;
    return transformed(extrudedMesh(outline, -0.5 * thickness, 0.5 * thickness, colour), pose);
}

/// Web along the curved shell with a flange on its inner edge.
TriangleMesh shellFrame(const TankPlan& plan, double x) {
    const std::vector<double> zs = plan.shellHeights();
    Outline web;
    for (const double z : zs)
        web.emplace_back(plan.shellY(x, z), z);
    TriangleMesh mesh;
    std::vector<Vector3d> edge;
    for (auto z = zs.rbegin(); z != zs.rend(); ++z) {
        web.emplace_back(plan.shellY(x, *z) - kFrameDepth_m, *z);
        edge.emplace_back(x, plan.shellY(x, *z) - kFrameDepth_m, *z);
    }
    append(mesh, plateAcross(web, x, kWebThickness_m, kFrame));
    for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
        const Vector3d half(0.03, 0.0, 0.0);
        append(mesh, quadMesh(edge[i] - half, edge[i] + half, edge[i + 1] + half, edge[i + 1] - half, kFrame));
    }
    return mesh;
}

/// T-bar up the flat side with knees at floor and deck, deck beam, and the strip over the floor.
TriangleMesh innerFrame(const TankPlan& plan, double x, double floorStripEnd) {
    TriangleMesh mesh = boxMesh({x - 0.006, 0.0, 0.0}, {x + 0.006, kFrameDepth_m, plan.height}, kFrame);
    append(mesh, boxMesh({x - 0.03, kFrameDepth_m, 0.0}, {x + 0.03, kFrameDepth_m + 0.01, plan.height}, kFrame));
    append(mesh,
           plateAcross({{kFrameDepth_m, 0.0}, {kFrameDepth_m + 0.12, 0.0}, {kFrameDepth_m, 0.12}}, x, 0.01, kFrame));
    append(mesh, boxMesh({x - 0.006, 0.0, plan.height - 0.09}, {x + 0.006, plan.shellY(x, plan.height), plan.height},
                         kFrame));
    append(mesh, boxMesh({x - 0.04, 0.0, plan.height - 0.10},
                         {x + 0.04, plan.shellY(x, plan.height - 0.1), plan.height - 0.09}, kFrame));
    append(mesh, boxMesh({x - 0.04, 0.0, 0.0}, {x + 0.04, floorStripEnd, 0.012}, kFrame));
    return mesh;
}

/// Angle bar standing on an end bulkhead, `inward` being +1 or −1 along x.
TriangleMesh angleBar(double x, double y, double top, double inward) {
    const auto span = [&](double a, double b) {
        return std::pair{std::min(x + inward * a, x + inward * b), std::max(x + inward * a, x + inward * b)};
    };
    const auto [webLow, webHigh] = span(0.0, 0.06);
    const auto [toeLow, toeHigh] = span(0.052, 0.06);
    TriangleMesh mesh = boxMesh({webLow, y - 0.004, 0.0}, {webHigh, y + 0.004, top}, kStiffener);
    append(mesh, boxMesh({toeLow, y - 0.004, 0.0}, {toeHigh, y + 0.036, top}, kStiffener));
    return mesh;
}

/// Flat bar along the shell at one height.
TriangleMesh shellStringer(const TankPlan& plan, double z) {
    TriangleMesh mesh;
    constexpr int kSteps = 24;
    const auto at = [&](int i, double depth, double dz) {
        const double x = plan.length * i / kSteps;
        return Vector3d(x, plan.shellY(x, z) - depth, z + dz);
    };
    for (int i = 0; i < kSteps; ++i) {
        append(mesh,
               quadMesh(at(i, 0.05, 0.005), at(i + 1, 0.05, 0.005), at(i + 1, 0, 0.005), at(i, 0, 0.005), kStiffener));
        append(mesh, quadMesh(at(i, 0, -0.005), at(i + 1, 0, -0.005), at(i + 1, 0.05, -0.005), at(i, 0.05, -0.005),
                              kStiffener));
        append(mesh, quadMesh(at(i, 0.05, -0.005), at(i + 1, 0.05, -0.005), at(i + 1, 0.05, 0.005), at(i, 0.05, 0.005),
                              kStiffener));
    }
    return mesh;
}

}  // namespace

TriangleMesh tankFraming(TankPlan& plan) {
    TriangleMesh mesh;
    for (const double share : {0.25, 0.5, 0.75}) {
        const double x = share * plan.length + plan.slip();
        append(mesh, shellFrame(plan, x));
        append(mesh, innerFrame(plan, x, plan.shellY(x, 0.0) - 0.02));
    }
    const int bars = std::max(2, static_cast<int>(plan.width / 0.42));
    for (int i = 1; i < bars; ++i) {
        const double y = (plan.width - plan.bilgeRadius()) * i / (bars - 1) - 0.06;
        append(mesh, angleBar(0.0, y + plan.slip(), plan.height, 1.0));
        append(mesh, angleBar(plan.length, y + plan.slip(), plan.height, -1.0));
    }
    for (const double share : {0.5, 0.75})
        append(mesh, shellStringer(plan, share * plan.height));
    return mesh;
}

}  // namespace fodscope
