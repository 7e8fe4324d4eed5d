// SPDX-License-Identifier: MIT
#include "core/detection/DiscrepancyPly.h"

#include <charconv>
#include <string>
#include <vector>

#include "core/cloud/Ply.h"
#include "core/cloud/PlyCloud.h"

namespace fodscope {
namespace {

PlyColumn candidateColumn(const DiscrepancyField& field, const CandidateSet& candidates) {
    PlyColumn column{"candidate", ScalarType::Int32, std::vector<double>(field.size(), -1.0)};
    for (const Candidate& candidate : candidates.candidates) {
        for (const std::uint32_t voxel : candidate.voxels)
            column.values[voxel] = candidateNumber(candidate.id);
    }
    return column;
}

std::string meaningOf(Metric metric) {
    switch (metric) {
        case Metric::Euclidean:
            return "smoothed euclidean, metres";
        case Metric::Mahalanobis:
            return "smoothed mahalanobis, unitless";
        case Metric::ChiSquare:
            return "chi_square, unitless";
    }
    return {};
}

}  // namespace

void writeDiscrepancyPly(const std::filesystem::path& file, const DiscrepancyField& field,
                         const CandidateSet& candidates, Metric metric) {
    std::vector<PlyColumn> columns = plyColumns(field.points);
    columns.push_back({"weight", ScalarType::Int32, {field.weights.begin(), field.weights.end()}});
    columns.push_back({"euclidean", ScalarType::Float32, field.euclidean_m});
    if (field.hasMahalanobis()) columns.push_back({"mahalanobis", ScalarType::Float32, field.mahalanobis});
    if (field.has(Metric::ChiSquare)) columns.push_back({"chi_square", ScalarType::Float32, field.chiSquare});
    columns.push_back({"discrepancy", ScalarType::Float32, field.smoothed(metric)});
    columns.push_back(candidateColumn(field, candidates));
    const std::vector<std::string> comments{"Fodscope discrepancy, reference frame, metres",
                                            "discrepancy is " + meaningOf(metric)};
    writePly(file, comments, columns);
}

int candidateNumber(const std::string& id) {
    const std::size_t first = id.find_first_of("0123456789");
    int number = -1;
    if (first != std::string::npos) std::from_chars(id.data() + first, id.data() + id.size(), number);
    return number;
}

}  // namespace fodscope
