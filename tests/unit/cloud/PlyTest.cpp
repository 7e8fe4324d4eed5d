// SPDX-License-Identifier: MIT
#include "core/cloud/Ply.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/cloud/PointCloudIo.h"
#include "core/common/Files.h"
#include "tests/unit/cloud/ExpectError.h"
#include "tests/unit/cloud/RandomPoints.h"
#include "tests/unit/cloud/TemporaryFolder.h"

namespace fodscope {
namespace {

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";

template <class Number>
void appendBigEndian(std::string& bytes, Number number) {
    std::string little;
    appendNumber(little, number);
    std::reverse(little.begin(), little.end());
    bytes += little;
}

TEST(Ply, CloudIsReadBack) {
    const TemporaryFolder folder;
    PointCloud cloud;
    for (const Eigen::Vector3d& point : randomPoints(200, 51)) {
        cloud.points.push_back(point.cast<float>().cast<double>());
        cloud.colours.push_back({9, static_cast<std::uint8_t>(cloud.size()), 200});
    }
    writePointCloud(folder / "a.ply", cloud);
    const PointCloud again = readPointCloud(folder / "a.ply");
    EXPECT_EQ(again.points, cloud.points);
    EXPECT_EQ(again.colours, cloud.colours);
}

TEST(Ply, ReadsAsciiWithListsOtherElementsAndWindowsLineEnds) {
    const TemporaryFolder folder;
    const auto file = folder.write("a.ply",
                                   "ply\r\nformat ascii 1.0\r\ncomment made by hand\r\nobj_info something\r\n"
                                   "element camera 1\r\nproperty list uchar int shots\r\nproperty double f\r\n"
                                   "element vertex 2\r\nproperty double z\r\nproperty list uchar float extra\r\n"
                                   "property int16 x\r\nproperty uchar y\r\nproperty float quality\r\n"
                                   "element face 1\r\nproperty list uchar int vertex_indices\r\nend_header\r\n"
                                   "3 1 2 3 0.5\r\n0.25 2 7 8 -1 2 nan\r\n0.5 0 3 4 1\r\n3 0 1 1\r\n");
    const PlyContents contents = parsePly(readFile(file), file.string(), PlyFaces::Read);
    EXPECT_EQ(contents.comments, std::vector<std::string>{"made by hand"});
    EXPECT_EQ(contents.vertexCount, 2u);
    EXPECT_TRUE(std::isnan(contents.column("quality")->values[0]));
    EXPECT_EQ(contents.column("extra"), nullptr);
    EXPECT_EQ(contents.faceIndices, (std::vector<std::int64_t>{0, 1, 1}));
    EXPECT_EQ(readPointCloud(file).points, (std::vector<Eigen::Vector3d>{{-1.0, 2.0, 0.25}, {3.0, 4.0, 0.5}}));
}

TEST(Ply, ReadsBigEndian) {
    const TemporaryFolder folder;
    std::string bytes = "ply\nformat binary_big_endian 1.0\nelement vertex 2\n" + kXyz +
                        "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";
    for (const float value : {1.5f, -2.5f}) {
        appendBigEndian(bytes, value);
        appendBigEndian(bytes, value * 2.0f);
        appendBigEndian(bytes, value * 4.0f);
        bytes += "\x01\x02\x03";
    }
    const PointCloud cloud = readPointCloud(folder.write("a.ply", bytes));
    EXPECT_EQ(cloud.points, (std::vector<Eigen::Vector3d>{{1.5, 3.0, 6.0}, {-2.5, -5.0, -10.0}}));
    EXPECT_EQ(cloud.colours, (std::vector<Rgb>(2, {1, 2, 3})));
}

TEST(Ply, CommentsStayOnOneLine) {
    const TemporaryFolder folder;
    const std::vector<std::string> comments{"two\nlines", "element vertex 99"};
    const std::vector<PlyColumn> columns{
        {"x", ScalarType::Float32, {1.0}}, {"y", ScalarType::Float32, {2.0}}, {"z", ScalarType::Float64, {0.1}}};
    writePly(folder / "a.ply", comments, columns);
    const PlyContents contents = parsePly(readFile(folder / "a.ply"), "a.ply", PlyFaces::Read);
    EXPECT_EQ(contents.comments, (std::vector<std::string>{"two lines", "element vertex 99"}));
    EXPECT_EQ(contents.vertexCount, 1u);
    EXPECT_EQ(contents.column("z")->values.front(), 0.1);
}

TEST(Ply, TellsWhatIsWrongWithAFile) {
    const TemporaryFolder folder;
    const auto expect = [&](const std::string& bytes, const std::string& words) {
        const auto file = folder.write("bad.ply", bytes);
        expectError([&] { readPointCloud(file); }, words);
        expectError([&] { readPointCloud(file); }, "bad.ply");
    };
    const std::string ascii = "ply\nformat ascii 1.0\n";
    expect("ply\n", "is truncated");
    expect(ascii + "element vertex 1\n" + kXyz, "is truncated");
    expect("ply\nelement vertex 1\n" + kXyz + "end_header\n1 2 3\n", "names no format");
    expect("ply\nformat ternary 1.0\nend_header\n", "unknown format");
    expect(ascii + "property float x\nend_header\n", "before any element");
    expect(ascii + "element vertex\nend_header\n", "without name or count");
    expect(ascii + "element vertex 1\nproperty complex x\nend_header\n", "unknown type");
    expect(ascii + "element vertex 1\nproperty float\nend_header\n", "without name");
    expect(ascii + "wings 2\nend_header\n", "unknown keyword");
    expect(ascii + "element vertex 1\nproperty float x\nproperty float y\nend_header\n1 2\n", "x, y and z");
    expect(ascii + "element face 1\nproperty list uchar int vertex_indices\nend_header\n3 0 1 2\n", "x, y and z");
    expect(ascii + "element vertex 1\n" + kXyz + "end_header\n1 2 z\n", "is not a number");
    expect(ascii + "element vertex 2\n" + kXyz + "end_header\n1.25 2.25 3.25\n4\n", "is truncated");
    expect(ascii + "element vertex 0\n" + kXyz + "end_header\n", "holds no points");
    expect(ascii + "element vertex 1\n" + kXyz + "end_header\nnan inf 3\n", "no point with finite coordinates");
    const std::string binary = "ply\nformat binary_little_endian 1.0\n";
    expect(binary + "element vertex 3\n" + kXyz + "end_header\n" + std::string(35, 'a'), "is truncated");
    expect(binary + "element a 1\nproperty list char int b\nelement vertex 1\n" + kXyz + "end_header\n" +
               std::string(50, '\xff'),
           "no proper length");
}

TEST(Ply, DoesNotAllocateForWhatAHostileHeaderClaims) {
    const TemporaryFolder folder;
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
        for (const char* count : {"4294967295", "18446744073709551615", "9999999999999999999999"}) {
            const std::string start = "ply\nformat " + std::string(format) + " 1.0\nelement vertex ";
            const auto vertices =
                folder.write("v.ply", start + count + "\n" + kXyz + "end_header\n" + std::string(60, '1'));
            EXPECT_THROW(readPointCloud(vertices), Error);
            const auto bare = folder.write("b.ply", start + count + "\nend_header\n1 2 3\n");
            EXPECT_THROW(readPointCloud(bare), Error);
            const auto lists = folder.write("l.ply", start + "1\nproperty list uint uint many\n" + kXyz +
                                                         "end_header\n4294967295 1 2 3\xff\xff\xff\xff");
            EXPECT_THROW(readPointCloud(lists), Error);
        }
    }
}

}  // namespace
}  // namespace fodscope
