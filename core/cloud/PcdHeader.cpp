// SPDX-License-Identifier: MIT
#include "core/cloud/PcdHeader.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "core/cloud/TextScanner.h"
#include "core/common/Error.h"

namespace fodscope {
namespace {

using Lines = std::map<std::string, std::vector<std::string>>;

/// Far above any point type; keeps the products below from overflowing.
constexpr std::uint64_t kLargestFieldCount = 1 << 16;
constexpr std::uint64_t kLargestPointCount = std::numeric_limits<std::uint32_t>::max();

Error malformed(const std::string& subject, const std::string& problem) {
    return Error(subject, "its PCD header is malformed (" + problem + ")", "export the file anew");
}

std::uint64_t countOf(const std::string& word, const std::string& key, const std::string& subject) {
    const std::optional<std::uint64_t> count = countFrom(word);
    if (!count) throw malformed(subject, key + " is not a whole number");
    return *count;
}

std::uint64_t singleCount(const Lines& lines, const std::string& key, const std::string& subject) {
    const auto& words = lines.at(key);
    if (words.size() != 1) throw malformed(subject, key + " must be one number");
    const std::uint64_t count = countOf(words.front(), key, subject);
    if (count > kLargestPointCount) throw malformed(subject, key + " is absurdly large");
    return count;
}

std::uint64_t pointCount(const Lines& lines, const std::string& subject) {
    const bool hasExtent = lines.contains("WIDTH") && lines.contains("HEIGHT");
    if (!hasExtent && !lines.contains("POINTS")) throw malformed(subject, "it does not tell the number of points");
    const std::uint64_t product =
        hasExtent ? singleCount(lines, "WIDTH", subject) * singleCount(lines, "HEIGHT", subject) : 0;
    const std::uint64_t points = lines.contains("POINTS") ? singleCount(lines, "POINTS", subject) : product;
    if (hasExtent && points != product) throw malformed(subject, "POINTS is not WIDTH times HEIGHT");
    return points;
}

ScalarType typeFrom(const std::string& type, std::uint64_t size, const std::string& subject) {
    if (type == "F" && size == 4) return ScalarType::Float32;
    if (type == "F" && size == 8) return ScalarType::Float64;
    if (type == "I" && size == 1) return ScalarType::Int8;
    if (type == "I" && size == 2) return ScalarType::Int16;
    if (type == "I" && size == 4) return ScalarType::Int32;
    if (type == "I" && size == 8) return ScalarType::Int64;
    if (type == "U" && size == 1) return ScalarType::UInt8;
    if (type == "U" && size == 2) return ScalarType::UInt16;
    if (type == "U" && size == 4) return ScalarType::UInt32;
    if (type == "U" && size == 8) return ScalarType::UInt64;
    throw malformed(subject, "no type \"" + type + "\" has " + std::to_string(size) + " bytes");
}

/// @return the line's word for field i, or `otherwise` when the header lacks the line
std::string wordFor(const Lines& lines, const std::string& key, std::size_t i, const std::string& otherwise) {
    const auto found = lines.find(key);
    return found == lines.end() ? otherwise : found->second[i];
}

void readFields(const Lines& lines, const std::string& subject, PcdHeader& header) {
    const auto named = lines.find(lines.contains("FIELDS") ? "FIELDS" : "COLUMNS");
    if (named == lines.end() || named->second.empty()) throw malformed(subject, "it names no fields");
    const std::vector<std::string>& names = named->second;
    for (const char* key : {"SIZE", "TYPE", "COUNT"}) {
        const auto found = lines.find(key);
        if (found != lines.end() && found->second.size() != names.size()) {
            throw malformed(subject, std::string(key) + " does not have one entry for each field");
        }
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        PcdField field;
        field.name = names[i];
        const std::uint64_t size = countOf(wordFor(lines, "SIZE", i, "4"), "SIZE", subject);
        field.type = typeFrom(wordFor(lines, "TYPE", i, "F"), size, subject);
        field.count = countOf(wordFor(lines, "COUNT", i, "1"), "COUNT", subject);
        if (field.count > kLargestFieldCount) throw malformed(subject, "COUNT is absurdly large");
        field.offset = header.stride;
        field.column = header.columns;
        header.stride += size * field.count;
        header.columns += field.count;
        header.fields.push_back(field);
    }
    if (header.stride == 0) throw malformed(subject, "its points have no data");
}

PcdEncoding encodingFrom(const std::string& name, const std::string& subject) {
    if (name == "ascii") return PcdEncoding::Ascii;
    if (name == "binary") return PcdEncoding::Binary;
    if (name == "binary_compressed") return PcdEncoding::BinaryCompressed;
    throw malformed(subject, "unknown data encoding \"" + name.substr(0, 40) + "\"");
}

}  // namespace

const PcdField* PcdHeader::field(std::string_view name) const {
    const auto found =
        std::find_if(fields.begin(), fields.end(), [&](const PcdField& field) { return field.name == name; });
    return found == fields.end() || found->count == 0 ? nullptr : &*found;
}

PcdHeader parsePcdHeader(std::span<const std::byte> bytes, const std::string& subject) {
    static constexpr std::string_view known[] = {"VERSION", "FIELDS", "COLUMNS",   "SIZE",   "TYPE", "COUNT",
                                                 "WIDTH",   "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};
    Lines lines;
    TextScanner text(textOf(bytes));
    while (!text.atEnd() && !lines.contains("DATA")) {
        TextScanner words(text.line());
        const std::string key(words.word());
        if (key.empty() || key.front() == '#') continue;
        if (std::find(std::begin(known), std::end(known), key) == std::end(known)) {
            throw malformed(subject, "unknown line \"" + key.substr(0, 40) + "\"");
        }
        std::vector<std::string>& values = lines[key];
        values.clear();
        for (std::string_view word = words.word(); !word.empty(); word = words.word())
            values.emplace_back(word);
    }
    if (!lines.contains("DATA") || lines["DATA"].size() != 1) {
        throw Error(subject, "is truncated: its PCD header has no end", "copy or export the file anew");
    }
    PcdHeader header;
    header.encoding = encodingFrom(lines["DATA"].front(), subject);
    header.dataOffset = text.position();
    header.points = pointCount(lines, subject);
    readFields(lines, subject, header);
    return header;
}

}  // namespace fodscope
