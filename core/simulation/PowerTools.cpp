// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "core/simulation/FodShapes.h"
#include "core/simulation/MeshShapes.h"

namespace fodscope {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr Rgb kRubber{34, 34, 36};
constexpr Rgb kDarkSteel{86, 88, 92};
constexpr Rgb kSteel{170, 172, 176};

/// Turns a shape made along z to lie along x.
TriangleMesh alongX(TriangleMesh mesh, const Vector3d& at) {
    Transform pose = Transform::Identity();
    pose.linear() = Eigen::AngleAxisd(0.5 * kPi, Vector3d::UnitY()).toRotationMatrix();
    pose.translation() = at;
    return transformed(std::move(mesh), pose);
}

/// An outline in x (forward) and z (up), as thick as `width`, upright.
TriangleMesh upright(const Outline& outline, double width, Rgb colour, double bevel) {
    Transform pose = Transform::Identity();
    // x stays, the outline's second axis becomes z, and its depth −y.
    pose.linear().col(0) = Vector3d::UnitX();
    pose.linear().col(1) = Vector3d::UnitZ();
    pose.linear().col(2) = -Vector3d::UnitY();
    return transformed(extrudedMesh(outline, -0.5 * width, 0.5 * width, colour, bevel), pose);
}

}  // namespace

TriangleMesh drillMesh(Random& random) {
    // Cordless drill with its battery: 200 mm long, 215 mm high, 75 mm wide; left standing on the battery or lying.
    const Rgb makes[] = {{232, 178, 12}, {0, 118, 128}, {200, 36, 24}};
    const Rgb body = makes[random.below(3)];
    TriangleMesh mesh;
    // Battery, foot, grip, motor housing, clutch ring, chuck and bit.
    append(mesh, upright({{-0.062, 0.0}, {0.058, 0.0}, {0.062, 0.012}, {0.056, 0.046}, {-0.062, 0.046}}, 0.072, kRubber,
                         0.006));
    append(mesh, upright({{-0.056, 0.046}, {0.050, 0.046}, {0.036, 0.064}, {-0.048, 0.064}}, 0.060, body, 0.005));
    append(mesh,
           upright({{-0.040, 0.060}, {0.012, 0.060}, {0.018, 0.100}, {0.020, 0.146}, {-0.044, 0.150}, {-0.036, 0.110}},
                   0.040, body, 0.007));
    append(
        mesh,
        upright({{-0.047, 0.070}, {-0.028, 0.066}, {-0.024, 0.110}, {-0.030, 0.150}, {-0.050, 0.152}, {-0.041, 0.110}},
                0.042, kRubber, 0.006));
    append(mesh, upright({{0.014, 0.116}, {0.030, 0.120}, {0.032, 0.140}, {0.014, 0.142}}, 0.018, {20, 20, 22}, 0.003));
    append(mesh, alongX(latheMesh({{0.0, -0.088},
                                   {0.020, -0.088},
                                   {0.028, -0.080},
                                   {0.0315, -0.060},
                                   {0.0325, 0.010},
                                   {0.030, 0.034},
                                   {0.0, 0.034}},
                                  body),
                        {0.0, 0.0, 0.178}));
    append(mesh,
           alongX(latheMesh({{0.0, -0.0885}, {0.016, -0.0885}, {0.0265, -0.084}, {0.0305, -0.070}, {0.0318, -0.058}},
                            kRubber),
                  {0.0, 0.0, 0.178}));
    append(mesh, alongX(latheMesh({{0.0, 0.033}, {0.0255, 0.033}, {0.0255, 0.052}, {0.0, 0.052}}, kRubber),
                        {0.0, 0.0, 0.178}));
    append(mesh,
           alongX(latheMesh(
                      {{0.0, 0.052}, {0.0205, 0.052}, {0.0205, 0.074}, {0.0170, 0.084}, {0.0080, 0.096}, {0.0, 0.096}},
                      kDarkSteel),
                  {0.0, 0.0, 0.178}));
    append(mesh, cylinderMesh({0.094, 0.0, 0.178}, {0.140, 0.0, 0.178}, 0.0032, kSteel, 12));
    // Vents and a pale label on each side, so that the housing is no plain colour.
    for (const double side : {-1.0, 1.0}) {
        for (int i = 0; i < 4; ++i) {
            const double x = -0.062 + 0.011 * i;
            append(mesh, capsuleMesh({x, side * 0.0292, 0.168}, {x, side * 0.0292, 0.190}, 0.0026, {16, 16, 18}, 8));
        }
        append(mesh, boxMesh({-0.034, side * 0.0300 - 0.0012, 0.052}, {0.020, side * 0.0300 + 0.0012, 0.060},
                             {225, 225, 220}));
    }
    if (random.below(2) == 0) return mesh;
    // Lying on its side.
    Transform pose = Transform::Identity();
    pose.linear() = Eigen::AngleAxisd(0.5 * kPi, Vector3d::UnitX()).toRotationMatrix();
    return transformed(mesh, pose);
}

TriangleMesh sanderMesh(Random& random) {
    // Random-orbit palm sander: pad Ø 125 mm, 145 mm high, 230 mm with its dust box.
    const Rgb makes[] = {{0, 112, 122}, {226, 170, 16}, {28, 92, 160}};
    const Rgb body = makes[random.below(3)];
    TriangleMesh mesh = latheMesh({{0.0, 0.0}, {0.0625, 0.0}, {0.0625, 0.003}, {0.0600, 0.003}}, {150, 96, 48}, 40);
    append(mesh, latheMesh({{0.0600, 0.003}, {0.0615, 0.004}, {0.0580, 0.015}, {0.0300, 0.018}}, kRubber, 40));
    append(mesh, latheMesh({{0.0300, 0.016},
                            {0.0540, 0.018},
                            {0.0550, 0.034},
                            {0.0500, 0.046},
                            {0.0420, 0.060},
                            {0.0385, 0.090},
                            {0.0420, 0.104}},
                           body, 40));
    append(
        mesh,
        latheMesh({{0.0420, 0.104}, {0.0470, 0.112}, {0.0465, 0.126}, {0.0380, 0.139}, {0.0200, 0.145}, {0.0, 0.1455}},
                  kRubber, 40));
    append(mesh, latheMesh({{0.0545, 0.022}, {0.0560, 0.024}, {0.0560, 0.029}, {0.0545, 0.031}}, {20, 20, 22}, 40));
    // Outlet and dust box behind, power cord's sleeve on top of it.
    append(mesh, cylinderMesh({-0.040, 0.0, 0.036}, {-0.078, 0.0, 0.042}, 0.017, body));
    Transform box = Transform::Identity();
    box.translation() = Vector3d(-0.118, 0.0, 0.0);
    append(mesh,
           transformed(extrudedMesh(roundedRectangle(0.088, 0.064, 0.016), 0.016, 0.074, {44, 46, 50}, 0.008), box));
    append(mesh, boxMesh({-0.150, -0.034, 0.036}, {-0.090, 0.034, 0.052}, {206, 206, 200}));
    append(mesh, tubeMesh(smoothPath({{-0.036, 0.0, 0.094}, {-0.062, 0.004, 0.102}, {-0.092, 0.016, 0.092}}, 6), 0.0065,
                          kRubber, 12));
    append(mesh, boxMesh({0.0365, -0.010, 0.070}, {0.0420, 0.010, 0.086}, {222, 222, 216}));
    return mesh;
}

TriangleMesh tapeMeasureMesh(Random& random) {
    // 5 m tape: case 78 × 70 × 38 mm standing on its base, a hand's width of the yellow blade drawn out.
    const Rgb makes[] = {{236, 186, 12}, {210, 60, 20}};
    const Rgb shell = makes[random.below(2)];
    Outline outline{{-0.036, 0.0}, {0.039, 0.0}, {0.039, 0.030}};
    const Outline back = arcPoints({0.0, 0.032}, 0.038, 0.10, 0.5 * kPi, 6);
    outline.insert(outline.end(), back.begin(), back.end());
    const Outline front = arcPoints({-0.001, 0.032}, 0.038, 0.5 * kPi, kPi, 8);
    outline.insert(outline.end(), front.begin() + 1, front.end());
    outline.emplace_back(-0.039, 0.006);
    TriangleMesh mesh = upright(outline, 0.036, shell, 0.005);
    // Black rubber on the edge, a round badge on each side, the belt clip.
    Outline rim{{-0.034, -0.0005}, {0.0395, -0.0005}, {0.0395, 0.010}, {-0.039, 0.010}};
    append(mesh, upright(rim, 0.038, kRubber, 0.002));
    append(mesh,
           upright({{0.018, 0.052}, {0.034, 0.044}, {0.040, 0.030}, {0.040, 0.014}, {0.034, 0.014}, {0.030, 0.036}},
                   0.039, kRubber, 0.002));
    for (const double side : {-1.0, 1.0}) {
        append(mesh, cylinderMesh({0.0, side * 0.0170, 0.036}, {0.0, side * 0.0192, 0.036}, 0.0215, kRubber, 28));
        append(mesh,
               cylinderMesh({0.0, side * 0.0190, 0.036}, {0.0, side * 0.0198, 0.036}, 0.0165, {225, 225, 220}, 28));
    }
    append(mesh, boxMesh({0.036, -0.0125, 0.0025}, {0.120, 0.0125, 0.0034}, {238, 208, 40}));
    for (int i = 0; i < 7; ++i) {
        const double x = 0.048 + 0.010 * i;
        append(mesh, boxMesh({x, -0.0125, 0.0033}, {x + 0.0012, i % 2 ? 0.004 : -0.002, 0.0036}, {24, 24, 24}));
    }
    append(mesh, boxMesh({0.118, -0.011, -0.0005}, {0.1205, 0.011, 0.010}, kSteel));
    return mesh;
}

}  // namespace fodscope
