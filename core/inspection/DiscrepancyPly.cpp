// SPDX-License-Identifier: MIT
#include "core/inspection/DiscrepancyPly.h"

#include <charconv>
#include <limits>

#include "core/cloud/Ply.h"
#include "core/cloud/PlyCloud.h"
#include "core/common/Error.h"
#include "core/common/Files.h"

namespace fodscope {
namespace {

double numberOf(const std::string& candidateId) {
    int number = -1;
    const auto digits = candidateId.find_first_of("0123456789");
    if (digits != std::string::npos) {
        std::from_chars(candidateId.data() + digits, candidateId.data() + candidateId.size(), number);
    }
    return number;
}

PlyColumn column(const char* name, ScalarType type, std::vector<double> values) {
    return {name, type, std::move(values)};
}

std::vector<double> candidateNumbers(const CandidateSet& set, std::size_t voxels) {
    std::vector<double> numbers(voxels, -1.0);
    for (const Candidate& candidate : set.candidates) {
        for (const std::uint32_t voxel : candidate.voxels)
            numbers[voxel] = numberOf(candidate.id);
    }
    return numbers;
}

}  // namespace

void writeDiscrepancyPly(const std::filesystem::path& file, const DetectionRecord& detection) {
    if (!detection.field || !detection.candidates) {
        throw Error(file.string(), "there is no discrepancy to write: the map is not aligned", "align the map first");
    }
    const DiscrepancyField& field = *detection.field;
    const bool isMahalanobis = detection.parameters.candidates.metric == Metric::Mahalanobis;
    std::vector<double> mahalanobis = field.mahalanobis;
    if (mahalanobis.empty()) mahalanobis.assign(field.size(), std::numeric_limits<double>::quiet_NaN());

    std::vector<PlyColumn> columns = plyColumns(field.points);
    columns.push_back(column("weight", ScalarType::Int32, {field.weights.begin(), field.weights.end()}));
    columns.push_back(column("euclidean", ScalarType::Float32, field.euclidean_m));
    columns.push_back(column("mahalanobis", ScalarType::Float32, std::move(mahalanobis)));
    columns.push_back(
        column("discrepancy", ScalarType::Float32, field.smoothed(detection.parameters.candidates.metric)));
    columns.push_back(column("candidate", ScalarType::Int32, candidateNumbers(*detection.candidates, field.size())));
    const std::vector<std::string> comments{
        "Fodscope discrepancy of a map, reference frame, metres",
        std::string("discrepancy is the smoothed ") + (isMahalanobis ? "mahalanobis" : "euclidean")};
    writePly(file, comments, columns);
}

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
