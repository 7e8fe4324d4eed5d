// SPDX-License-Identifier: MIT
#include "core/simulation/MeshShapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/simulation/EarClipping.h"

namespace fodscope {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

std::uint32_t addVertex(TriangleMesh& mesh, const Eigen::Vector3d& point, Rgb colour) {
    mesh.vertices.push_back(point);
    mesh.colours.push_back(colour);
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

/// Two unit vectors at right angles to `axis` and to one another, right-handed with it.
std::pair<Eigen::Vector3d, Eigen::Vector3d> across(const Eigen::Vector3d& axis) {
    const Eigen::Vector3d helper = std::abs(axis.z()) < 0.9 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX();
    const Eigen::Vector3d u = helper.cross(axis).normalized();
    return {u, axis.cross(u)};
}

/// Joins two rings of equally many vertices by a band that faces away from their axis.
void addBand(TriangleMesh& mesh, std::uint32_t lower, std::uint32_t upper, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t j = (i + 1) % count;
        mesh.triangles.push_back({lower + i, lower + j, upper + j});
        mesh.triangles.push_back({lower + i, upper + j, upper + i});
    }
}

std::uint32_t addRing(TriangleMesh& mesh, const Eigen::Vector3d& centre, const Eigen::Vector3d& u,
                      const Eigen::Vector3d& v, double radius, int segments, Rgb colour) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int i = 0; i < segments; ++i) {
        const double angle = kTwoPi * i / segments;
        addVertex(mesh, centre + radius * (std::cos(angle) * u + std::sin(angle) * v), colour);
    }
    return first;
}

/// Closes a ring; `forward` tells whether the cap faces along u × v.
void addCap(TriangleMesh& mesh, std::uint32_t ring, int segments, const Eigen::Vector3d& centre, Rgb colour,
            bool forward) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int i = 0; i < segments; ++i)
        addVertex(mesh, mesh.vertices[ring + static_cast<std::uint32_t>(i)], colour);
    const std::uint32_t middle = addVertex(mesh, centre, colour);
    for (int i = 0; i < segments; ++i) {
        const auto a = first + static_cast<std::uint32_t>(i);
        const auto b = first + static_cast<std::uint32_t>((i + 1) % segments);
        if (forward)
            mesh.triangles.push_back({a, b, middle});
        else
            mesh.triangles.push_back({b, a, middle});
    }
}

}  // namespace

TriangleMesh quadMesh(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                      const Eigen::Vector3d& d, Rgb colour) {
    TriangleMesh mesh;
    mesh.vertices = {a, b, c, d};
    mesh.colours.assign(4, colour);
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

TriangleMesh boxMesh(const Eigen::Vector3d& low, const Eigen::Vector3d& high, Rgb colour) {
    const auto corner = [&](int x, int y, int z) {
        return Eigen::Vector3d(x ? high.x() : low.x(), y ? high.y() : low.y(), z ? high.z() : low.z());
    };
    TriangleMesh mesh;
    append(mesh, quadMesh(corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0), colour));
    append(mesh, quadMesh(corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1), colour));
    append(mesh, quadMesh(corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1), colour));
    append(mesh, quadMesh(corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1), colour));
    append(mesh, quadMesh(corner(1, 1, 0), corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1), colour));
    append(mesh, quadMesh(corner(0, 1, 0), corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), colour));
    return mesh;
}

TriangleMesh cylinderMesh(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double radius_m, Rgb colour,
                          int segments) {
    return tubeMesh({low, high}, radius_m, colour, segments);
}

TriangleMesh latheMesh(const Outline& profile, Rgb colour, int segments) {
    TriangleMesh mesh;
    const Eigen::Vector3d u = Eigen::Vector3d::UnitX(), v = Eigen::Vector3d::UnitY();
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        const std::uint32_t lower =
            addRing(mesh, Eigen::Vector3d(0, 0, profile[i].y()), u, v, profile[i].x(), segments, colour);
        const std::uint32_t upper =
            addRing(mesh, Eigen::Vector3d(0, 0, profile[i + 1].y()), u, v, profile[i + 1].x(), segments, colour);
        addBand(mesh, lower, upper, static_cast<std::uint32_t>(segments));
    }
    return mesh;
}

TriangleMesh tubeMesh(const std::vector<Eigen::Vector3d>& path, double radius_m, Rgb colour, int segments) {
    TriangleMesh mesh;
    if (path.size() < 2) return mesh;
    Eigen::Vector3d tangent = (path[1] - path[0]).normalized();
    auto [u, v] = across(tangent);
    std::uint32_t previous = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Eigen::Vector3d before = i > 0 ? (path[i] - path[i - 1]).normalized() : tangent;
        const Eigen::Vector3d after = i + 1 < path.size() ? (path[i + 1] - path[i]).normalized() : before;
        tangent = (before + after).normalized();
        // The frame is carried along the path, so that the tube does not twist.
        u = (u - tangent * tangent.dot(u)).normalized();
        v = tangent.cross(u);
        const std::uint32_t ring = addRing(mesh, path[i], u, v, radius_m, segments, colour);
        if (i == 0)
            addCap(mesh, ring, segments, path[i], colour, false);
        else
            addBand(mesh, previous, ring, static_cast<std::uint32_t>(segments));
        previous = ring;
    }
    addCap(mesh, previous, segments, path.back(), colour, true);
    return mesh;
}

TriangleMesh capsuleMesh(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double radius_m, Rgb colour,
                         int segments) {
    const double length = (high - low).norm();
    Outline profile;
    const int quarter = std::max(2, segments / 4);
    for (int i = 0; i <= quarter; ++i) {
        const double angle = 0.5 * std::numbers::pi * i / quarter;
        profile.emplace_back(radius_m * std::sin(angle), -radius_m * std::cos(angle));
    }
    for (int i = 0; i <= quarter; ++i) {
        const double angle = 0.5 * std::numbers::pi * i / quarter;
        profile.emplace_back(radius_m * std::cos(angle), length + radius_m * std::sin(angle));
    }
    Transform pose = Transform::Identity();
    pose.translation() = low;
    pose.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), high - low).toRotationMatrix();
    return transformed(latheMesh(profile, colour, segments), pose);
}

namespace {

/// The outline moved inwards along its corners' bisectors.
Outline inset(const Outline& outline, double by) {
    Outline result;
    const std::size_t count = outline.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Eigen::Vector2d in = (outline[i] - outline[(i + count - 1) % count]).normalized();
        const Eigen::Vector2d out = (outline[(i + 1) % count] - outline[i]).normalized();
        const Eigen::Vector2d normalIn(-in.y(), in.x()), normalOut(-out.y(), out.x());
        const Eigen::Vector2d bisector = (normalIn + normalOut).normalized();
        // Sharp corners would otherwise move farther than the parts are wide.
        const double stretch = std::min(1.5, 1.0 / std::max(0.5, bisector.dot(normalIn)));
        result.push_back(outline[i] + bisector * (by * stretch));
    }
    return result;
}

std::uint32_t addOutline(TriangleMesh& mesh, const Outline& outline, double height, Rgb colour) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Eigen::Vector2d& p : outline)
        addVertex(mesh, Eigen::Vector3d(p.x(), p.y(), height), colour);
    return first;
}

}  // namespace

TriangleMesh flatMesh(const Outline& outline, Rgb colour) {
    TriangleMesh mesh;
    addOutline(mesh, outline, 0.0, colour);
    mesh.triangles = earClipping(outline);
    return mesh;
}

TriangleMesh extrudedMesh(const Outline& outline, double low_m, double high_m, Rgb colour, double bevel_m) {
    TriangleMesh mesh;
    const auto count = static_cast<std::uint32_t>(outline.size());
    const Outline rim = bevel_m > 0.0 ? inset(outline, bevel_m) : outline;
    std::uint32_t lower = addOutline(mesh, outline, low_m + bevel_m, colour);
    std::uint32_t upper = addOutline(mesh, outline, high_m - bevel_m, colour);
    addBand(mesh, lower, upper, count);
    if (bevel_m > 0.0) {
        addBand(mesh, addOutline(mesh, rim, low_m, colour), lower, count);
        addBand(mesh, upper, addOutline(mesh, rim, high_m, colour), count);
    }
    const std::uint32_t bottom = addOutline(mesh, rim, low_m, colour);
    const std::uint32_t top = addOutline(mesh, rim, high_m, colour);
    for (const auto& t : earClipping(rim)) {
        mesh.triangles.push_back({bottom + t[0], bottom + t[2], bottom + t[1]});
        mesh.triangles.push_back({top + t[0], top + t[1], top + t[2]});
    }
    return mesh;
}

Outline arcPoints(const Eigen::Vector2d& centre, double radius_m, double from_rad, double to_rad, int segments) {
    Outline points;
    for (int i = 0; i <= segments; ++i) {
        const double angle = from_rad + (to_rad - from_rad) * i / segments;
        points.emplace_back(centre + radius_m * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    return points;
}

Outline roundedRectangle(double length_m, double width_m, double radius_m, int cornerSegments) {
    Outline outline;
    const double x = 0.5 * length_m - radius_m, y = 0.5 * width_m - radius_m;
    const Eigen::Vector2d corners[4] = {{x, -y}, {x, y}, {-x, y}, {-x, -y}};
    for (int i = 0; i < 4; ++i) {
        const double from = 0.5 * std::numbers::pi * (i - 1);
        const Outline arc = arcPoints(corners[i], radius_m, from, from + 0.5 * std::numbers::pi, cornerSegments);
        outline.insert(outline.end(), arc.begin(), arc.end());
    }
    return outline;
}

std::vector<Eigen::Vector3d> smoothPath(const std::vector<Eigen::Vector3d>& points, int segmentsEach) {
    std::vector<Eigen::Vector3d> path;
    const auto at = [&](std::ptrdiff_t i) {
        return points[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, std::ssize(points) - 1))];
    };
    for (std::ptrdiff_t i = 0; i + 1 < std::ssize(points); ++i) {
        const Eigen::Vector3d p0 = at(i - 1), p1 = at(i), p2 = at(i + 1), p3 = at(i + 2);
        for (int s = 0; s < segmentsEach; ++s) {
            const double t = static_cast<double>(s) / segmentsEach;
            path.push_back(0.5 * (2.0 * p1 + (p2 - p0) * t + (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3) * t * t +
                                  (3.0 * p1 - p0 - 3.0 * p2 + p3) * t * t * t));
        }
    }
    if (!points.empty()) path.push_back(points.back());
    return path;
}

void append(TriangleMesh& mesh, const TriangleMesh& part) {
    const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
    mesh.colours.insert(mesh.colours.end(), part.colours.begin(), part.colours.end());
    for (const auto& t : part.triangles)
        mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
}

TriangleMesh transformed(TriangleMesh mesh, const Transform& transform) {
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex = transform * vertex;
    return mesh;
}

TriangleMesh translated(TriangleMesh mesh, const Eigen::Vector3d& offset) {
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex += offset;
    return mesh;
}

Eigen::AlignedBox3d boundsOf(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d bounds;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
        bounds.extend(vertex);
    return bounds;
}

Eigen::Vector3d surfaceCentroid(const TriangleMesh& mesh) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double area = 0.0;
    for (const auto& t : mesh.triangles) {
        const Eigen::Vector3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        const double twice = (b - a).cross(c - a).norm();
        sum += twice * (a + b + c) / 3.0;
        area += twice;
    }
    if (area > 0.0) return sum / area;
    return mesh.vertices.empty() ? Eigen::Vector3d::Zero() : mesh.vertices.front();
}

}  // namespace fodscope
