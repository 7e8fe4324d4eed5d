// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <vector>

#include "core/cloud/CloudRows.h"
#include "core/cloud/Lzf.h"
#include "core/cloud/PcdFields.h"
#include "core/cloud/ScalarType.h"

namespace fodscope {
namespace {

/// Takes the fields out of the data as it is decompressed: first one field of all points, then the next.
class FieldColumns {
  public:
    FieldColumns(const PcdHeader& header, const PcdUsedFields& used, PointCloud& cloud)
        : points_(header.points), cloud_(cloud) {
        for (std::size_t axis = 0; axis < used.axes.size(); ++axis)
            columns_.push_back(columnOf(*used.axes[axis], static_cast<int>(axis)));
        if (used.colour != nullptr) columns_.push_back(columnOf(*used.colour, kColour));
    }

    /// @param begin the place of the first of the bytes in the decompressed data
    void take(std::span<const std::byte> bytes, std::uint64_t begin) {
        for (Column& column : columns_) {
            const std::uint64_t end = begin + bytes.size();
            for (; column.done < points_; ++column.done) {
                const std::uint64_t at = column.start + column.done * column.step;
                if (at + sizeOf(column.type) > end) break;
                store(column, bytes.data() + (at - begin));
            }
        }
    }

  private:
    static constexpr int kColour = 3;

    struct Column {
        ScalarType type = ScalarType::Float32;
        int target = 0;
        std::uint64_t start = 0;
        std::uint64_t step = 0;
        std::uint64_t done = 0;
    };

    Column columnOf(const PcdField& field, int target) const {
        return {field.type, target, points_ * field.offset, field.count * sizeOf(field.type), 0};
    }

    void store(const Column& column, const std::byte* bytes) {
        // What is not there yet is made when it is needed: a file may be damaged long before.
        if (column.target == kColour) {
            cloud_.colours.push_back(colourFrom(loadNumber<std::uint32_t>(bytes)));
            return;
        }
        if (cloud_.points.size() <= column.done) cloud_.points.emplace_back();
        cloud_.points[column.done][column.target] = loadScalar(bytes, column.type, std::endian::little);
    }

    std::uint64_t points_;
    PointCloud& cloud_;
    std::vector<Column> columns_;
};

/// Decompresses `size` bytes out of `compressedSize` bytes and hands them on piece by piece.
/// @return false when the data is damaged
bool decompress(ByteWindow& window, std::uint64_t compressedSize, std::uint64_t size, FieldColumns& columns) {
    std::vector<std::byte> output(kLzfFarthestMatch + ByteWindow::kPieceBytes);
    std::size_t filled = 0;
    // The place of the output's first byte in the data.
    std::uint64_t begin = 0;
    while (compressedSize > 0) {
        const std::span<const std::byte> ahead = window.ahead(kLzfLongestInstruction);
        const std::span<const std::byte> input =
            ahead.first(static_cast<std::size_t>(std::min<std::uint64_t>(ahead.size(), compressedSize)));
        const auto room = static_cast<std::size_t>(std::min<std::uint64_t>(output.size(), size - begin));
        const LzfSteps steps = lzfDecode(input, std::span(output).first(room), filled);
        // There is a whole instruction and room for what it gives, unless something is wrong.
        if (steps.read == 0) return false;
        window.skip(steps.read);
        compressedSize -= steps.read;
        columns.take(std::span(output).first(steps.written), begin);
        // Matches reach back so far.
        filled = std::min(steps.written, kLzfFarthestMatch);
        const std::size_t passed = steps.written - filled;
        std::copy_n(output.begin() + static_cast<std::ptrdiff_t>(passed), filled, output.begin());
        begin += passed;
    }
    return begin + filled == size;
}

void dropNonFinite(PointCloud& cloud) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
        if (!cloud.points[i].allFinite()) continue;
        cloud.points[kept] = cloud.points[i];
        if (!cloud.colours.empty()) cloud.colours[kept] = cloud.colours[i];
        ++kept;
    }
    cloud.droppedNonFinite += cloud.points.size() - kept;
    cloud.points.resize(kept);
    if (!cloud.colours.empty()) cloud.colours.resize(kept);
}

}  // namespace

PointCloud readCompressedPcd(ByteWindow& window, const PcdHeader& header, const PcdUsedFields& used,
                             const std::string& subject) {
    const std::span<const std::byte> sizes = window.ahead(8);
    if (sizes.size() < 8) throw truncatedPcd(subject, header);
    const std::size_t compressedSize = loadNumber<std::uint32_t>(sizes.data());
    const std::size_t size = loadNumber<std::uint32_t>(sizes.data() + 4);
    window.skip(8);
    if (compressedSize > window.remaining()) throw truncatedPcd(subject, header);
    if (size != header.points * header.stride || size > compressedSize * kLzfLargestExpansion) {
        throw Error(subject, "the size of its compressed data does not agree with its header",
                    "copy or export the file anew");
    }
    PointCloud cloud = roomFor(header, used);
    FieldColumns columns(header, used, cloud);
    if (!decompress(window, compressedSize, size, columns)) {
        throw Error(subject, "its compressed data is damaged", "copy or export the file anew");
    }
    dropNonFinite(cloud);
    return cloud;
}

}  // namespace fodscope
