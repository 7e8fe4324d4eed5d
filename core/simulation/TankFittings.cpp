// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "core/simulation/TankParts.h"

namespace fodscope {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr Rgb kBeam{186, 180, 164};
constexpr Rgb kColumn{190, 186, 172};
constexpr Rgb kPipe{132, 148, 132};
constexpr Rgb kWater{120, 140, 156};
constexpr Rgb kBracket{150, 146, 136};
constexpr Rgb kRedPaint{168, 44, 34};
constexpr Rgb kYellowPaint{206, 168, 52};

/// Stands on the floor across the tank: 200 mm high, flanges 120 mm.
TriangleMesh iBeam(double x, double fromY, double toY) {
    TriangleMesh mesh = boxMesh({x - 0.06, fromY, 0.0}, {x + 0.06, toY, 0.012}, kBeam);
    append(mesh, boxMesh({x - 0.06, fromY, 0.188}, {x + 0.06, toY, 0.200}, kBeam));
    append(mesh, boxMesh({x - 0.005, fromY, 0.012}, {x + 0.005, toY, 0.188}, kBeam));
    return mesh;
}

TriangleMesh column(const Vector3d& foot, double height) {
    TriangleMesh mesh = cylinderMesh(foot, foot + Vector3d(0, 0, height), 0.084, kColumn, 32);
    append(mesh, boxMesh(foot + Vector3d(-0.14, -0.14, 0.0), foot + Vector3d(0.14, 0.14, 0.015), kColumn));
    for (int i = 0; i < 4; ++i) {
        const double angle = 0.25 * kPi + 0.5 * kPi * i;
        const Vector3d bolt = foot + 0.15 * Vector3d(std::cos(angle), std::sin(angle), 0.0);
        append(mesh, cylinderMesh(bolt + Vector3d(0, 0, 0.015), bolt + Vector3d(0, 0, 0.035), 0.014, kBracket, 6));
    }
    return mesh;
}

TriangleMesh flange(const Vector3d& centre, double radius, Rgb colour) {
    const Vector3d half(0.011, 0.0, 0.0);
    TriangleMesh mesh = cylinderMesh(centre - 2.0 * half, centre - 0.1 * half, radius, colour, 28);
    append(mesh, cylinderMesh(centre + 0.1 * half, centre + 2.0 * half, radius, colour, 28));
    return mesh;
}

/// From the flat side's plating to under the pipe, with a strap over it.
TriangleMesh pipeBracket(const Vector3d& pipe, double radius) {
    TriangleMesh mesh = boxMesh({pipe.x() - 0.02, 0.0, pipe.z() - radius - 0.008},
                                {pipe.x() + 0.02, pipe.y() + radius, pipe.z() - radius}, kBracket);
    append(mesh, boxMesh({pipe.x() - 0.02, 0.0, pipe.z() - radius - 0.10}, {pipe.x() + 0.02, 0.008, pipe.z() - radius},
                         kBracket));
    append(mesh, boxMesh({pipe.x() - 0.004, 0.0, pipe.z() - radius - 0.09},
                         {pipe.x() + 0.004, 0.5 * pipe.y(), pipe.z() - radius - 0.008}, kBracket));
    append(mesh,
           cylinderMesh(pipe - Vector3d(0.014, 0, 0), pipe + Vector3d(0.014, 0, 0), radius + 0.005, kBracket, 24));
    return mesh;
}

/// Body, spindle and a hand wheel that faces into the tank.
TriangleMesh valve(const Vector3d& centre) {
    TriangleMesh mesh = capsuleMesh(centre - Vector3d(0.05, 0, 0), centre + Vector3d(0.05, 0, 0), 0.062, kPipe, 24);
    append(mesh, cylinderMesh(centre, centre + Vector3d(0, 0.15, 0), 0.016, kBracket, 16));
    const Vector3d hub = centre + Vector3d(0, 0.145, 0);
    std::vector<Vector3d> rim;
    for (int i = 0; i <= 32; ++i) {
        const double angle = 2.0 * kPi * i / 32;
        rim.emplace_back(hub + 0.078 * Vector3d(std::cos(angle), 0.0, std::sin(angle)));
    }
    append(mesh, tubeMesh(rim, 0.0085, kRedPaint, 10));
    for (int i = 0; i < 5; ++i)
        append(mesh, cylinderMesh(hub, rim[static_cast<std::size_t>(i * 32 / 5)], 0.006, kRedPaint, 8));
    append(mesh, cylinderMesh(hub - Vector3d(0, 0.01, 0), hub + Vector3d(0, 0.012, 0), 0.020, kRedPaint, 16));
    return mesh;
}

TriangleMesh pipesOnFlatSide(TankPlan& plan) {
    TriangleMesh mesh;
    // The slip is along and up the wall: a pipe does not enter the plating.
    const Vector3d wide(0.0, 0.155 + std::abs(plan.slip()), 0.34 + plan.slip());
    const Vector3d narrow(0.0, 0.150 + std::abs(plan.slip()), 0.52 + plan.slip());
    const Vector3d along(plan.length, 0.0, 0.0);
    append(mesh, tubeMesh({wide, wide + along}, 0.0445, kPipe, 28));
    append(mesh, tubeMesh({narrow, narrow + along}, 0.024, kWater, 20));
    for (const double share : {0.32, 0.66}) {
        append(mesh, flange(wide + share * along, 0.075, kPipe));
        append(mesh, flange(narrow + (share + 0.05) * along, 0.044, kWater));
    }
    append(mesh, valve(wide + 0.42 * along));
    // Collars where the pipes pass through the end bulkheads.
    for (const double x : {0.006, plan.length - 0.006}) {
        const Vector3d half(0.006, 0.0, 0.0), at(x, 0.0, 0.0);
        append(mesh, cylinderMesh(wide + at - half, wide + at + half, 0.085, kPipe, 28));
        append(mesh, cylinderMesh(narrow + at - half, narrow + at + half, 0.05, kWater, 24));
    }
    int number = 0;
    for (const double share : {0.15, 0.37, 0.60, 0.84}) {
        // The yard left one bracket out.
        if (!(plan.asBuilt && number == 2)) append(mesh, pipeBracket(wide + share * along, 0.0445));
        append(mesh, pipeBracket(narrow + (share + 0.03) * along, 0.024));
        ++number;
    }
    return mesh;
}

/// Down from the deck to a bell mouth over the floor.
TriangleMesh suction(const Vector3d& foot, double height) {
    TriangleMesh mesh = cylinderMesh(foot + Vector3d(0, 0, 0.15), foot + Vector3d(0, 0, height), 0.057, kPipe, 28);
    append(mesh,
           translated(latheMesh({{0.105, 0.05}, {0.100, 0.075}, {0.075, 0.110}, {0.057, 0.160}}, kPipe, 28), foot));
    for (int i = 0; i < 3; ++i) {
        const double angle = 2.0 * kPi * i / 3;
        const Vector3d at = foot + 0.095 * Vector3d(std::cos(angle), std::sin(angle), 0.0);
        append(mesh, cylinderMesh(at, at + Vector3d(0, 0, 0.06), 0.008, kBracket, 10));
    }
    append(mesh, translated(latheMesh({{0.057, 0.55}, {0.088, 0.55}, {0.088, 0.59}, {0.057, 0.59}}, kPipe, 28), foot));
    return mesh;
}

/// Two stringers and rungs in front of the end bulkhead, up to the access hole's edge.
TriangleMesh ladder(double x, double y, double height) {
    TriangleMesh mesh;
    for (const double side : {-0.15, 0.15}) {
        append(mesh, boxMesh({x - 0.02, y + side - 0.005, 0.0}, {x + 0.02, y + side + 0.005, height}, kYellowPaint));
        append(mesh, boxMesh({0.0, y + side - 0.005, 0.75 * height}, {x, y + side + 0.005, 0.75 * height + 0.03},
                             kYellowPaint));
    }
    for (double z = 0.20; z < height - 0.05; z += 0.25)
        append(mesh, cylinderMesh({x, y - 0.15, z}, {x, y + 0.15, z}, 0.011, kYellowPaint, 12));
    return mesh;
}

}  // namespace

TriangleMesh tankFittings(TankPlan& plan) {
    TriangleMesh mesh;
    const Vector3d beam = plan.misplacement();
    append(mesh, iBeam(0.76 * plan.length + beam.x(), 0.12, 0.36 * plan.width + beam.y()));
    append(mesh, column(Vector3d(0.52 * plan.length, 0.60 * plan.width, 0.0) + plan.misplacement(), plan.height));
    append(mesh, pipesOnFlatSide(plan));
    append(mesh, suction(Vector3d(0.12 * plan.length, 0.74 * plan.width, 0.0) + plan.misplacement(), plan.height));
    append(mesh, ladder(0.11, accessHoleCentre(plan).y() + plan.slip(), plan.height));
    return mesh;
}

TriangleMesh tankAdditions(const TankPlan& plan) {
    constexpr Rgb kHose{40, 40, 44}, kCable{28, 28, 30}, kBox{96, 108, 120};
    const double l = plan.length, w = plan.width, radius = 0.013;
    TriangleMesh mesh;
    std::vector<Vector3d> hose;
    for (const auto& [x, y] :
         {std::pair{0.20, 0.80}, {0.30, 0.83}, {0.42, 0.79}, {0.56, 0.82}, {0.68, 0.76}, {0.78, 0.79}, {0.86, 0.70}})
        hose.emplace_back(x * l, y * w, radius + 0.012);
    append(mesh, tubeMesh(smoothPath(hose, 8), radius, kHose, 12));
    const auto box = Vector3d(l, 0.58 * w, 0.34 * plan.height);
    append(mesh, boxMesh(box + Vector3d(-0.10, -0.09, -0.07), box + Vector3d(0.0, 0.09, 0.07), kBox));
    append(mesh, boxMesh(box + Vector3d(-0.106, -0.082, -0.062), box + Vector3d(-0.10, 0.082, 0.062), kBox));
    std::vector<Vector3d> cable;
    for (const auto& [y, z] : {std::pair{0.58, 0.41},
                               {0.56, 0.55},
                               {0.50, 0.60},
                               {0.42, 0.57},
                               {0.34, 0.60},
                               {0.26, 0.57},
                               {0.18, 0.62},
                               {0.12, 0.80},
                               {0.12, 1.0}})
        cable.emplace_back(l - 0.066, y * w, z * plan.height);
    append(mesh, tubeMesh(smoothPath(cable, 6), 0.007, kCable, 10));
    return mesh;
}

}  // namespace fodscope
