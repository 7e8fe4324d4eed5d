// SPDX-License-Identifier: MIT
#include "core/cloud/PointCloudIo.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/cloud/ByteWindow.h"
#include "core/cloud/Pcd.h"
#include "core/cloud/Ply.h"
#include "core/cloud/PlyCloud.h"
#include "core/common/Error.h"
#include "core/common/Files.h"

namespace fodscope {
namespace {

PointCloud readCloud(ByteWindow& window, const std::string& subject) {
    if (window.remaining() == 0) throw Error(subject, "is empty", "copy or export the file anew");
    const std::span<const std::byte> start = window.ahead(1 << 16);
    if (isPly(start)) return readPlyCloud(window, subject);
    if (isPcd(start)) return readPcd(window, subject);
    throw Error(subject, "is no point cloud (neither PCD nor PLY)", "give a point cloud in one of these formats");
}

}  // namespace

PointCloud readPointCloud(const std::filesystem::path& file, Progress& progress, const std::string& stage) {
    ByteWindow window(InputFile(file), [&](double fraction) { progress.report(stage, fraction); });
    PointCloud cloud = readCloud(window, file.string());
    if (cloud.empty()) {
        throw Error(file.string(),
                    cloud.droppedNonFinite == 0 ? "holds no points"
                                                : "holds no point with finite coordinates (all are NaN or infinite)",
                    "export the cloud anew");
    }
    return cloud;
}

PointCloud readPointCloud(const std::filesystem::path& file) {
    Progress progress;
    return readPointCloud(file, progress);
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
