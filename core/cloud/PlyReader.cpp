// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/cloud/Ply.h"
#include "core/cloud/PlyHeader.h"
#include "core/cloud/TextScanner.h"
#include "core/common/Error.h"

namespace fodscope {
namespace {

/// Bytes that one row takes at the least; an ascii value takes a digit and a blank or line end.
std::uint64_t leastRowBytes(const PlyElement& element, PlyEncoding encoding) {
    std::uint64_t bytes = 0;
    for (const PlyProperty& property : element.properties) {
        if (encoding == PlyEncoding::Ascii) {
            bytes += 2;
        } else {
            bytes += sizeOf(property.isList ? property.countType : property.type);
        }
    }
    return bytes;
}

/// The numbers of the data one after the other, whatever the encoding.
class PlyNumbers {
  public:
    PlyNumbers(std::span<const std::byte> bytes, const PlyHeader& header, const std::string& subject)
        : bytes_(bytes),
          encoding_(header.encoding),
          position_(header.dataOffset),
          words_(textOf(bytes), header.dataOffset),
          subject_(subject) {}

    double next(ScalarType type) {
        if (encoding_ == PlyEncoding::Ascii) return asStored(nextWord(), type);
        const std::size_t size = sizeOf(type);
        if (size > bytes_.size() - position_) throw truncated();
        const std::endian order = encoding_ == PlyEncoding::BigEndian ? std::endian::big : std::endian::little;
        const double value = loadScalar(bytes_.data() + position_, type, order);
        position_ += size;
        return value;
    }

    /// @return the number of entries of a list, which the rest of the file can hold
    std::uint32_t nextListSize(const PlyProperty& list) {
        const double size = next(list.countType);
        if (!(size >= 0.0) || size != std::floor(size)) {
            throw Error(subject_, "a list in its PLY data has no proper length", "export the file anew");
        }
        const std::size_t itemBytes = encoding_ == PlyEncoding::Ascii ? 2 : sizeOf(list.type);
        // The last ascii value may lack its line end.
        if (size > static_cast<double>((remaining() + 1) / itemBytes)) throw truncated();
        return static_cast<std::uint32_t>(size);
    }

    void requireRows(const PlyElement& element) const {
        const std::uint64_t rowBytes = leastRowBytes(element, encoding_);
        if (rowBytes > 0 && element.count > (remaining() + 1) / rowBytes) {
            throw Error(subject_,
                        "is truncated: its header announces " + std::to_string(element.count) + " of \"" +
                            element.name + "\", the file is too short for them",
                        "copy or export the file anew");
        }
    }

  private:
    std::size_t remaining() const {
        return bytes_.size() - (encoding_ == PlyEncoding::Ascii ? words_.position() : position_);
    }

    double nextWord() {
        const std::string_view word = words_.word();
        if (word.empty()) throw truncated();
        const std::optional<double> value = numberFrom(word);
        if (!value) {
            throw Error(subject_, "\"" + std::string(word.substr(0, 40)) + "\" in its data is not a number",
                        "export the file anew");
        }
        return *value;
    }

    Error truncated() const {
        return Error(subject_, "is truncated: its data ends before all that its header announces",
                     "copy or export the file anew");
    }

    std::span<const std::byte> bytes_;
    PlyEncoding encoding_;
    std::size_t position_;
    TextScanner words_;
    const std::string& subject_;
};

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

/// @param faces null: the rows are passed over
void readRows(const PlyElement& element, PlyNumbers& numbers, PlyContents* faces) {
    if (element.properties.empty()) return;
    for (std::uint64_t row = 0; row < element.count; ++row) {
        for (const PlyProperty& property : element.properties) {
            const bool isFace = faces != nullptr && isCornerList(property);
            const std::uint32_t size = property.isList ? numbers.nextListSize(property) : 1;
            if (isFace) faces->faceSizes.push_back(size);
            for (std::uint32_t i = 0; i < size; ++i) {
                const double value = numbers.next(property.type);
                // Anything that is no index becomes one that no mesh has.
                if (isFace) faces->faceIndices.push_back(std::abs(value) < 1e15 ? std::llround(value) : -1);
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
    PlyHeader header = parsePlyHeader(bytes, subject);
    PlyContents contents;
    contents.comments = std::move(header.comments);
    for (const PlyElement& element : header.elements) {
        if (element.name == "face") contents.faceCount = element.count;
    }
    PlyNumbers numbers(bytes, header, subject);
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
        } else {
            readRows(element, numbers, isFaces ? &contents : nullptr);
            if (isFaces) break;
        }
    }
    return contents;
}

}  // namespace fodscope
