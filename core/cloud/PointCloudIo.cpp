// SPDX-License-Identifier: MIT
#include "core/cloud/PointCloudIo.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/cloud/Pcd.h"
#include "core/cloud/Ply.h"
#include "core/cloud/PlyCloud.h"
#include "core/common/Error.h"
#include "core/common/Files.h"

namespace fodscope {
namespace {

PointCloud parseCloud(std::span<const std::byte> bytes, const std::string& subject) {
    if (bytes.empty()) throw Error(subject, "is empty", "copy or export the file anew");
    if (isPly(bytes)) return cloudFromPly(parsePly(bytes, subject, PlyFaces::Ignore), subject);
    if (isPcd(bytes)) return parsePcd(bytes, subject);
    throw Error(subject, "is no point cloud (neither PCD nor PLY)", "give a point cloud in one of these formats");
}

}  // namespace

PointCloud readPointCloud(const std::filesystem::path& file) {
    const std::vector<std::byte> bytes = readFile(file);
    PointCloud cloud = parseCloud(bytes, file.string());
    if (cloud.empty()) {
        throw Error(file.string(),
                    cloud.droppedNonFinite == 0 ? "holds no points"
                                                : "holds no point with finite coordinates (all are NaN or infinite)",
                    "export the cloud anew");
    }
    return cloud;
}

void writePointCloud(const std::filesystem::path& file, const PointCloud& cloud, PcdEncoding encoding) {
    const std::string extension = file.extension().string();
    if (extension == ".pcd") {
        writeFile(file, pcdBytes(cloud, encoding));
    } else if (extension == ".ply") {
        writePly(file, {}, plyColumns(cloud.points, cloud.colours));
    } else {
        throw Error(file.string(), "\"" + extension + "\" is no extension of a point cloud",
                    "end the name in .pcd or .ply");
    }
}

}  // namespace fodscope
