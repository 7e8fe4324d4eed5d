// SPDX-License-Identifier: MIT
#include "core/cloud/PlyHeader.h"

#include <optional>
#include <string_view>
#include <utility>

#include "core/cloud/TextScanner.h"
#include "core/common/Error.h"

namespace fodscope {
namespace {

Error malformed(const std::string& subject, const std::string& problem) {
    return Error(subject, "its PLY header is malformed (" + problem + ")", "export the file anew");
}

std::optional<ScalarType> typeFrom(std::string_view name) {
    static constexpr std::pair<std::string_view, ScalarType> names[] = {
        {"char", ScalarType::Int8},      {"int8", ScalarType::Int8},       {"uchar", ScalarType::UInt8},
        {"uint8", ScalarType::UInt8},    {"short", ScalarType::Int16},     {"int16", ScalarType::Int16},
        {"ushort", ScalarType::UInt16},  {"uint16", ScalarType::UInt16},   {"int", ScalarType::Int32},
        {"int32", ScalarType::Int32},    {"uint", ScalarType::UInt32},     {"uint32", ScalarType::UInt32},
        {"float", ScalarType::Float32},  {"float32", ScalarType::Float32}, {"double", ScalarType::Float64},
        {"float64", ScalarType::Float64}};
    for (const auto& [known, type] : names) {
        if (name == known) return type;
    }
    return std::nullopt;
}

ScalarType typeFrom(std::string_view name, const std::string& subject) {
    const std::optional<ScalarType> type = typeFrom(name);
    if (!type) throw malformed(subject, "unknown type \"" + std::string(name) + "\"");
    return *type;
}

PlyEncoding encodingFrom(std::string_view name, const std::string& subject) {
    if (name == "ascii") return PlyEncoding::Ascii;
    if (name == "binary_little_endian") return PlyEncoding::LittleEndian;
    if (name == "binary_big_endian") return PlyEncoding::BigEndian;
    throw malformed(subject, "unknown format \"" + std::string(name) + "\"");
}

PlyElement elementFrom(TextScanner& words, const std::string& subject) {
    PlyElement element;
    element.name = words.word();
    const std::optional<std::uint64_t> count = countFrom(words.word());
    if (element.name.empty() || !count) throw malformed(subject, "an element without name or count");
    element.count = *count;
    return element;
}

PlyProperty propertyFrom(TextScanner& words, const std::string& subject) {
    PlyProperty property;
    std::string_view type = words.word();
    if (type == "list") {
        property.isList = true;
        property.countType = typeFrom(words.word(), subject);
        type = words.word();
    }
    property.type = typeFrom(type, subject);
    property.name = words.word();
    if (property.name.empty()) throw malformed(subject, "a property without name");
    return property;
}

std::string_view afterKeyword(std::string_view line, std::string_view keyword) {
    line.remove_prefix(keyword.size());
    return line.starts_with(' ') ? line.substr(1) : line;
}

}  // namespace

PlyHeader parsePlyHeader(std::span<const std::byte> bytes, const std::string& subject) {
    PlyHeader header;
    TextScanner lines(textOf(bytes));
    bool hasFormat = false;
    lines.line();
    while (!lines.atEnd()) {
        const std::string_view line = lines.line();
        TextScanner words(line);
        const std::string_view keyword = words.word();
        if (keyword == "end_header") {
            if (!hasFormat) throw malformed(subject, "it names no format");
            header.dataOffset = lines.position();
            return header;
        }
        if (keyword == "format") {
            header.encoding = encodingFrom(words.word(), subject);
            hasFormat = true;
        } else if (keyword == "comment") {
            header.comments.emplace_back(afterKeyword(line, keyword));
        } else if (keyword == "element") {
            header.elements.push_back(elementFrom(words, subject));
        } else if (keyword == "property") {
            if (header.elements.empty()) throw malformed(subject, "a property before any element");
            header.elements.back().properties.push_back(propertyFrom(words, subject));
        } else if (!keyword.empty() && keyword != "obj_info") {
            throw malformed(subject, "unknown keyword \"" + std::string(keyword.substr(0, 40)) + "\"");
        }
    }
    throw Error(subject, "is truncated: its PLY header has no end", "copy or export the file anew");
}

}  // namespace fodscope
