// SPDX-License-Identifier: MIT
#include "core/cloud/StlMesh.h"

#include <Eigen/Geometry>
#include <bit>
#include <utility>

#include "core/cloud/ScalarType.h"
#include "core/common/Error.h"

namespace fodscope {
namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kDataOffset = kHeaderBytes + 4;
constexpr std::size_t kTriangleBytes = 50;

std::uint64_t announcedTriangles(std::span<const std::byte> bytes) {
    return loadNumber<std::uint32_t>(bytes.data() + kHeaderBytes);
}

Eigen::Vector3d vectorAt(const std::byte* bytes) {
    return {loadNumber<float>(bytes), loadNumber<float>(bytes + 4), loadNumber<float>(bytes + 8)};
}

void appendVector(std::string& bytes, const Eigen::Vector3d& vector) {
    for (int axis = 0; axis < 3; ++axis)
        appendNumber(bytes, static_cast<float>(vector[axis]));
}

}  // namespace

std::uint32_t StlVertices::indexOf(const Eigen::Vector3d& vertex) {
    // Adding zero makes −0 and 0 the same vertex.
    const std::array<std::uint64_t, 3> key{std::bit_cast<std::uint64_t>(vertex.x() + 0.0),
                                           std::bit_cast<std::uint64_t>(vertex.y() + 0.0),
                                           std::bit_cast<std::uint64_t>(vertex.z() + 0.0)};
    const auto [position, isNew] = known_.try_emplace(key, static_cast<std::uint32_t>(vertices_.size()));
    if (isNew) vertices_.push_back(vertex);
    return position->second;
}

bool isBinaryStl(std::span<const std::byte> bytes) {
    return bytes.size() >= kDataOffset && bytes.size() == kDataOffset + kTriangleBytes * announcedTriangles(bytes);
}

TriangleMesh parseBinaryStl(std::span<const std::byte> bytes, const std::string& subject) {
    if (bytes.size() < kDataOffset || announcedTriangles(bytes) > (bytes.size() - kDataOffset) / kTriangleBytes) {
        throw Error(subject, "is truncated: the STL is shorter than its header says", "copy or export the file anew");
    }
    const std::uint64_t count = announcedTriangles(bytes);
    StlVertices vertices;
    TriangleMesh mesh;
    mesh.triangles.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::byte* facet = bytes.data() + kDataOffset + i * kTriangleBytes;
        std::array<std::uint32_t, 3> triangle{};
        for (std::size_t corner = 0; corner < 3; ++corner)
            triangle[corner] = vertices.indexOf(vectorAt(facet + 12 * (corner + 1)));
        mesh.triangles.push_back(triangle);
    }
    mesh.vertices = std::move(vertices).take();
    return mesh;
}

std::string binaryStlBytes(const TriangleMesh& mesh) {
    std::string bytes(kHeaderBytes, '\0');
    appendNumber(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& [a, b, c] : mesh.triangles) {
        const Eigen::Vector3d normal =
            (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).stableNormalized();
        appendVector(bytes, normal);
        for (const std::uint32_t index : {a, b, c})
            appendVector(bytes, mesh.vertices[index]);
        appendNumber(bytes, std::uint16_t{0});
    }
    return bytes;
}

}  // namespace fodscope
