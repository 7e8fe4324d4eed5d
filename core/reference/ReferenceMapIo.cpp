// SPDX-License-Identifier: MIT
#include "core/reference/ReferenceMapIo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/cloud/Ply.h"
#include "core/cloud/PlyCloud.h"
#include "core/cloud/PointCloudIo.h"
#include "core/common/Error.h"
#include "core/common/Files.h"
#include "core/reference/Covariance.h"

namespace fodscope {
namespace {

struct CovarianceEntry {
    const char* name;
    int row;
    int column;
};
constexpr std::array<CovarianceEntry, 6> kEntries{
    {{"cov_xx", 0, 0}, {"cov_xy", 0, 1}, {"cov_xz", 0, 2}, {"cov_yy", 1, 1}, {"cov_yz", 1, 2}, {"cov_zz", 2, 2}}};

template <class Values>
PlyColumn columnOf(const char* name, ScalarType type, const Values& values) {
    PlyColumn column{name, type, {}};
    column.values.assign(values.begin(), values.end());
    return column;
}

void appendCovariances(const ReferenceMap& reference, std::vector<PlyColumn>& columns) {
    PlyColumn untrained{"untrained", ScalarType::UInt8, {}};
    for (const Eigen::Matrix3d& covariance : reference.covariance)
        untrained.values.push_back(isInvertible(covariance) ? 0.0 : 1.0);
    columns.push_back(std::move(untrained));
    for (const CovarianceEntry& entry : kEntries) {
        PlyColumn column{entry.name, ScalarType::Float32, {}};
        for (const Eigen::Matrix3d& covariance : reference.covariance)
            column.values.push_back(covariance(entry.row, entry.column));
        columns.push_back(std::move(column));
    }
    PlyColumn logDet{"log_det", ScalarType::Float32, {}};
    for (const Eigen::Matrix3d& covariance : reference.covariance)
        logDet.values.push_back(logDeterminant(covariance));
    columns.push_back(std::move(logDet));
}

std::int32_t countIn(const PlyColumn& column, std::size_t i, const std::string& subject) {
    const double value = column.values[i];
    if (!(value >= 0.0 && value <= std::numeric_limits<std::int32_t>::max()) || value != std::floor(value)) {
        throw Error(subject, "the " + column.name + " of point " + std::to_string(i + 1) + " is no count",
                    "build the reference map anew");
    }
    return static_cast<std::int32_t>(value);
}

/// @return the column, or null; one that the file lacks while it has others of its kind is an error of the caller
std::array<const PlyColumn*, 6> covarianceColumns(const PlyContents& contents, const std::string& subject) {
    std::array<const PlyColumn*, 6> columns{};
    std::string missing;
    for (std::size_t i = 0; i < kEntries.size(); ++i) {
        columns[i] = contents.column(kEntries[i].name);
        if (columns[i] == nullptr) missing += std::string(missing.empty() ? "" : ", ") + kEntries[i].name;
    }
    const bool hasNone = std::all_of(columns.begin(), columns.end(), [](const auto* column) { return !column; });
    if (!hasNone && !missing.empty()) {
        throw Error(subject, "lacks a part of its covariances (" + missing + ")", "build the reference map anew");
    }
    return columns;
}

Eigen::Matrix3d covarianceAt(const std::array<const PlyColumn*, 6>& columns, std::size_t i) {
    Eigen::Matrix3d covariance;
    for (std::size_t entry = 0; entry < kEntries.size(); ++entry) {
        const auto [name, row, column] = kEntries[entry];
        covariance(row, column) = columns[entry]->values[i];
        covariance(column, row) = columns[entry]->values[i];
    }
    return covariance;
}

ReferenceMap referenceFromPly(const PlyContents& contents, const std::string& subject) {
    const std::vector<Eigen::Vector3d> points = plyPoints(contents, subject);
    const std::array<const PlyColumn*, 6> covariances = covarianceColumns(contents, subject);
    const PlyColumn* occupancy = contents.column("occupancy");
    const PlyColumn* sampleCount = contents.column("sample_count");
    const PlyColumn* untrained = contents.column("untrained");
    ReferenceMap reference;
    reference.provenance = contents.comments;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i].allFinite()) continue;
        reference.points.push_back(points[i]);
        if (occupancy != nullptr) reference.occupancy.push_back(countIn(*occupancy, i, subject));
        if (sampleCount != nullptr) reference.sampleCount.push_back(countIn(*sampleCount, i, subject));
        if (covariances[0] == nullptr) continue;
        const Eigen::Matrix3d covariance = covarianceAt(covariances, i);
        const bool isMarked = untrained != nullptr && untrained->values[i] != 0.0;
        const bool isTrained = !isMarked && isInvertible(covariance);
        reference.covariance.push_back(isTrained ? covariance : unknownCovariance());
        reference.untrained.push_back(isTrained ? 0 : 1);
    }
    return reference;
}

}  // namespace

void writeReferenceMap(const std::filesystem::path& file, const ReferenceMap& reference) {
    std::vector<PlyColumn> columns = plyColumns(reference.points);
    if (!reference.occupancy.empty()) columns.push_back(columnOf("occupancy", ScalarType::Int32, reference.occupancy));
    if (!reference.sampleCount.empty())
        columns.push_back(columnOf("sample_count", ScalarType::Int32, reference.sampleCount));
    if (reference.hasCovariance()) appendCovariances(reference, columns);
    writePly(file, reference.provenance, columns);
}

ReferenceMap readReferenceMap(const std::filesystem::path& file) {
    const std::vector<std::byte> bytes = readFile(file);
    if (!isPly(bytes)) {
        ReferenceMap reference;
        reference.points = readPointCloud(file).points;
        return reference;
    }
    ReferenceMap reference = referenceFromPly(parsePly(bytes, file.string(), PlyFaces::Ignore), file.string());
    if (reference.points.empty()) {
        throw Error(file.string(), "holds no point with finite coordinates", "build the reference map anew");
    }
    return reference;
}

}  // namespace fodscope
