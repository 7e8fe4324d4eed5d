// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/cloud/TriangleMesh.h"
#include "core/common/Geometry.h"

namespace fodscope {

/// Shapes that tools and tanks are composed of. All face outwards and carry one colour.
using Outline = std::vector<Eigen::Vector2d>;

TriangleMesh boxMesh(const Eigen::Vector3d& low, const Eigen::Vector3d& high, Rgb colour);

/// One quadrilateral of two triangles; facing the side from which its corners run counter-clockwise.
TriangleMesh quadMesh(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                      const Eigen::Vector3d& d, Rgb colour);

/// From `low` to `high` with flat ends.
TriangleMesh cylinderMesh(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double radius_m, Rgb colour,
                          int segments = 24);

/// Surface of revolution about z: (radius, height) pairs with rising height or any closed course from axis to axis.
TriangleMesh latheMesh(const Outline& profile, Rgb colour, int segments = 32);

/// A pipe, hose or cable along a path, with flat ends.
TriangleMesh tubeMesh(const std::vector<Eigen::Vector3d>& path, double radius_m, Rgb colour, int segments = 12);

/// A cylinder with round ends.
TriangleMesh capsuleMesh(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double radius_m, Rgb colour,
                         int segments = 20);

/// A counter-clockwise outline without crossings (it may be concave) between two heights.
/// @param bevel_m the upper and lower edge are broken by this much
TriangleMesh extrudedMesh(const Outline& outline, double low_m, double high_m, Rgb colour, double bevel_m = 0.0);

/// The flat inside of an outline, facing +z, at z = 0.
TriangleMesh flatMesh(const Outline& outline, Rgb colour);

/// A rectangle about the origin with round corners.
Outline roundedRectangle(double length_m, double width_m, double radius_m, int cornerSegments = 5);

/// Points of a circle's arc, both ends included.
Outline arcPoints(const Eigen::Vector2d& centre, double radius_m, double from_rad, double to_rad, int segments);

/// A smooth curve through the points (Catmull-Rom).
std::vector<Eigen::Vector3d> smoothPath(const std::vector<Eigen::Vector3d>& points, int segmentsEach);

void append(TriangleMesh& mesh, const TriangleMesh& part);
TriangleMesh transformed(TriangleMesh mesh, const Transform& transform);
TriangleMesh translated(TriangleMesh mesh, const Eigen::Vector3d& offset);

/// Least and greatest coordinate of the vertices; an empty box when there are none.
Eigen::AlignedBox3d boundsOf(const TriangleMesh& mesh);

/// Area-weighted mean of the surface; it needs no closed mesh.
Eigen::Vector3d surfaceCentroid(const TriangleMesh& mesh);

}  // namespace fodscope
