// SPDX-License-Identifier: MIT
#include "core/cloud/PlyCloud.h"

#include <algorithm>
#include <cmath>

#include "core/common/Error.h"

namespace fodscope {
namespace {

/// Integer colours run to 255, floating ones to 1.
std::uint8_t colourByte(const PlyColumn& column, std::size_t i) {
    const double value = column.values[i] * (isFloating(column.type) ? 255.0 : 1.0);
    return value >= 0.0 ? static_cast<std::uint8_t>(std::lround(std::min(value, 255.0))) : std::uint8_t{0};
}

}  // namespace

std::vector<Eigen::Vector3d> plyPoints(const PlyContents& contents, const std::string& subject) {
    const PlyColumn* x = contents.column("x");
    const PlyColumn* y = contents.column("y");
    const PlyColumn* z = contents.column("z");
    if (x == nullptr || y == nullptr || z == nullptr) {
        throw Error(subject, "has no vertex properties x, y and z", "give a point cloud with coordinates");
    }
    std::vector<Eigen::Vector3d> points(contents.vertexCount);
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = {x->values[i], y->values[i], z->values[i]};
    return points;
}

std::vector<Rgb> plyColours(const PlyContents& contents) {
    const PlyColumn* red = contents.column("red");
    const PlyColumn* green = contents.column("green");
    const PlyColumn* blue = contents.column("blue");
    if (red == nullptr || green == nullptr || blue == nullptr) return {};
    std::vector<Rgb> colours(contents.vertexCount);
    for (std::size_t i = 0; i < colours.size(); ++i)
        colours[i] = {colourByte(*red, i), colourByte(*green, i), colourByte(*blue, i)};
    return colours;
}

PointCloud cloudFromPly(const PlyContents& contents, const std::string& subject) {
    const std::vector<Eigen::Vector3d> points = plyPoints(contents, subject);
    const std::vector<Rgb> colours = plyColours(contents);
    PointCloud cloud;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i].allFinite()) {
            ++cloud.droppedNonFinite;
            continue;
        }
        cloud.points.push_back(points[i]);
        if (!colours.empty()) cloud.colours.push_back(colours[i]);
    }
    return cloud;
}

std::vector<PlyColumn> plyColumns(std::span<const Eigen::Vector3d> points, std::span<const Rgb> colours) {
    std::vector<PlyColumn> columns{
        {"x", ScalarType::Float32, {}}, {"y", ScalarType::Float32, {}}, {"z", ScalarType::Float32, {}}};
    for (const Eigen::Vector3d& point : points) {
        for (int axis = 0; axis < 3; ++axis)
            columns[static_cast<std::size_t>(axis)].values.push_back(point[axis]);
    }
    if (colours.empty()) return columns;
    PlyColumn red{"red", ScalarType::UInt8, {}};
    PlyColumn green{"green", ScalarType::UInt8, {}};
    PlyColumn blue{"blue", ScalarType::UInt8, {}};
    for (const Rgb& colour : colours) {
        red.values.push_back(colour.red);
        green.values.push_back(colour.green);
        blue.values.push_back(colour.blue);
    }
    columns.insert(columns.end(), {red, green, blue});
    return columns;
}

}  // namespace fodscope
