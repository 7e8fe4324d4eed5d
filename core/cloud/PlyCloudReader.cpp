// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "core/cloud/CloudRows.h"
#include "core/cloud/PlyCloud.h"
#include "core/cloud/PlyNumbers.h"

namespace fodscope {
namespace {

constexpr std::array<std::string_view, 6> kNames{"x", "y", "z", "red", "green", "blue"};

/// Where a vertex holds coordinates and colour: the number of the property of each of kNames.
struct UsedProperties {
    std::array<std::optional<std::size_t>, kNames.size()> at;

    bool hasPoint() const { return at[0] && at[1] && at[2]; }
    bool hasColour() const { return at[3] && at[4] && at[5]; }
};

UsedProperties usedProperties(const PlyElement& element) {
    UsedProperties used;
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        const auto found = std::ranges::find_if(element.properties, [&](const PlyProperty& property) {
            return !property.isList && property.name == kNames[i];
        });
        if (found != element.properties.end())
            used.at[i] = static_cast<std::size_t>(found - element.properties.begin());
    }
    return used;
}

bool hasList(const PlyElement& element) {
    return std::ranges::any_of(element.properties, [](const PlyProperty& property) { return property.isList; });
}

/// For binary data without lists.
CloudRows rowsOf(const PlyElement& element, const UsedProperties& used, std::endian order) {
    CloudRows rows;
    rows.count = element.count;
    rows.order = order;
    std::vector<RowField> fields;
    for (const PlyProperty& property : element.properties) {
        fields.push_back({rows.stride, property.type});
        rows.stride += sizeOf(property.type);
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
        rows.axes[axis] = fields[*used.at[axis]];
    if (used.hasColour()) rows.channels = {fields[*used.at[3]], fields[*used.at[4]], fields[*used.at[5]]};
    return rows;
}

/// Number by number, for text and lists.
void appendVertices(const PlyElement& element, const UsedProperties& used, PlyNumbers& numbers, PointCloud& cloud) {
    std::vector<double> row(element.properties.size());
    const auto channel = [&](std::size_t name) {
        return colourByte(row[*used.at[name]], element.properties[*used.at[name]].type);
    };
    for (std::uint64_t i = 0; i < element.count; ++i) {
        for (std::size_t at = 0; at < row.size(); ++at) {
            const PlyProperty& property = element.properties[at];
            for (std::uint32_t left = property.isList ? numbers.nextListSize(property) : 1; left > 0; --left)
                row[at] = numbers.next(property.type);
        }
        if (!used.hasPoint()) continue;
        std::optional<Rgb> colour;
        if (used.hasColour()) colour = {channel(3), channel(4), channel(5)};
        appendPoint(cloud, {row[*used.at[0]], row[*used.at[1]], row[*used.at[2]]}, colour);
    }
}

PointCloud readVertices(const PlyElement& element, PlyNumbers& numbers, const std::string& subject) {
    const UsedProperties used = usedProperties(element);
    PointCloud cloud;
    if (used.hasPoint()) {
        cloud.points.reserve(element.count);
        if (used.hasColour()) cloud.colours.reserve(element.count);
    }
    if (used.hasPoint() && !numbers.isText() && !hasList(element)) {
        if (!appendRows(numbers.window(), rowsOf(element, used, numbers.order()), cloud)) throw numbers.truncated();
    } else if (!element.properties.empty()) {
        appendVertices(element, used, numbers, cloud);
    }
    if (!used.hasPoint()) throw noPlyCoordinates(subject);
    return cloud;
}

}  // namespace

PointCloud readPlyCloud(ByteWindow& window, const std::string& subject) {
    const PlyHeader header = readPlyHeader(window, subject);
    PlyNumbers numbers(window, header.encoding, subject);
    for (const PlyElement& element : header.elements) {
        numbers.requireRows(element);
        if (element.name == "vertex") return readVertices(element, numbers, subject);
        numbers.skipRows(element);
    }
    throw noPlyCoordinates(subject);
}

}  // namespace fodscope
