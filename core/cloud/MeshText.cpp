// SPDX-License-Identifier: MIT
#include "core/cloud/MeshText.h"

#include <charconv>
#include <optional>

#include "core/cloud/StlMesh.h"
#include "core/cloud/TextScanner.h"
#include "core/common/Error.h"

namespace fodscope {
namespace {

Eigen::Vector3d vertexFrom(TextScanner& words, const std::string& subject) {
    Eigen::Vector3d vertex;
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view word = words.word();
        const std::optional<double> value = numberFrom(word);
        if (!value) {
            throw Error(subject,
                        word.empty() ? "is truncated: a vertex lacks a coordinate"
                                     : "\"" + std::string(word.substr(0, 40)) + "\" is not a coordinate",
                        "export the mesh anew");
        }
        vertex[axis] = *value;
    }
    return vertex;
}

/// @param word "7", "7/1", "7//3" or "-1": the vertex counts from 1, or from the last one backwards
std::uint32_t cornerFrom(std::string_view word, std::size_t vertexCount, const std::string& subject) {
    const std::optional<std::int64_t> number = integerFrom(word.substr(0, word.find('/')));
    const auto count = static_cast<std::int64_t>(vertexCount);
    if (!number || *number == 0 || *number > count || *number < -count) {
        throw Error(subject, "a face names vertex \"" + std::string(word.substr(0, 40)) + "\", which does not exist",
                    "export the mesh anew");
    }
    return static_cast<std::uint32_t>(*number > 0 ? *number - 1 : count + *number);
}

void appendNumberText(std::string& text, double value) {
    char buffer[64];
    text.append(buffer, std::to_chars(buffer, buffer + sizeof(buffer), value).ptr);
}

}  // namespace

TriangleMesh parseAsciiStl(std::string_view text, const std::string& subject) {
    const Error truncated(subject, "is truncated: the STL ends within the solid", "copy or export the file anew");
    StlVertices vertices;
    std::vector<std::uint32_t> corners;
    TextScanner words(text);
    // The name after "solid" may hold any word.
    words.line();
    for (std::string_view word = words.word(); word != "endsolid"; word = words.word()) {
        if (word.empty()) throw truncated;
        if (word == "vertex") corners.push_back(vertices.indexOf(vertexFrom(words, subject)));
        if (word == "endfacet" && corners.size() % 3 != 0) {
            throw Error(subject, "a facet of the STL does not have three vertices", "export the mesh anew");
        }
    }
    if (corners.size() % 3 != 0) throw truncated;
    TriangleMesh mesh;
    mesh.vertices = std::move(vertices).take();
    for (std::size_t i = 0; i < corners.size(); i += 3)
        mesh.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    return mesh;
}

TriangleMesh parseObj(std::string_view text, const std::string& subject) {
    TriangleMesh mesh;
    TextScanner lines(text);
    while (!lines.atEnd()) {
        TextScanner words(lines.line());
        const std::string_view keyword = words.word();
        if (keyword == "v") mesh.vertices.push_back(vertexFrom(words, subject));
        if (keyword != "f") continue;
        std::vector<std::uint32_t> corners;
        for (std::string_view word = words.word(); !word.empty(); word = words.word())
            corners.push_back(cornerFrom(word, mesh.vertices.size(), subject));
        if (corners.size() < 3) {
            throw Error(subject, "a face of the OBJ has fewer than three corners", "export the mesh anew");
        }
        for (std::size_t i = 2; i < corners.size(); ++i)
            mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }
    return mesh;
}

std::string objText(const TriangleMesh& mesh) {
    std::string text;
    for (const Eigen::Vector3d& vertex : mesh.vertices) {
        text += 'v';
        for (int axis = 0; axis < 3; ++axis) {
            text += ' ';
            appendNumberText(text, vertex[axis]);
        }
        text += '\n';
    }
    for (const auto& triangle : mesh.triangles) {
        text += 'f';
        for (const std::uint32_t index : triangle)
            text += ' ' + std::to_string(std::uint64_t{index} + 1);
        text += '\n';
    }
    return text;
}

}  // namespace fodscope
