// SPDX-License-Identifier: MIT
#include "core/inspection/DiscrepantPoints.h"

#include <string>
#include <utility>

#include "core/cloud/Ply.h"
#include "core/cloud/PlyCloud.h"
#include "core/common/Error.h"
#include "core/common/Files.h"

namespace fodscope {

std::vector<DiscrepantVoxel> readDiscrepantVoxels(const std::filesystem::path& file, double threshold) {
    const std::vector<std::byte> bytes = readFile(file);
    const PlyContents contents = parsePly(bytes, file.string(), PlyFaces::Ignore);
    const PlyColumn* discrepancy = contents.column("discrepancy");
    const PlyColumn* candidate = contents.column("candidate");
    for (const auto& [column, name] : {std::pair(discrepancy, "discrepancy"), std::pair(candidate, "candidate")}) {
        if (column == nullptr)
            throw Error(file.string(), std::string("has no property '") + name + "'",
                        "give the file that detect wrote");
    }
    const std::vector<Eigen::Vector3d> points = plyPoints(contents, file.string());
    std::vector<DiscrepantVoxel> discrepant;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (discrepancy->values[i] > threshold && points[i].allFinite())
            discrepant.push_back({points[i], static_cast<int>(candidate->values[i])});
    }
    return discrepant;
}

}  // namespace fodscope
