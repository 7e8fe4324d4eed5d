// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>

#include "core/cloud/Ply.h"
#include "core/cloud/PlyHeader.h"
#include "core/cloud/PlyNumbers.h"
#include "core/cloud/TextScanner.h"

namespace fodscope {
namespace {

void readVertices(const PlyElement& element, PlyNumbers& numbers, PlyContents& contents) {
    if (element.properties.empty()) return;
    contents.vertexCount = element.count;
    for (const PlyProperty& property : element.properties) {
        if (property.isList) continue;
        contents.columns.push_back({property.name, property.type, {}});
        contents.columns.back().values.reserve(element.count);
    }
    for (std::uint64_t row = 0; row < element.count; ++row) {
        auto column = contents.columns.begin();
        for (const PlyProperty& property : element.properties) {
            if (!property.isList) {
                (column++)->values.push_back(numbers.next(property.type));
                continue;
            }
            for (std::uint32_t left = numbers.nextListSize(property); left > 0; --left)
                numbers.next(property.type);
        }
    }
}

bool isCornerList(const PlyProperty& property) {
    return property.isList && (property.name == "vertex_indices" || property.name == "vertex_index");
}

void readFaces(const PlyElement& element, PlyNumbers& numbers, PlyContents& contents) {
    if (element.properties.empty()) return;
    for (std::uint64_t row = 0; row < element.count; ++row) {
        for (const PlyProperty& property : element.properties) {
            const bool isFace = isCornerList(property);
            const std::uint32_t size = property.isList ? numbers.nextListSize(property) : 1;
            if (isFace) contents.faceSizes.push_back(size);
            for (std::uint32_t i = 0; i < size; ++i) {
                const double value = numbers.next(property.type);
                // Anything that is no index becomes one that no mesh has.
                if (isFace) contents.faceIndices.push_back(std::abs(value) < 1e15 ? std::llround(value) : -1);
            }
        }
    }
}

}  // namespace

const PlyColumn* PlyContents::column(std::string_view name) const {
    const auto found =
        std::find_if(columns.begin(), columns.end(), [&](const PlyColumn& column) { return column.name == name; });
    return found == columns.end() ? nullptr : &*found;
}

bool isPly(std::span<const std::byte> bytes) {
    const std::string_view text = textOf(bytes);
    return text.starts_with("ply\n") || text.starts_with("ply\r");
}

PlyContents parsePly(std::span<const std::byte> bytes, const std::string& subject, PlyFaces faces) {
    ByteWindow window(bytes);
    PlyHeader header = readPlyHeader(window, subject);
    PlyContents contents;
    contents.comments = std::move(header.comments);
    for (const PlyElement& element : header.elements) {
        if (element.name == "face") contents.faceCount = element.count;
    }
    PlyNumbers numbers(window, header.encoding, subject);
    bool hasVertices = false;
    for (const PlyElement& element : header.elements) {
        numbers.requireRows(element);
        const bool isVertices = element.name == "vertex" && !hasVertices;
        const bool isFaces = element.name == "face" && faces == PlyFaces::Read;
        if (isVertices) {
            readVertices(element, numbers, contents);
            hasVertices = true;
            // Of what follows the vertices only the faces may be of use.
            if (faces == PlyFaces::Ignore) break;
        } else if (isFaces) {
            readFaces(element, numbers, contents);
            break;
        } else {
            numbers.skipRows(element);
        }
    }
    return contents;
}

}  // namespace fodscope
