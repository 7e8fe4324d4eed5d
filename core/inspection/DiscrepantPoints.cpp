// SPDX-License-Identifier: MIT
#include "core/inspection/DiscrepantPoints.h"

#include "core/cloud/Ply.h"
#include "core/cloud/PlyCloud.h"
#include "core/common/Error.h"
#include "core/common/Files.h"

namespace fodscope {

std::vector<Eigen::Vector3d> readDiscrepantPoints_reference(const std::filesystem::path& file, double threshold) {
    const std::vector<std::byte> bytes = readFile(file);
    const PlyContents contents = parsePly(bytes, file.string(), PlyFaces::Ignore);
    const PlyColumn* discrepancy = contents.column("discrepancy");
    if (discrepancy == nullptr) {
        throw Error(file.string(), "has no property 'discrepancy'", "give the file that detect wrote");
    }
    const std::vector<Eigen::Vector3d> points = plyPoints(contents, file.string());
    std::vector<Eigen::Vector3d> discrepant;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (discrepancy->values[i] > threshold && points[i].allFinite()) discrepant.push_back(points[i]);
    }
    return discrepant;
}

}  // namespace fodscope
