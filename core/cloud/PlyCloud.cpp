// SPDX-License-Identifier: MIT
#include "core/cloud/PlyCloud.h"

#include "core/cloud/CloudRows.h"

namespace fodscope {
Error noPlyCoordinates(const std::string& subject) {
    return Error(subject, "has no vertex properties x, y and z", "give a point cloud with coordinates");
}

std::vector<Eigen::Vector3d> plyPoints(const PlyContents& contents, const std::string& subject) {
    const PlyColumn* x = contents.column("x");
    const PlyColumn* y = contents.column("y");
    const PlyColumn* z = contents.column("z");
    if (x == nullptr || y == nullptr || z == nullptr) throw noPlyCoordinates(subject);
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
    const auto byteOf = [](const PlyColumn& column, std::size_t i) {
        return colourByte(column.values[i], column.type);
    };
    std::vector<Rgb> colours(contents.vertexCount);
    for (std::size_t i = 0; i < colours.size(); ++i)
        colours[i] = {byteOf(*red, i), byteOf(*green, i), byteOf(*blue, i)};
    return colours;
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
