// SPDX-License-Identifier: MIT
#include "core/reference/CadReference.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

#include "core/common/Error.h"

namespace fodscope {
namespace {

constexpr double kMostSamples = 200e6;

/// std::mt19937_64 gives the same bits everywhere, the standard distributions do not.
double uniform(std::mt19937_64& generator) {
    return static_cast<double>(generator() >> 11) * 0x1.0p-53;
}

double areaOf(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
    const Eigen::Vector3d& a = mesh.vertices[triangle[0]];
    return 0.5 * (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a).norm();
}

/// Source: Osada et al., "Shape Distributions" (2002), eq. 1.
Eigen::Vector3d pointOn(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle, double u, double v) {
    const double root = std::sqrt(u);
    return (1.0 - root) * mesh.vertices[triangle[0]] + root * (1.0 - v) * mesh.vertices[triangle[1]] +
           root * v * mesh.vertices[triangle[2]];
}

std::size_t sampleCount(double area, double spacing_m) {
    const double count = area / (spacing_m * spacing_m);
    if (!(count <= kMostSamples)) {
        throw Error("spacing", "it asks for more than 200 million samples of this mesh",
                    "choose a larger spacing, or check that the mesh is in metres");
    }
    return static_cast<std::size_t>(std::max(1LL, std::llround(count)));
}

}  // namespace

ReferenceMap referenceFromCad(const TriangleMesh& mesh, const CadReferenceSettings& settings, Progress& progress) {
    const std::string stage = "sampling the CAD mesh";
    if (!(settings.spacing_m > 0.0) || !std::isfinite(settings.spacing_m)) {
        throw Error("spacing", "must be greater than 0", "give a length in metres such as 0.01");
    }
    const auto isVertex = [&](std::uint32_t index) { return index < mesh.vertices.size(); };
    for (const auto& triangle : mesh.triangles) {
        if (!std::ranges::all_of(triangle, isVertex))
            throw Error("CAD mesh", "a triangle has a vertex that is not there", "export the mesh anew");
        if (!std::ranges::all_of(triangle, [&](std::uint32_t index) { return mesh.vertices[index].allFinite(); }))
            throw Error("CAD mesh", "a coordinate is not finite", "export the mesh anew");
    }
    double area = 0.0;
    for (const auto& triangle : mesh.triangles)
        area += areaOf(mesh, triangle);
    if (!(area > 0.0) || !std::isfinite(area)) {
        throw Error("CAD mesh", "its triangles have no area", "give a mesh of surfaces in metres");
    }
    const std::size_t count = sampleCount(area, settings.spacing_m);

    // Stratified: sample i lies somewhere in the i-th of `count` equal parts of the area, which spreads the samples
    // more evenly than independent draws and needs no search for the triangle.
    std::mt19937_64 generator(settings.seed);
    ReferenceMap reference;
    reference.points.reserve(count);
    std::size_t triangle = 0;
    double areaToTriangleEnd = areaOf(mesh, mesh.triangles.front());
    for (std::size_t i = 0; i < count; ++i) {
        if (i % 65536 == 0) progress.report(stage, static_cast<double>(i) / static_cast<double>(count));
        const double at = (static_cast<double>(i) + uniform(generator)) / static_cast<double>(count) * area;
        while (at >= areaToTriangleEnd && triangle + 1 < mesh.triangles.size())
            areaToTriangleEnd += areaOf(mesh, mesh.triangles[++triangle]);
        const double u = uniform(generator);
        const double v = uniform(generator);
        reference.points.push_back(pointOn(mesh, mesh.triangles[triangle], u, v));
    }
    reference.provenance = {"Fodscope reference map from a CAD mesh", "spacing_m " + std::to_string(settings.spacing_m),
                            "seed " + std::to_string(settings.seed)};
    return reference;
}

}  // namespace fodscope
