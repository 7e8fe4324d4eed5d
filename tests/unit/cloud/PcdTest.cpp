// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <bit>
#include <string>

#include "core/cloud/PointCloudIo.h"
#include "core/cloud/ScalarType.h"
#include "core/common/Files.h"
#include "tests/unit/cloud/ExpectError.h"
#include "tests/unit/cloud/RandomPoints.h"
#include "tests/unit/cloud/TemporaryFolder.h"

namespace fodscope {
namespace {

std::string header(const std::string& fields, const std::string& sizes, const std::string& types,
                   const std::string& points, const std::string& data) {
    return "# .PCD v0.7\nVERSION 0.7\nFIELDS " + fields + "\nSIZE " + sizes + "\nTYPE " + types + "\nWIDTH " + points +
           "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + points + "\nDATA " + data + "\n";
}

std::string xyz(const std::string& points, const std::string& data) {
    return header("x y z", "4 4 4", "F F F", points, data);
}

TEST(Pcd, IsReadBackFromEveryEncoding) {
    const TemporaryFolder folder;
    PointCloud cloud;
    for (const Eigen::Vector3d& point : randomPoints(1000, 41)) {
        cloud.points.push_back(point.cast<float>().cast<double>());
        cloud.colours.push_back({static_cast<std::uint8_t>(cloud.size()), 7, 255});
    }
    for (const bool coloured : {true, false}) {
        if (!coloured) cloud.colours.clear();
        for (const PcdEncoding encoding : {PcdEncoding::Ascii, PcdEncoding::Binary, PcdEncoding::BinaryCompressed}) {
            writePointCloud(folder / "a.pcd", cloud, encoding);
            const PointCloud again = readPointCloud(folder / "a.pcd");
            EXPECT_EQ(again.points, cloud.points);
            EXPECT_EQ(again.colours, cloud.colours);
            EXPECT_EQ(again.droppedNonFinite, 0u);
        }
    }
}

TEST(Pcd, DropsAndCountsPointsThatAreNotFinite) {
    const TemporaryFolder folder;
    const auto file = folder.write("a.pcd", xyz("4", "ascii") + "1 2 3\nnan nan nan\n4 5 inf\n-1e-3 +2.5E0 0\n");
    const PointCloud cloud = readPointCloud(file);
    EXPECT_EQ(cloud.points, (std::vector<Eigen::Vector3d>{{1.0, 2.0, 3.0}, {static_cast<double>(-1e-3f), 2.5, 0.0}}));
    EXPECT_EQ(cloud.droppedNonFinite, 2u);
}

TEST(Pcd, TakesFieldsInAnyOrderTypeAndCount) {
    const TemporaryFolder folder;
    std::string bytes =
        "VERSION .7\r\nFIELDS z _ y rgba x\r\nSIZE 8 1 2 4 4\r\nTYPE F U I U F\r\nCOUNT 1 3 1 1 1\r\nWIDTH 2\r\n"
        "HEIGHT 1\r\nPOINTS 2\r\nDATA binary\r\n";
    for (int i = 1; i <= 2; ++i) {
        appendNumber(bytes, 0.25 * i);
        bytes += "pad";
        appendNumber(bytes, static_cast<std::int16_t>(-5 * i));
        appendNumber(bytes, std::uint32_t{0xff010203});
        appendNumber(bytes, 1.5f * static_cast<float>(i));
    }
    const PointCloud cloud = readPointCloud(folder.write("a.pcd", bytes));
    EXPECT_EQ(cloud.points, (std::vector<Eigen::Vector3d>{{1.5, -5.0, 0.25}, {3.0, -10.0, 0.5}}));
    EXPECT_EQ(cloud.colours, (std::vector<Rgb>(2, {1, 2, 3})));
}

TEST(Pcd, ReadsAsciiColoursAsFloatsAndAsWholeNumbers) {
    const TemporaryFolder folder;
    const auto asFloat =
        folder.write("f.pcd", header("x y z rgb", "4 4 4 4", "F F F F", "1", "ascii") + "1 2 3 4.2108e+06\n");
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(4.2108e+06f);
    EXPECT_EQ(readPointCloud(asFloat).colours.front().red, static_cast<std::uint8_t>(bits >> 16));
    const auto asNumber =
        folder.write("u.pcd", header("x y z rgb", "4 4 4 4", "F F F U", "1", "ascii") + "1 2 3 66051\n");
    EXPECT_EQ(readPointCloud(asNumber).colours.front(), (Rgb{1, 2, 3}));
}

TEST(Pcd, ReadsVersion5WithoutCountAndPoints) {
    const TemporaryFolder folder;
    const auto file = folder.write("a.pcd",
                                   "# comment\nVERSION .5\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\n"
                                   "DATA ascii\n0.5 1 2\n3 4 5");
    EXPECT_EQ(readPointCloud(file).size(), 2u);
}

TEST(Pcd, TellsWhatIsWrongWithAFile) {
    const TemporaryFolder folder;
    const auto expect = [&](const std::string& bytes, const std::string& words) {
        const auto file = folder.write("bad.pcd", bytes);
        expectError([&] { readPointCloud(file); }, words);
        expectError([&] { readPointCloud(file); }, "bad.pcd");
    };
    expectError([&] { readPointCloud(folder / "missing.pcd"); }, "no such file");
    expectError([&] { readPointCloud(folder / ""); }, "is a folder");
    expect("", "is empty");
    expect("hello\nworld\n", "is no point cloud");
    expect(std::string(500, '\0'), "is no point cloud");
    expect("VERSION 0.7\nFIELDS x y z\n", "is truncated");
    expect("VERSION 0.7\nFIELDS x y z\nNONSENSE 3\n", "malformed");
    expect(header("x y z", "4 4 3", "F F F", "1", "ascii") + "1 2 3\n", "malformed");
    expect(header("x y z", "4 4", "F F F", "1", "ascii") + "1 2 3\n", "malformed");
    expect(header("x y z", "4 4 4", "F F Q", "1", "ascii") + "1 2 3\n", "malformed");
    expect(xyz("many", "ascii"), "malformed");
    expect(xyz("-1", "ascii"), "malformed");
    expect(xyz("1", "zip"), "malformed");
    expect("VERSION 0.7\nFIELDS x y z\nWIDTH 2\nHEIGHT 2\nPOINTS 3\nDATA ascii\n1 2 3\n", "malformed");
    expect("VERSION 0.7\nFIELDS x y z\nDATA ascii\n1 2 3\n", "malformed");
    expect(header("x y w", "4 4 4", "F F F", "1", "ascii") + "1 2 3\n", "has no fields x, y and z");
    expect(xyz("1", "ascii") + "1 two 3\n", "is not a number");
    expect(xyz("2", "ascii") + "1 2 3\n4 5\n", "is truncated");
    expect(xyz("2", "ascii") + "1.000000 2.000000 3.0000000\n", "is truncated");
    expect(xyz("0", "ascii"), "holds no points");
    expect(xyz("2", "ascii") + "nan nan nan\nnan 1 2\n", "no point with finite coordinates");
    expect(xyz("2", "binary") + std::string(23, 'a'), "is truncated");
    expect(xyz("2", "binary_compressed") + "abc", "is truncated");
}

TEST(Pcd, DoesNotAllocateForWhatAHostileHeaderClaims) {
    const TemporaryFolder folder;
    for (const char* points : {"4294967295", "99999999999999999999", "18446744073709551615", "1000000000"}) {
        for (const char* data : {"ascii", "binary", "binary_compressed"}) {
            const auto file = folder.write("bad.pcd", xyz(points, data) + std::string(64, '\x7f'));
            EXPECT_THROW(readPointCloud(file), Error) << points << ' ' << data;
        }
    }
    const auto wide = folder.write("wide.pcd",
                                   "VERSION 0.7\nFIELDS x y z f\nSIZE 4 4 4 8\nTYPE F F F F\n"
                                   "COUNT 1 1 1 99999999999\nWIDTH 9\nHEIGHT 1\nDATA binary\nabc");
    EXPECT_THROW(readPointCloud(wide), Error);
    // Compressed sizes that agree with the header but that no stream of this length can fill.
    std::string bytes = xyz("100000000", "binary_compressed");
    appendNumber(bytes, std::uint32_t{4});
    appendNumber(bytes, std::uint32_t{1200000000});
    expectError([&] { readPointCloud(folder.write("bomb.pcd", bytes + "abcd")); }, "does not agree");
    bytes = xyz("2", "binary_compressed");
    appendNumber(bytes, std::uint32_t{4});
    appendNumber(bytes, std::uint32_t{24});
    expectError([&] { readPointCloud(folder.write("damaged.pcd", bytes + "\xff\xff\xff\xff")); }, "is damaged");
}

TEST(Pcd, TruncatedAnywhereIsAnErrorNeverACrash) {
    const TemporaryFolder folder;
    PointCloud cloud;
    cloud.points = randomPoints(20, 42);
    for (const PcdEncoding encoding : {PcdEncoding::Ascii, PcdEncoding::Binary, PcdEncoding::BinaryCompressed}) {
        writePointCloud(folder / "whole.pcd", cloud, encoding);
        const std::string whole = readTextFile(folder / "whole.pcd");
        // The last digits of an ascii file may be missing unnoticed, hence the margin.
        for (std::size_t size = 0; size + 12 < whole.size(); size += 7) {
            const auto file = folder.write("part.pcd", whole.substr(0, size));
            EXPECT_THROW(readPointCloud(file), Error) << size;
        }
    }
}

TEST(WritePointCloud, RefusesOtherExtensionsAndPlacesThatDoNotExist) {
    const TemporaryFolder folder;
    PointCloud cloud;
    cloud.points = randomPoints(3, 43);
    expectError([&] { writePointCloud(folder / "a.xyz", cloud); }, "no extension of a point cloud");
    expectError([&] { writePointCloud(folder / "missing/a.pcd", cloud); }, "cannot be written");
}

}  // namespace
}  // namespace fodscope
