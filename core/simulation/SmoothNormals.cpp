// SPDX-License-Identifier: MIT
#include "core/simulation/SmoothNormals.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fodscope {
namespace {

/// Vertices at the same place (to 1 µm) get the same number.
std::vector<std::uint32_t> placeOfVertex(const std::vector<Eigen::Vector3d>& vertices) {
    using Key = std::array<std::int64_t, 3>;
    std::vector<Key> keys;
    keys.reserve(vertices.size());
    for (const Eigen::Vector3d& v : vertices)
        keys.push_back({std::llround(v.x() * 1e6), std::llround(v.y() * 1e6), std::llround(v.z() * 1e6)});
    std::vector<std::uint32_t> order(vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
    std::vector<std::uint32_t> places(vertices.size());
    std::uint32_t place = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i > 0 && keys[order[i]] != keys[order[i - 1]]) ++place;
        places[order[i]] = place;
    }
    return places;
}

}  // namespace

std::vector<std::array<Eigen::Vector3f, 3>> smoothNormals(const TriangleMesh& mesh, double crease_rad) {
    const std::size_t count = mesh.triangles.size();
    // Twice the area times the unit normal: large faces count for more.
    std::vector<Eigen::Vector3d> weighted(count);
    std::vector<Eigen::Vector3d> unit(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto& t = mesh.triangles[i];
        weighted[i] = (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
        const double length = weighted[i].norm();
        unit[i] = length > 0.0 ? Eigen::Vector3d(weighted[i] / length) : Eigen::Vector3d::UnitZ();
    }
    const std::vector<std::uint32_t> places = placeOfVertex(mesh.vertices);
    std::vector<std::uint32_t> first(mesh.vertices.size() + 1, 0);
    for (const auto& t : mesh.triangles)
        for (const std::uint32_t vertex : t)
            ++first[places[vertex] + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::uint32_t> meeting(3 * count);
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (std::size_t i = 0; i < count; ++i)
        for (const std::uint32_t vertex : mesh.triangles[i])
            meeting[next[places[vertex]]++] = static_cast<std::uint32_t>(i);

    const double leastCosine = std::cos(crease_rad);
    std::vector<std::array<Eigen::Vector3f, 3>> normals(count);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t place = places[mesh.triangles[i][corner]];
            Eigen::Vector3d sum = Eigen::Vector3d::Zero();
            for (std::uint32_t k = first[place]; k < first[place + 1]; ++k)
                if (unit[meeting[k]].dot(unit[i]) > leastCosine) sum += weighted[meeting[k]];
            const double length = sum.norm();
            normals[i][corner] = (length > 0.0 ? Eigen::Vector3d(sum / length) : unit[i]).cast<float>();
        }
    }
    return normals;
}

}  // namespace fodscope
