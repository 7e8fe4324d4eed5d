// SPDX-License-Identifier: MIT
#include "storage/CloudBlobs.h"

#include <stdexcept>

#include "storage/ByteStream.h"

namespace fodscope {
namespace {

constexpr const char* kReferenceMagic = "FODSREF1";
constexpr const char* kFieldMagic = "FODSFLD1";
constexpr const char* kVoxelsMagic = "FODSVOX1";
constexpr const char* kCoverageMagic = "FODSCOV1";
constexpr const char* kGridMagic = "FODSGRD1";

std::vector<double> flat(const std::vector<Eigen::Vector3d>& points) {
    std::vector<double> numbers;
    numbers.reserve(points.size() * 3);
    for (const Eigen::Vector3d& point : points) {
        numbers.insert(numbers.end(), point.data(), point.data() + 3);
    }
    return numbers;
}

std::vector<Eigen::Vector3d> readPoints(ByteReader& reader, std::uint64_t count) {
    if (count > std::uint64_t{1} << 40) reader.fail();
    const std::vector<double> numbers = reader.array<double>(count * 3);
    std::vector<Eigen::Vector3d> points;
    points.reserve(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < numbers.size(); i += 3) {
        points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    }
    return points;
}

std::vector<double> flat(const std::vector<Eigen::Matrix3d>& matrices) {
    std::vector<double> numbers;
    numbers.reserve(matrices.size() * 6);
    for (const Eigen::Matrix3d& m : matrices) {
        numbers.insert(numbers.end(), {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)});
    }
    return numbers;
}

std::vector<Eigen::Matrix3d> symmetricMatrices(const std::vector<double>& numbers) {
    std::vector<Eigen::Matrix3d> matrices;
    matrices.reserve(numbers.size() / 6);
    for (std::size_t i = 0; i < numbers.size(); i += 6) {
        Eigen::Matrix3d m;
        m << numbers[i], numbers[i + 1], numbers[i + 2],     //
            numbers[i + 1], numbers[i + 3], numbers[i + 4],  //
            numbers[i + 2], numbers[i + 4], numbers[i + 5];
        matrices.push_back(m);
    }
    return matrices;
}

/// Sets the bit when the array is there.
std::uint32_t presence(std::size_t size, std::size_t expected, unsigned bit) {
    if (size == 0) return 0;
    if (size != expected) throw std::logic_error("a cloud's arrays differ in length");
    return 1u << bit;
}

bool has(std::uint32_t present, unsigned bit) {
    return (present >> bit & 1u) != 0;
}

template <typename Number>
std::vector<Number> readIf(ByteReader& reader, std::uint32_t present, unsigned bit, std::uint64_t count) {
    return has(present, bit) ? reader.array<Number>(count) : std::vector<Number>();
}

template <typename Number>
void write(ByteWriter& writer, const std::vector<Number>& values) {
    writer.array(std::span<const Number>(values));
}

}  // namespace

Blob encodeReference(const ReferenceMap& reference) {
    const std::size_t n = reference.size();
    ByteWriter writer(kReferenceMagic);
    writer.number<std::uint64_t>(n);
    writer.number<std::uint32_t>(
        presence(reference.occupancy.size(), n, 0) | presence(reference.sampleCount.size(), n, 1) |
        presence(reference.covariance.size(), n, 2) | presence(reference.untrained.size(), n, 3));
    write(writer, flat(reference.points));
    write(writer, reference.occupancy);
    write(writer, reference.sampleCount);
    write(writer, flat(reference.covariance));
    write(writer, reference.untrained);
    return {"fodscope.reference/1", writer.take()};
}

ReferenceMap decodeReference(std::span<const std::byte> bytes, const std::string& subject) {
    ByteReader reader(bytes, kReferenceMagic, subject);
    const auto n = reader.number<std::uint64_t>();
    const auto present = reader.number<std::uint32_t>();
    ReferenceMap reference;
    reference.points = readPoints(reader, n);
    reference.occupancy = readIf<std::int32_t>(reader, present, 0, n);
    reference.sampleCount = readIf<std::int32_t>(reader, present, 1, n);
    reference.covariance = symmetricMatrices(readIf<double>(reader, present, 2, n * 6));
    reference.untrained = readIf<std::uint8_t>(reader, present, 3, n);
    reader.expectEnd();
    return reference;
}

Blob encodeField(const DiscrepancyField& field) {
    const std::size_t n = field.size();
    ByteWriter writer(kFieldMagic);
    writer.number<std::uint64_t>(n);
    writer.number<std::uint32_t>(presence(field.weights.size(), n, 0) | presence(field.nearest.size(), n, 1) |
                                 presence(field.euclidean_m.size(), n, 2) | presence(field.mahalanobis.size(), n, 3) |
                                 presence(field.smoothedEuclidean_m.size(), n, 4) |
                                 presence(field.smoothedMahalanobis.size(), n, 5) |
                                 presence(field.chiSquare.size(), n, 6));
    write(writer, flat(field.points));
    write(writer, field.weights);
    write(writer, field.nearest);
    write(writer, field.euclidean_m);
    write(writer, field.mahalanobis);
    write(writer, field.smoothedEuclidean_m);
    write(writer, field.smoothedMahalanobis);
    write(writer, field.chiSquare);
    return {"fodscope.field/1", writer.take()};
}

DiscrepancyField decodeField(std::span<const std::byte> bytes, const std::string& subject) {
    ByteReader reader(bytes, kFieldMagic, subject);
    const auto n = reader.number<std::uint64_t>();
    const auto present = reader.number<std::uint32_t>();
    DiscrepancyField field;
    field.points = readPoints(reader, n);
    field.weights = readIf<std::uint32_t>(reader, present, 0, n);
    field.nearest = readIf<std::uint32_t>(reader, present, 1, n);
    field.euclidean_m = readIf<double>(reader, present, 2, n);
    field.mahalanobis = readIf<double>(reader, present, 3, n);
    field.smoothedEuclidean_m = readIf<double>(reader, present, 4, n);
    field.smoothedMahalanobis = readIf<double>(reader, present, 5, n);
    field.chiSquare = readIf<double>(reader, present, 6, n);
    reader.expectEnd();
    return field;
}

Blob encodeVoxels(const CandidateSet& candidates) {
    ByteWriter writer(kVoxelsMagic);
    writer.number<std::uint64_t>(candidates.candidates.size());
    for (const Candidate& candidate : candidates.candidates) {
        writer.number<std::uint64_t>(candidate.voxels.size());
        write(writer, candidate.voxels);
    }
    return {"fodscope.voxels/1", writer.take()};
}

std::vector<std::vector<std::uint32_t>> decodeVoxels(std::span<const std::byte> bytes, const std::string& subject) {
    ByteReader reader(bytes, kVoxelsMagic, subject);
    const auto n = reader.number<std::uint64_t>();
    std::vector<std::vector<std::uint32_t>> lists;
    for (std::uint64_t i = 0; i < n; ++i) {
        const auto count = reader.number<std::uint64_t>();
        lists.push_back(reader.array<std::uint32_t>(count));
    }
    reader.expectEnd();
    return lists;
}

Blob encodeCoverage(const Coverage& coverage) {
    ByteWriter writer(kCoverageMagic);
    writer.number<std::uint64_t>(coverage.observed.size());
    write(writer, coverage.observed);
    return {"fodscope.coverage/1", writer.take()};
}

std::vector<std::uint8_t> decodeCoverage(std::span<const std::byte> bytes, const std::string& subject) {
    ByteReader reader(bytes, kCoverageMagic, subject);
    std::vector<std::uint8_t> observed = reader.array<std::uint8_t>(reader.number<std::uint64_t>());
    reader.expectEnd();
    return observed;
}

Blob encodeGrid(const OccupancyGrid& grid) {
    ByteWriter writer(kGridMagic);
    writer.number<std::uint64_t>(grid.cells.size());
    write(writer, grid.cells);
    return {"fodscope.grid/1", writer.take()};
}

std::vector<Cell> decodeGrid(std::span<const std::byte> bytes, const std::string& subject) {
    ByteReader reader(bytes, kGridMagic, subject);
    const std::vector<std::uint8_t> numbers = reader.array<std::uint8_t>(reader.number<std::uint64_t>());
    reader.expectEnd();
    std::vector<Cell> cells;
    cells.reserve(numbers.size());
    for (const std::uint8_t number : numbers) {
        if (number > static_cast<std::uint8_t>(Cell::Unknown)) reader.fail();
        cells.push_back(static_cast<Cell>(number));
    }
    return cells;
}

}  // namespace fodscope
