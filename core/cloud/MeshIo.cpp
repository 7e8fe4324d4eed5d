// SPDX-License-Identifier: MIT
#include "core/cloud/MeshIo.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

#include "core/cloud/MeshText.h"
#include "core/cloud/Ply.h"
#include "core/cloud/PlyCloud.h"
#include "core/cloud/StlMesh.h"
#include "core/cloud/TextScanner.h"
#include "core/common/Error.h"
#include "core/common/Files.h"

namespace fodscope {
namespace {

enum class MeshFormat { Ply, BinaryStl, AsciiStl, Obj, None };

std::string lowerExtension(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

bool hasObjVertex(std::string_view text) {
    if (text.find('\0') != std::string_view::npos) return false;
    TextScanner lines(text);
    while (!lines.atEnd()) {
        const std::string_view line = lines.line();
        if (line.starts_with("v ") || line.starts_with("v\t")) return true;
    }
    return false;
}

MeshFormat formatOf(std::span<const std::byte> bytes, const std::filesystem::path& file) {
    const std::string_view text = textOf(bytes);
    if (isPly(bytes)) return MeshFormat::Ply;
    // Some programs begin binary STL with "solid" too, so the size is asked first.
    if (isBinaryStl(bytes)) return MeshFormat::BinaryStl;
    const std::string_view start = text.substr(0, 1 << 12);
    if (start.starts_with("solid") && (start.find("facet") != start.npos || start.find("endsolid") != start.npos)) {
        return MeshFormat::AsciiStl;
    }
    if (lowerExtension(file) == ".stl") return MeshFormat::BinaryStl;
    if (hasObjVertex(text)) return MeshFormat::Obj;
    return MeshFormat::None;
}

TriangleMesh meshFromPly(const PlyContents& contents, const std::string& subject) {
    TriangleMesh mesh;
    mesh.vertices = plyPoints(contents, subject);
    mesh.colours = plyColours(contents);
    const auto vertexCount = static_cast<std::int64_t>(mesh.vertices.size());
    std::size_t first = 0;
    for (const std::uint32_t size : contents.faceSizes) {
        const auto corners = std::span(contents.faceIndices).subspan(first, size);
        first += size;
        for (const std::int64_t index : corners) {
            if (index < 0 || index >= vertexCount) {
                throw Error(subject, "a face names a vertex that does not exist", "export the mesh anew");
            }
        }
        const auto corner = [&](std::size_t i) { return static_cast<std::uint32_t>(corners[i]); };
        for (std::size_t i = 2; i < corners.size(); ++i)
            mesh.triangles.push_back({corner(0), corner(i - 1), corner(i)});
    }
    return mesh;
}

TriangleMesh parseMesh(std::span<const std::byte> bytes, const std::filesystem::path& file) {
    const std::string subject = file.string();
    if (bytes.empty()) throw Error(subject, "is empty", "copy or export the file anew");
    switch (formatOf(bytes, file)) {
        case MeshFormat::Ply:
            return meshFromPly(parsePly(bytes, subject, PlyFaces::Read), subject);
        case MeshFormat::BinaryStl:
            return parseBinaryStl(bytes, subject);
        case MeshFormat::AsciiStl:
            return parseAsciiStl(textOf(bytes), subject);
        case MeshFormat::Obj:
            return parseObj(textOf(bytes), subject);
        case MeshFormat::None:
            break;
    }
    throw Error(subject, "is no mesh (neither STL, PLY nor OBJ)", "give a mesh in one of these formats");
}

}  // namespace

TriangleMesh readMesh(const std::filesystem::path& file, double scale) {
    if (!(scale > 0.0) || !std::isfinite(scale)) {
        throw Error("scale", "must be greater than 0", "give for example 0.001 for a mesh in millimetres");
    }
    TriangleMesh mesh = parseMesh(readFile(file), file);
    if (mesh.triangles.empty()) {
        throw Error(file.string(), "holds no triangles", "give a mesh with faces, not a point cloud");
    }
    for (Eigen::Vector3d& vertex : mesh.vertices) {
        vertex *= scale;
        if (!vertex.allFinite()) {
            throw Error(file.string(), "a vertex is not finite (NaN or infinite)", "repair or export the mesh anew");
        }
    }
    return mesh;
}

void writeMesh(const std::filesystem::path& file, const TriangleMesh& mesh) {
    const std::string extension = lowerExtension(file);
    if (extension == ".ply") {
        writePly(file, {}, plyColumns(mesh.vertices, mesh.colours), mesh.triangles);
    } else if (extension == ".stl") {
        writeFile(file, binaryStlBytes(mesh));
    } else if (extension == ".obj") {
        writeFile(file, objText(mesh));
    } else {
        throw Error(file.string(), "\"" + extension + "\" is no extension of a mesh",
                    "end the name in .ply, .stl or .obj");
    }
}

bool isMeshFile(const std::filesystem::path& file) {
    try {
        const std::vector<std::byte> bytes = readFile(file);
        switch (formatOf(bytes, file)) {
            case MeshFormat::Ply:
                return parsePly(bytes, file.string(), PlyFaces::Ignore).faceCount > 0;
            case MeshFormat::BinaryStl:
                return isBinaryStl(bytes);
            case MeshFormat::AsciiStl:
                return true;
            case MeshFormat::Obj:
                return !parseObj(textOf(bytes), file.string()).triangles.empty();
            case MeshFormat::None:
                return false;
        }
    } catch (const Error&) {
        return false;
    }
    return false;
}

}  // namespace fodscope
