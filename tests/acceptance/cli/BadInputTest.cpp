// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "core/cloud/PointCloudIo.h"
#include "core/common/Files.h"
#include "tests/acceptance/cli/RoomFiles.h"
#include "tests/unit/registration/SyntheticRoom.h"

namespace fodscope::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// One clear sentence, "error: FILE: what is wrong; what to do", and nothing left behind.
void expectRefused(const Outcome& outcome, const std::string& file, const std::string& about) {
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, StartsWith("error: " + file));
    EXPECT_THAT(outcome.err, HasSubstr("; "));
    EXPECT_THAT(outcome.err, HasSubstr(about));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
}

/// Makes a file that is no usable map; the tests below go through all of them.
struct BadMap {
    std::string name;
    std::string about;
    void (*make)(const std::filesystem::path&);
};

void makeMissing(const std::filesystem::path&) {}

void makeEmpty(const std::filesystem::path& file) {
    writeFile(file, std::string());
}

void makeTruncated(const std::filesystem::path& file) {
    const std::vector<std::byte> whole = readFile(roomFiles().map());
    writeFile(file, std::span(whole).first(whole.size() / 2));
}

void makeOther(const std::filesystem::path& file) {
    writeFile(file, "This is a shopping list: hammer, drill, sander.\n");
}

void makeFolderInstead(const std::filesystem::path& file) {
    makeFolder(file);
}

std::string asciiPcd(const std::vector<Eigen::Vector3d>& points) {
    std::ostringstream text;
    text << "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " << points.size()
         << "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " << points.size() << "\nDATA ascii\n";
    for (const Eigen::Vector3d& point : points)
        text << point.x() << " " << point.y() << " " << point.z() << "\n";
    return text.str();
}

void makeNan(const std::filesystem::path& file) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    writeFile(file, asciiPcd(std::vector<Eigen::Vector3d>(100, {nan, nan, nan})));
}

void makeSingle(const std::filesystem::path& file) {
    writeFile(file, asciiPcd({{1.0, 1.0, 0.0}}));
}

void makeIdentical(const std::filesystem::path& file) {
    writeFile(file, asciiPcd(std::vector<Eigen::Vector3d>(500, {1.0, 1.0, 0.0})));
}

void makeMillimetres(const std::filesystem::path& file) {
    PointCloud cloud = readPointCloud(roomFiles().map());
    for (Eigen::Vector3d& point : cloud.points)
        point *= 1000.0;
    writePointCloud(file, cloud);
}

void makeElsewhere(const std::filesystem::path& file) {
    // The inside of a sphere: no place of the room looks like it.
    std::vector<Eigen::Vector3d> points;
    constexpr int kPoints = 8000;
    for (int i = 0; i < kPoints; ++i) {
        const double z = 1.0 - 2.0 * (i + 0.5) / kPoints;
        const double angle_rad = i * 2.399963;
        points.push_back({1.2 * std::sqrt(1 - z * z) * std::cos(angle_rad),
                          1.2 * std::sqrt(1 - z * z) * std::sin(angle_rad), 1.2 * z});
    }
    writeFile(file, asciiPcd(points));
}

class BadMaps : public ::testing::TestWithParam<BadMap> {};

TEST_P(BadMaps, DetectRefusesThemAndLeavesNothingBehind) {
    TestFolder folder;
    const std::filesystem::path map = folder / "bad.pcd";
    GetParam().make(map);
    const std::filesystem::path out = folder / "out";
    const Outcome outcome =
        runCli({"detect", "--reference", roomFiles().reference(), "--map", map.string(), "--out", out.string()});
    expectRefused(outcome, map.string(), GetParam().about);
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_P(BadMaps, ReferenceRefusesThemAndLeavesNothingBehind) {
    if (GetParam().name == "Identical") GTEST_SKIP() << "the other maps fill such a one up";
    TestFolder folder;
    const std::filesystem::path map = folder / "bad.pcd";
    GetParam().make(map);
    const std::filesystem::path out = folder / "reference.ply";
    const Outcome outcome =
        runCli({"reference", "--maps", roomFiles().nominalMaps()[0], map.string(), "--out", out.string()});
    expectRefused(outcome, map.string(), GetParam().about);
    EXPECT_FALSE(std::filesystem::exists(out));
}

INSTANTIATE_TEST_SUITE_P(All, BadMaps,
                         ::testing::Values(BadMap{"Missing", "no such file", makeMissing},
                                           BadMap{"Empty", "empty", makeEmpty}, BadMap{"Truncated", "", makeTruncated},
                                           BadMap{"Other", "", makeOther},
                                           BadMap{"Folder", "folder", makeFolderInstead}, BadMap{"Nan", "", makeNan},
                                           BadMap{"Single", "point", makeSingle},
                                           BadMap{"Identical", "", makeIdentical},
                                           BadMap{"Millimetres", "metres", makeMillimetres},
                                           BadMap{"Elsewhere", "not aligned", makeElsewhere}),
                         [](const auto& info) { return info.param.name; });

TEST(BadReference, WithoutCovariancesItIsRefusedForMahalanobisAndServesForEuclidean) {
    TestFolder folder;
    const std::string reference = roomFiles().bareReference();
    std::vector<std::string> arguments{
        "detect", "--reference", reference, "--map", roomFiles().map(), "--out", (folder / "out").string()};
    expectRefused(runCli(arguments), reference, "covariance");
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    arguments.insert(arguments.end(), {"--metric", "euclidean"});
    EXPECT_EQ(runCli(arguments).exitCode, 0);
}

TEST(BadReference, DamagedOnesAreRefused) {
    TestFolder folder;
    const std::filesystem::path file = folder / "reference.ply";
    const std::vector<std::byte> whole = readFile(roomFiles().reference());
    for (const std::size_t size : {std::size_t{0}, std::size_t{20}, std::size_t{300}, whole.size() - 100}) {
        writeFile(file, std::span(whole).first(size));
        expectRefused(runCli({"detect", "--reference", file.string(), "--map", roomFiles().map(), "--out",
                              (folder / "out").string()}),
                      file.string(), "");
    }
}

TEST(BadReference, CountsThatAreNoneAreRefused) {
    TestFolder folder;
    const std::filesystem::path file = folder / "reference.ply";
    writeFile(file, std::string("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                                "property float z\nproperty int occupancy\nend_header\n"
                                "0 0 0 4\n1 0 0 -4\n0 1 1 4\n"));
    expectRefused(runCli({"detect", "--reference", file.string(), "--map", roomFiles().map(), "--metric", "euclidean",
                          "--out", (folder / "out").string()}),
                  file.string(), "occupancy of point 2");
}

TEST(BadMesh, IsRefused) {
    TestFolder folder;
    const std::filesystem::path mesh = folder / "tank.stl";
    writeFile(mesh, "solid but empty");
    expectRefused(runCli({"reference", "--cad", mesh.string(), "--out", (folder / "r.ply").string()}), mesh.string(),
                  "");
}

TEST(BadMesh, WithCoordinatesThatAreNotFiniteIsRefused) {
    TestFolder folder;
    const std::filesystem::path mesh = folder / "tank.obj";
    for (const char* bad : {"nan", "inf", "1e999"}) {
        writeFile(mesh, std::string("v 0 0 0\nv 1 0 0\nv 0 ") + bad + " 0\nf 1 2 3\n");
        expectRefused(runCli({"reference", "--cad", mesh.string(), "--out", (folder / "r.ply").string()}),
                      mesh.string(), "");
        EXPECT_FALSE(std::filesystem::exists(folder / "r.ply"));
    }
}

TEST(BadTransform, IsRefused) {
    TestFolder folder;
    const std::filesystem::path file = folder / "T.csv";
    for (const char* text : {"", "1,0,0,0\n0,1,0,0\n0,0,1,0\n", "1,0,0,0\n0,1,0,0\n0,0,1,0\n0,0,0,one\n",
                             "2,0,0,0\n0,2,0,0\n0,0,2,0\n0,0,0,1\n", "1,0,0,nan\n0,1,0,0\n0,0,1,0\n0,0,0,1\n"}) {
        writeFile(file, std::string_view(text));
        expectRefused(runCli({"detect", "--reference", roomFiles().reference(), "--map", roomFiles().map(),
                              "--transform", file.string(), "--out", (folder / "out").string()}),
                      file.string(), "");
    }
    const std::vector<std::string> maps = roomFiles().nominalMaps();
    writeFile(file,
              "m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m23,m30,m31,m32,m33\n"
              "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1\n");
    expectRefused(runCli({"reference", "--maps", maps[0], maps[1], "--transforms", file.string(), "--out",
                          (folder / "r.ply").string()}),
                  file.string(), "2 maps");
}

TEST(BadPlace, AnOutputThatCannotBeWrittenIsTold) {
    TestFolder folder;
    writeFile(folder / "file", std::string("in the way"));
    const std::string out = (folder / "file").string() + "/out";
    const Outcome outcome =
        runCli({"detect", "--reference", roomFiles().reference(), "--map", roomFiles().map(), "--out", out});
    expectRefused(outcome, out, "");
}

TEST(BadSession, IsRefused) {
    TestFolder folder;
    const std::filesystem::path file = folder / "s.fodscope";
    expectRefused(runCli({"verify", file.string()}), file.string(), "");
    writeFile(file, std::string("no database"));
    expectRefused(runCli({"verify", file.string()}), file.string(), "");
    expectRefused(runCli({"report", file.string(), "--out", (folder / "r.html").string()}), file.string(), "");
    EXPECT_FALSE(std::filesystem::exists(folder / "r.html"));
}

TEST(BadCandidates, AreRefused) {
    TestFolder folder;
    const std::filesystem::path file = folder / "candidates.json";
    for (const char* text :
         {"", "{", "[]", "{\"schema\": \"other\"}", "{\"schema\": \"fodscope.candidates/1\", \"candidates\": 3}"}) {
        writeFile(file, std::string_view(text));
        expectRefused(runCli({"plan", "--candidates", file.string(), "--map", roomFiles().map(), "--robot", "1,1,0",
                              "--out", (folder / "w.json").string()}),
                      file.string(), "");
    }
}

}  // namespace
}  // namespace fodscope::test
