// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "core/simulation/FodShapes.h"
#include "core/simulation/MeshShapes.h"

namespace fodscope {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr Rgb kSteel{168, 170, 174};
constexpr Rgb kDarkSteel{92, 94, 98};
constexpr Rgb kRubber{34, 34, 36};

Transform turned(double angle_rad, const Vector3d& axis) {
    Transform pose = Transform::Identity();
    pose.linear() = Eigen::AngleAxisd(angle_rad, axis).toRotationMatrix();
    return pose;
}

/// A handle of oval cross-section along x, its axis at height z; the half-widths are (x, half-width, half-height).
TriangleMesh ovalHandle(const std::vector<Vector3d>& stations, double z, Rgb colour, int segments = 20) {
    TriangleMesh mesh;
    const auto ring = [&](const Vector3d& station) {
        std::vector<Vector3d> points;
        for (int i = 0; i < segments; ++i) {
            const double angle = 2.0 * kPi * i / segments;
            points.emplace_back(station.x(), station.y() * std::cos(angle), z + station.z() * std::sin(angle));
        }
        return points;
    };
    for (std::size_t s = 0; s + 1 < stations.size(); ++s) {
        const auto from = ring(stations[s]), to = ring(stations[s + 1]);
        for (std::size_t i = 0; i < from.size(); ++i) {
            const std::size_t j = (i + 1) % from.size();
            append(mesh, quadMesh(from[i], from[j], to[j], to[i], colour));
        }
    }
    const auto close = [&](const Vector3d& station, bool forward) {
        const auto points = ring(station);
        const Vector3d centre(station.x(), 0.0, z);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const std::size_t j = (i + 1) % points.size();
            append(mesh, forward ? quadMesh(points[i], points[j], centre, centre, colour)
                                 : quadMesh(points[j], points[i], centre, centre, colour));
        }
    };
    close(stations.front(), false);
    close(stations.back(), true);
    return mesh;
}

}  // namespace

TriangleMesh hammerMesh(Random& random) {
    // A claw hammer of 20 oz: 330 mm long, head 135 mm from face to claw.
    constexpr double z = 0.0165;
    const bool wooden = random.below(2) == 0;
    const Rgb wood{196, 146, 84}, fibre{222, 170, 26};
    TriangleMesh mesh;
    if (wooden) {
        append(mesh, ovalHandle({{-0.175, 0.011, 0.009},
                                 {-0.172, 0.0165, 0.0125},
                                 {-0.150, 0.0185, 0.0135},
                                 {-0.090, 0.0165, 0.0125},
                                 {-0.030, 0.0135, 0.0105},
                                 {0.060, 0.0115, 0.0095},
                                 {0.120, 0.0130, 0.0100}},
                                z, wood));
    } else {
        append(mesh, ovalHandle({{-0.175, 0.012, 0.010},
                                 {-0.171, 0.0185, 0.0140},
                                 {-0.150, 0.0195, 0.0150},
                                 {-0.090, 0.0170, 0.0138},
                                 {-0.045, 0.0180, 0.0140},
                                 {-0.038, 0.0140, 0.0110}},
                                z, kRubber));
        append(mesh,
               ovalHandle({{-0.038, 0.0130, 0.0100}, {0.060, 0.0120, 0.0095}, {0.120, 0.0130, 0.0100}}, z, fibre));
    }
    // Head across the handle: eye, neck, striking face, and the claw bent back towards the handle.
    append(mesh, extrudedMesh({{0.112, -0.020}, {0.146, -0.020}, {0.146, 0.020}, {0.112, 0.020}}, z - 0.0145,
                              z + 0.0145, kDarkSteel, 0.003));
    append(mesh, cylinderMesh({0.130, -0.018, z}, {0.130, -0.038, z}, 0.0115, kDarkSteel));
    append(mesh, cylinderMesh({0.130, -0.036, z}, {0.130, -0.060, z}, 0.0155, kDarkSteel));
    append(mesh, cylinderMesh({0.130, -0.060, z}, {0.130, -0.064, z}, 0.0140, kSteel));
    const Outline claw{{0.115, 0.016}, {0.146, 0.016}, {0.149, 0.034}, {0.144, 0.052}, {0.133, 0.067},
                       {0.117, 0.076}, {0.114, 0.073}, {0.126, 0.061}, {0.130, 0.048}, {0.128, 0.034}};
    for (const double side : {-1.0, 1.0}) {
        const double middle = z + side * 0.0085;
        append(mesh, extrudedMesh(claw, middle - 0.0050, middle + 0.0050, side > 0 ? kSteel : kDarkSteel, 0.0012));
    }
    return mesh;
}

TriangleMesh screwdriverMesh(Random& random) {
    // 210 mm long, handle 100 × Ø 32 mm, blade Ø 6 mm.
    constexpr double z = 0.016;
    const Rgb makes[] = {{196, 30, 26}, {226, 158, 18}, {20, 84, 168}};
    const Rgb colour = makes[random.below(3)];
    TriangleMesh handle = latheMesh({{0.0, -0.105},
                                     {0.009, -0.105},
                                     {0.0135, -0.101},
                                     {0.0150, -0.094},
                                     {0.0160, -0.080},
                                     {0.0160, -0.050},
                                     {0.0145, -0.034},
                                     {0.0110, -0.026},
                                     {0.0110, -0.019},
                                     {0.0140, -0.012},
                                     {0.0130, -0.006},
                                     {0.0080, -0.003},
                                     {0.0, -0.003}},
                                    colour, 24);
    append(handle, latheMesh({{0.0, -0.1052}, {0.0080, -0.1052}, {0.0090, -0.1046}}, kRubber, 24));
    // Dark grip strips along the handle.
    for (int i = 0; i < 6; ++i) {
        const double angle = 2.0 * kPi * (i + 0.5) / 6;
        const Vector3d out(std::cos(angle), std::sin(angle), 0.0);
        append(handle, capsuleMesh(0.0140 * out + Vector3d(0, 0, -0.088), 0.0140 * out + Vector3d(0, 0, -0.044), 0.0024,
                                   kRubber, 8));
    }
    append(handle, cylinderMesh({0, 0, -0.006}, {0, 0, 0.092}, 0.0032, kSteel, 16));
    append(handle, extrudedMesh({{-0.0032, -0.0012}, {0.0032, -0.0012}, {0.0042, 0.0012}, {-0.0042, 0.0012}}, 0.090,
                                0.104, kDarkSteel));
    TriangleMesh mesh = transformed(handle, turned(0.5 * kPi, Vector3d::UnitY()));
    // The handle's thick end and the tip both touch the floor.
    Transform pose = turned(0.055, Vector3d::UnitY());
    pose.translation().z() = z;
    return transformed(mesh, pose);
}

TriangleMesh wrenchMesh(Random& random) {
    // Combination wrench, 19 mm: 230 mm long, 9 mm thick.
    const Rgb chrome = random.below(2) == 0 ? Rgb{188, 190, 194} : Rgb{150, 152, 156};
    TriangleMesh mesh = extrudedMesh(
        {{-0.085, -0.0075}, {0.0, -0.0060}, {0.088, -0.0085}, {0.088, 0.0085}, {0.0, 0.0060}, {-0.085, 0.0075}}, 0.0015,
        0.0075, chrome, 0.0010);
    append(mesh, extrudedMesh(roundedRectangle(0.110, 0.0055, 0.0027), 0.0070, 0.0078, {96, 98, 102}));
    // Open end, its jaws turned by 15°.
    Outline jaw = arcPoints({0.0, 0.0}, 0.0215, 0.62, 2.0 * kPi - 0.62, 28);
    const double inner = 0.0098;
    jaw.emplace_back(0.0160, -inner);
    jaw.emplace_back(-0.0030, -inner);
    const Outline throat = arcPoints({-0.0030, 0.0}, inner, -0.5 * kPi, -1.5 * kPi, 8);
    jaw.insert(jaw.end(), throat.begin() + 1, throat.end() - 1);
    jaw.emplace_back(-0.0030, inner);
    jaw.emplace_back(0.0160, inner);
    Transform open = turned(0.26, Vector3d::UnitZ());
    open.translation() = Vector3d(0.100, 0.0, 0.0);
    append(mesh, transformed(extrudedMesh(jaw, 0.0, 0.0090, chrome, 0.0010), open));
    // Ring end: an annulus cut open at the back by a bridge of no width.
    Outline ring = arcPoints({-0.101, 0.0}, 0.0165, 0.0, 2.0 * kPi, 30);
    const Outline hole = arcPoints({-0.101, 0.0}, 0.0105, 2.0 * kPi, 0.0, 12);
    ring.insert(ring.end(), hole.begin(), hole.end());
    append(mesh, extrudedMesh(ring, 0.0, 0.0110, chrome));
    return mesh;
}

TriangleMesh crimperMesh(Random& random) {
    // Ratchet crimping pliers, 225 mm long, 20 mm thick at the grips, half open.
    const Rgb grip = random.below(2) == 0 ? Rgb{200, 34, 28} : Rgb{24, 86, 170};
    constexpr double z = 0.010;
    TriangleMesh mesh;
    // Jaw plates in front of the pivot with their die slot, upper and lower.
    const Outline upper{{-0.010, 0.001}, {0.052, 0.001}, {0.052, 0.014},
                        {0.040, 0.023},  {0.012, 0.025}, {-0.014, 0.016}};
    Outline lower;
    for (auto p = upper.rbegin(); p != upper.rend(); ++p)
        lower.emplace_back(p->x(), -p->y());
    append(mesh, extrudedMesh(upper, z - 0.0065, z + 0.0065, kDarkSteel, 0.0012));
    append(mesh, extrudedMesh(lower, z - 0.0065, z + 0.0065, kDarkSteel, 0.0012));
    append(mesh, boxMesh({0.012, -0.006, z - 0.0085}, {0.040, 0.006, z + 0.0085}, kSteel));
    for (const Vector2d& bolt : {Vector2d(0.002, 0.0), Vector2d(0.034, 0.016), Vector2d(0.034, -0.016)})
        append(mesh,
               cylinderMesh({bolt.x(), bolt.y(), z - 0.0092}, {bolt.x(), bolt.y(), z + 0.0092}, 0.0045, kSteel, 16));
    for (const double side : {-1.0, 1.0}) {
        const auto at = [&](double x, double y) { return Vector3d(x, side * y, z); };
        append(mesh, tubeMesh(smoothPath({at(0.004, 0.006), at(-0.020, 0.020), at(-0.048, 0.030)}, 6), 0.0065,
                              kDarkSteel, 12));
        const auto path = smoothPath({at(-0.040, 0.028), at(-0.075, 0.037), at(-0.120, 0.040), at(-0.160, 0.034)}, 6);
        append(mesh, tubeMesh(path, 0.0098, grip, 14));
        append(mesh, capsuleMesh(at(-0.159, 0.0342), at(-0.161, 0.0338), 0.0098, grip, 14));
    }
    // The ratchet's link between the handles.
    append(mesh, extrudedMesh({{-0.058, -0.030}, {-0.046, -0.030}, {-0.040, 0.028}, {-0.052, 0.030}}, z - 0.003,
                              z + 0.003, kSteel, 0.0008));
    return mesh;
}

TriangleMesh levelMesh(Random& random) {
    // Box-section spirit level, 400 × 50 × 22 mm, standing on its edge.
    const Rgb makes[] = {{206, 32, 28}, {228, 176, 20}, {36, 92, 176}};
    const Rgb body = makes[random.below(3)];
    constexpr double half = 0.011;
    TriangleMesh mesh = boxMesh({-0.196, -half, 0.0}, {0.196, half, 0.008}, body);
    append(mesh, boxMesh({-0.196, -half, 0.042}, {0.196, half, 0.050}, body));
    append(mesh, boxMesh({-0.196, -0.006, 0.006}, {0.196, 0.006, 0.044}, body));
    for (const double side : {-1.0, 1.0})
        append(mesh, boxMesh({side * 0.198 - 0.004, -half - 0.001, 0.0}, {side * 0.198 + 0.004, half + 0.001, 0.050},
                             kRubber));
    const Rgb liquid{196, 220, 40}, frame{30, 30, 32}, bubble{236, 244, 176};
    const auto vial = [&](double x, const Vector3d& along) {
        append(mesh, boxMesh({x - 0.022, -0.0085, 0.012}, {x + 0.022, 0.0085, 0.040}, frame));
        const Vector3d centre(x, 0.0, 0.026);
        append(mesh, capsuleMesh(centre - 0.010 * along, centre + 0.010 * along, 0.0095, liquid, 16));
        append(mesh, capsuleMesh(centre - 0.003 * along, centre + 0.003 * along, 0.0098, bubble, 16));
    };
    vial(0.0, Vector3d::UnitX());
    vial(-0.130, Vector3d::UnitZ());
    vial(0.130, Vector3d(1, 0, 1).normalized());
    return mesh;
}

}  // namespace fodscope
