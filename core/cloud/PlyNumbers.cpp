// SPDX-License-Identifier: MIT
#include "core/cloud/PlyNumbers.h"

#include <cmath>
#include <optional>

#include "core/cloud/TextScanner.h"

namespace fodscope {
namespace {

/// Bytes that one row takes at the least; an ascii value takes a digit and a blank or line end.
std::uint64_t leastRowBytes(const PlyElement& element, bool isText) {
    std::uint64_t bytes = 0;
    for (const PlyProperty& property : element.properties) {
        if (isText) {
            bytes += 2;
        } else {
            bytes += sizeOf(property.isList ? property.countType : property.type);
        }
    }
    return bytes;
}

}  // namespace

double PlyNumbers::next(ScalarType type) {
    if (isText()) return asStored(nextInText(), type);
    const std::size_t size = sizeOf(type);
    const std::span<const std::byte> bytes = window_.ahead(size);
    if (size > bytes.size()) throw truncated();
    const double value = loadScalar(bytes.data(), type, order());
    window_.skip(size);
    return value;
}

std::uint32_t PlyNumbers::nextListSize(const PlyProperty& list) {
    const double size = next(list.countType);
    if (!(size >= 0.0) || size != std::floor(size)) {
        throw Error(subject_, "a list in its PLY data has no proper length", "export the file anew");
    }
    const std::size_t itemBytes = isText() ? 2 : sizeOf(list.type);
    // The last ascii value may lack its line end.
    if (size > static_cast<double>((window_.remaining() + 1) / itemBytes)) throw truncated();
    return static_cast<std::uint32_t>(size);
}

void PlyNumbers::requireRows(const PlyElement& element) const {
    const std::uint64_t rowBytes = leastRowBytes(element, isText());
    if (rowBytes > 0 && element.count > (window_.remaining() + 1) / rowBytes) {
        throw Error(subject_,
                    "is truncated: its header announces " + std::to_string(element.count) + " of \"" + element.name +
                        "\", the file is too short for them",
                    "copy or export the file anew");
    }
}

void PlyNumbers::skipRows(const PlyElement& element) {
    if (element.properties.empty()) return;
    for (std::uint64_t row = 0; row < element.count; ++row) {
        for (const PlyProperty& property : element.properties) {
            for (std::uint32_t left = property.isList ? nextListSize(property) : 1; left > 0; --left)
                next(property.type);
        }
    }
}

double PlyNumbers::nextInText() {
    const std::string_view word = nextWord(window_);
    if (word.empty()) throw truncated();
    const std::optional<double> value = numberFrom(word);
    if (!value) {
        throw Error(subject_, "\"" + std::string(word.substr(0, 40)) + "\" in its data is not a number",
                    "export the file anew");
    }
    return *value;
}

Error PlyNumbers::truncated() const {
    return Error(subject_, "is truncated: its data ends before all that its header announces",
                 "copy or export the file anew");
}

PlyHeader readPlyHeader(ByteWindow& window, const std::string& subject) {
    PlyHeader header = parsePlyHeader(aheadWithLine(window, "end_header"), subject);
    window.skip(header.dataOffset);
    return header;
}

}  // namespace fodscope
