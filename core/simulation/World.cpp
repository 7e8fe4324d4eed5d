// SPDX-License-Identifier: MIT
#include "core/simulation/World.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/cloud/MeshIo.h"
#include "core/common/Error.h"
#include "core/common/Files.h"
#include "core/simulation/MeshShapes.h"

namespace fodscope {
namespace {

using nlohmann::json;

constexpr const char* kSchema = "fodscope.world/1";
constexpr const char* kRemedy =
    "write it as fodscope.world/1, with structure, objects, T_map_from_world and robot_start";
/// A world of tools in a tank has a handful; more is a damaged or hostile file.
constexpr std::size_t kMostObjects = 10000;

const json& member(const json& parent, const char* key, const std::string& subject) {
    const auto found = parent.find(key);
    if (found == parent.end()) throw Error(subject, std::string("the key \"") + key + "\" is missing", kRemedy);
    return *found;
}

std::string text(const json& parent, const char* key, const std::string& subject) {
    const json& value = member(parent, key, subject);
    if (!value.is_string() || value.get_ref<const std::string&>().empty())
        throw Error(subject, std::string("\"") + key + "\" is not a text", kRemedy);
    return value.get<std::string>();
}

double number(const json& value, const std::string& what, const std::string& subject) {
    if (!value.is_number() || !std::isfinite(value.get<double>()))
        throw Error(subject, what + " is not a finite number", kRemedy);
    return value.get<double>();
}

/// 4×4 rows, nested or flat.
Transform transform(const json& value, const std::string& subject) {
    std::vector<double> numbers;
    const auto take = [&](const json& entry) {
        numbers.push_back(number(entry, "an entry of \"T_map_from_world\"", subject));
    };
    if (value.is_array() && value.size() <= 16) {
        for (const json& row : value) {
            if (row.is_array() && row.size() == 4)
                for (const json& entry : row)
                    take(entry);
            else
                take(row);
        }
    }
    std::array<double, 16> rows{};
    if (numbers.size() != rows.size()) throw Error(subject, "\"T_map_from_world\" is not 4 rows of 4 numbers", kRemedy);
    std::copy(numbers.begin(), numbers.end(), rows.begin());
    return transformFromRows(rows, subject);
}

Eigen::Vector3d point(const json& value, const std::string& what, const std::string& subject) {
    if (!value.is_array() || value.size() != 3) throw Error(subject, what + " is not a list of 3 numbers", kRemedy);
    Eigen::Vector3d result;
    for (int axis = 0; axis < 3; ++axis)
        result[axis] = number(value[static_cast<std::size_t>(axis)], what, subject);
    return result;
}

Pose2 startPose(const json& value, const std::string& subject) {
    if (!value.is_object()) throw Error(subject, "\"robot_start\" is not an object with x, y and yaw_deg", kRemedy);
    return {
        number(member(value, "x", subject), "\"robot_start\" x", subject),
        number(member(value, "y", subject), "\"robot_start\" y", subject),
        wrapAngle(radiansFromDegrees(number(member(value, "yaw_deg", subject), "\"robot_start\" yaw_deg", subject)))};
}

TriangleMesh meshBeside(const std::filesystem::path& file, const std::string& name) {
    return readMesh(file.parent_path() / std::filesystem::path(name));
}

WorldObject object(const json& value, const std::filesystem::path& file, const std::string& subject) {
    if (!value.is_object()) throw Error(subject, "an entry of \"objects\" is not an object", kRemedy);
    WorldObject result;
    result.type = text(value, "type", subject);
    const json& fod = member(value, "fod", subject);
    if (!fod.is_boolean()) throw Error(subject, "\"fod\" is neither true nor false", kRemedy);
    result.fod = fod.get<bool>();
    result.mesh = meshBeside(file, text(value, "mesh", subject));
    const auto centroid = value.find("centroid");
    result.centroid_world = centroid == value.end() || centroid->is_null() ? surfaceCentroid(result.mesh)
                                                                           : point(*centroid, "\"centroid\"", subject);
    return result;
}

/// Types are free text; file names are not.
std::string fileNameOf(std::size_t index, const std::string& type) {
    std::string name = std::to_string(index) + "_";
    for (const char c : type.substr(0, 40)) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        name += plain ? c : '_';
    }
    return name + ".ply";
}

}  // namespace

World readWorld(const std::filesystem::path& file) {
    const std::string subject = file.string();
    const json root = json::parse(readTextFile(file), nullptr, false);
    if (root.is_discarded() || !root.is_object())
        throw Error(subject, "this is no JSON object (damaged, truncated or another kind of file)",
                    "choose a world file as `fodscope-cli simulate` writes it");
    const auto schema = root.find("schema");
    if (schema == root.end() || !schema->is_string() || schema->get_ref<const std::string&>() != kSchema)
        throw Error(subject, std::string("this is no world file of schema ") + kSchema,
                    "choose a world file as `fodscope-cli simulate` writes it");
    World world;
    const auto name = root.find("name");
    world.name = name != root.end() && name->is_string() ? name->get<std::string>() : file.stem().string();
    world.T_map_from_world = transform(member(root, "T_map_from_world", subject), subject);
    world.robotStart_world = startPose(member(root, "robot_start", subject), subject);
    const json& objects = member(root, "objects", subject);
    if (!objects.is_array()) throw Error(subject, "\"objects\" is not a list", kRemedy);
    if (objects.size() > kMostObjects)
        throw Error(subject, "\"objects\" holds more than " + std::to_string(kMostObjects) + " entries",
                    "split the world");
    world.structure = meshBeside(file, text(root, "structure", subject));
    for (const json& entry : objects)
        world.objects.push_back(object(entry, file, subject));
    return world;
}

void writeWorld(const std::filesystem::path& file, const World& world) {
    const std::string folderName = file.stem().string();
    const std::filesystem::path folder = file.parent_path() / folderName;
    makeFolder(folder);
    json root;
    root["schema"] = kSchema;
    root["name"] = world.name;
    root["frame"] = "cad";
    root["structure"] = folderName + "/structure.ply";
    writeMesh(folder / "structure.ply", world.structure);
    root["objects"] = json::array();
    for (std::size_t i = 0; i < world.objects.size(); ++i) {
        const WorldObject& entry = world.objects[i];
        const std::string meshName = fileNameOf(i, entry.type);
        writeMesh(folder / meshName, entry.mesh);
        const Eigen::Vector3d& c = entry.centroid_world;
        root["objects"].push_back({{"type", entry.type},
                                   {"fod", entry.fod},
                                   {"mesh", folderName + "/" + meshName},
                                   {"centroid", {c.x(), c.y(), c.z()}}});
    }
    const Eigen::Matrix4d& matrix = world.T_map_from_world.matrix();
    for (int row = 0; row < 4; ++row)
        root["T_map_from_world"].push_back({matrix(row, 0), matrix(row, 1), matrix(row, 2), matrix(row, 3)});
    root["robot_start"] = {{"x", world.robotStart_world.x_m},
                           {"y", world.robotStart_world.y_m},
                           {"yaw_deg", degreesFromRadians(world.robotStart_world.yaw_rad)}};
    // Last, so that a world file never names a mesh that is not there yet.
    writeFile(file, root.dump(1, ' ', false, json::error_handler_t::replace) + "\n");
}

}  // namespace fodscope
