// SPDX-License-Identifier: MIT
#include "app/cli/Inputs.h"

#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

#include "app/cli/Context.h"
#include "core/cloud/PointCloudIo.h"
#include "core/cloud/UnitCheck.h"
#include "core/common/Error.h"
#include "core/common/Files.h"
#include "core/common/Hash.h"
#include "core/reference/ReferenceMapIo.h"

namespace fodscope::cli {
namespace {

constexpr const char* kTransformRemedy = "give 4 rows of 4 numbers, reference from map";

SourceFile sourceOf(const std::filesystem::path& file, std::size_t points) {
    return {std::filesystem::absolute(file).string(), sha256OfFile(file), points};
}

std::vector<std::string> linesOf(const std::filesystem::path& file) {
    std::vector<std::string> lines;
    std::istringstream stream(readTextFile(file));
    for (std::string line; std::getline(stream, line);) {
        if (line.ends_with('\r')) line.pop_back();
        lines.push_back(line);
    }
    return lines;
}

bool isBlank(const std::string& line) {
    return line.find_first_not_of(" \t,") == std::string::npos;
}

}  // namespace

LoadedMap loadMap(const std::filesystem::path& file, Context& context) {
    auto cloud = std::make_shared<PointCloud>(readPointCloud(file, context.progress, "reading the map"));
    requireUsableCloud(cloud->points, file.string());
    if (cloud->droppedNonFinite > 0) {
        context.remarks << "note: " << file.string() << ": " << cloud->droppedNonFinite
                        << " points without finite coordinates were left out\n";
    }
    const SourceFile source = sourceOf(file, cloud->size());
    return {source, std::move(cloud)};
}

LoadedReferenceMap loadReference(const std::filesystem::path& file) {
    auto reference = std::make_shared<ReferenceMap>(readReferenceMap(file));
    requireUsableCloud(reference->points, file.string());
    const SourceFile source = sourceOf(file, reference->size());
    return {source, std::move(reference)};
}

std::vector<double> numbersIn(const std::string& line, const std::string& subject, std::size_t lineNumber) {
    std::vector<double> numbers;
    std::size_t at = 0;
    while ((at = line.find_first_not_of(" \t,;", at)) != std::string::npos) {
        const std::size_t end = std::min(line.find_first_of(" \t,;", at), line.size());
        const char* first = line.data() + at + (line[at] == '+' ? 1 : 0);
        double number = 0.0;
        const auto read = std::from_chars(first, line.data() + end, number);
        if (read.ec != std::errc() || read.ptr != line.data() + end) {
            throw Error(
                subject,
                "line " + std::to_string(lineNumber) + " holds '" + line.substr(at, end - at) + "', which is no number",
                "give numbers divided by commas");
        }
        numbers.push_back(number);
        at = end;
    }
    return numbers;
}

Transform readTransform(const std::filesystem::path& file) {
    std::vector<double> numbers;
    const std::vector<std::string> lines = linesOf(file);
    int rows = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (isBlank(lines[i])) continue;
        const std::vector<double> row = numbersIn(lines[i], file.string(), i + 1);
        ++rows;
        if (row.size() != 4) {
            throw Error(file.string(),
                        "line " + std::to_string(i + 1) + " holds " + std::to_string(row.size()) + " numbers, not 4",
                        kTransformRemedy);
        }
        numbers.insert(numbers.end(), row.begin(), row.end());
    }
    if (rows != 4) throw Error(file.string(), "holds " + std::to_string(rows) + " rows, not 4", kTransformRemedy);
    std::array<double, 16> matrix{};
    std::copy(numbers.begin(), numbers.end(), matrix.begin());
    return transformFromRows(matrix, file.string());
}

std::vector<Transform> readTransforms(const std::filesystem::path& file) {
    constexpr const char* kHeader = "m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m23,m30,m31,m32,m33";
    constexpr const char* kRemedy = "give the header m00,m01,...,m33 and a row of 16 numbers for each map";
    const std::vector<std::string> lines = linesOf(file);
    std::string header;
    for (const char c : lines.empty() ? std::string() : lines.front()) {
        if (c != ' ' && c != '\t' && c != '"') header += c;
    }
    if (header != kHeader) throw Error(file.string(), "does not begin with the header m00,m01,...,m33", kRemedy);
    std::vector<Transform> transforms;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (isBlank(lines[i])) continue;
        const std::vector<double> row = numbersIn(lines[i], file.string(), i + 1);
        if (row.size() != 16) {
            throw Error(file.string(),
                        "line " + std::to_string(i + 1) + " holds " + std::to_string(row.size()) + " numbers, not 16",
                        kRemedy);
        }
        std::array<double, 16> matrix{};
        std::copy(row.begin(), row.end(), matrix.begin());
        transforms.push_back(transformFromRows(matrix, file.string() + " line " + std::to_string(i + 1)));
    }
    if (transforms.empty()) throw Error(file.string(), "holds no transforms", kRemedy);
    return transforms;
}

Pose2 parsePose(const std::string& text) {
    std::vector<double> numbers;
    try {
        numbers = numbersIn(text, "--robot", 1);
    } catch (const Error&) {
        numbers.clear();
    }
    bool finite = numbers.size() == 3;
    for (const double number : numbers)
        finite = finite && std::isfinite(number);
    if (!finite) throw UsageError("--robot: '" + text + "' is not X,Y,YAW_DEG");
    return {numbers[0], numbers[1], wrapAngle(radiansFromDegrees(numbers[2]))};
}

}  // namespace fodscope::cli
