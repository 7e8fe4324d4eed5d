// SPDX-License-Identifier: MIT
#include "core/reference/ReferenceMapIo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/cloud/Ply.h"
#include "core/cloud/PointCloudIo.h"
#include "core/common/Files.h"
#include "tests/unit/cloud/ExpectError.h"
#include "tests/unit/cloud/TemporaryFolder.h"

namespace fodscope {
namespace {

ReferenceMap trained() {
    ReferenceMap reference;
    reference.points = {{0.5, 1.0, 2.0}, {3.0, 4.0, 5.0}};
    reference.occupancy = {12, 3};
    reference.sampleCount = {40, 0};
    reference.untrained = {0, 1};
    reference.covariance.assign(2, Eigen::Matrix3d::Constant(std::nan("")));
    reference.covariance[0] << 4.0, 0.5, 0.25, 0.5, 2.0, -0.125, 0.25, -0.125, 1.0;
    reference.provenance = {"made by a test", "second line"};
    return reference;
}

TEST(ReferenceMapIo, IsReadBack) {
    const TemporaryFolder folder;
    writeReferenceMap(folder / "ref.ply", trained());
    const ReferenceMap again = readReferenceMap(folder / "ref.ply");
    EXPECT_EQ(again.points, trained().points);
    EXPECT_EQ(again.occupancy, trained().occupancy);
    EXPECT_EQ(again.sampleCount, trained().sampleCount);
    EXPECT_EQ(again.untrained, trained().untrained);
    EXPECT_EQ(again.covariance[0], trained().covariance[0]);
    EXPECT_TRUE(std::isnan(again.covariance[1](2, 2)));
    EXPECT_EQ(again.provenance, trained().provenance);
    EXPECT_TRUE(again.hasCovariance());
}

TEST(ReferenceMapIo, HoldsThePropertiesOfTheContract) {
    const TemporaryFolder folder;
    writeReferenceMap(folder / "ref.ply", trained());
    const PlyContents contents = parsePly(readFile(folder / "ref.ply"), "ref.ply", PlyFaces::Read);
    std::vector<std::string> names;
    for (const PlyColumn& column : contents.columns)
        names.push_back(column.name);
    EXPECT_EQ(names, (std::vector<std::string>{"x", "y", "z", "occupancy", "sample_count", "untrained", "cov_xx",
                                               "cov_xy", "cov_xz", "cov_yy", "cov_yz", "cov_zz", "log_det"}));
    EXPECT_EQ(contents.column("occupancy")->type, ScalarType::Int32);
    EXPECT_EQ(contents.column("cov_yz")->values[0], -0.125);
    // 4·(2·1 − 1/64) − 0.5·(0.5·1 + 0.125/4) + 0.25·(−0.5/8 − 0.25·2)
    EXPECT_NEAR(contents.column("log_det")->values[0], std::log(7.53125), 1e-6);
    EXPECT_TRUE(std::isnan(contents.column("log_det")->values[1]));
}

TEST(ReferenceMapIo, TakesAnyCloudAsAReferenceWithoutCovariances) {
    const TemporaryFolder folder;
    PointCloud cloud;
    cloud.points = {{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
    for (const char* name : {"cloud.pcd", "cloud.ply"}) {
        writePointCloud(folder / name, cloud);
        const ReferenceMap reference = readReferenceMap(folder / name);
        EXPECT_EQ(reference.points, cloud.points);
        EXPECT_FALSE(reference.hasCovariance());
        EXPECT_TRUE(reference.occupancy.empty());
    }
    ReferenceMap plain;
    plain.points = cloud.points;
    writeReferenceMap(folder / "plain.ply", plain);
    EXPECT_EQ(parsePly(readFile(folder / "plain.ply"), "plain.ply", PlyFaces::Read).columns.size(), 3u);
}

TEST(ReferenceMapIo, DropsPointsThatAreNotFiniteFromEveryProperty) {
    const TemporaryFolder folder;
    const std::vector<PlyColumn> columns{{"x", ScalarType::Float32, {std::nan(""), 1.0}},
                                         {"y", ScalarType::Float32, {0.0, 2.0}},
                                         {"z", ScalarType::Float32, {0.0, 3.0}},
                                         {"occupancy", ScalarType::Int32, {5.0, 6.0}}};
    writePly(folder / "ref.ply", {}, columns);
    const ReferenceMap reference = readReferenceMap(folder / "ref.ply");
    EXPECT_EQ(reference.points, (std::vector<Eigen::Vector3d>{{1.0, 2.0, 3.0}}));
    EXPECT_EQ(reference.occupancy, std::vector<std::int32_t>{6});
}

TEST(ReferenceMapIo, TakesACovarianceThatIsNoneForUntrained) {
    const TemporaryFolder folder;
    ReferenceMap reference = trained();
    reference.covariance[0] = Eigen::Vector3d(1.0, 1.0, -1.0).asDiagonal();
    writeReferenceMap(folder / "ref.ply", reference);
    EXPECT_EQ(readReferenceMap(folder / "ref.ply").untrained, (std::vector<std::uint8_t>{1, 1}));
}

std::vector<PlyColumn> threePoints() {
    return {{"x", ScalarType::Float32, {1.0, 2.0, 3.0}},
            {"y", ScalarType::Float32, {1.0, 2.0, 3.0}},
            {"z", ScalarType::Float32, {1.0, 2.0, 3.0}}};
}

TEST(ReferenceMapIo, RefusesCountsThatAreNone) {
    const TemporaryFolder folder;
    for (const char* name : {"occupancy", "sample_count"}) {
        for (const double bad : {-1.0, 2.5, 1e12, std::nan(""), HUGE_VAL}) {
            std::vector<PlyColumn> columns = threePoints();
            columns.push_back({name, ScalarType::Float64, {4.0, bad, 5.0}});
            writePly(folder / "ref.ply", {}, columns);
            expectError([&] { readReferenceMap(folder / "ref.ply"); },
                        std::string("ref.ply: the ") + name + " of point 2 is no count");
        }
    }
}

TEST(ReferenceMapIo, APointIsTrainedOnlyWhereMarkAndCovarianceSaySo) {
    const TemporaryFolder folder;
    // Marked as untrained with a covariance; marked as trained with one that is none; a mark that is no mark.
    std::vector<PlyColumn> columns = threePoints();
    columns.push_back({"untrained", ScalarType::Float32, {1.0, 0.0, std::nan("")}});
    for (const char* name : {"cov_xx", "cov_yy", "cov_zz"})
        columns.push_back({name, ScalarType::Float32, {1.0, std::nan(""), 1.0}});
    for (const char* name : {"cov_xy", "cov_xz", "cov_yz"})
        columns.push_back({name, ScalarType::Float32, {0.0, 0.0, 0.0}});
    writePly(folder / "ref.ply", {}, columns);
    const ReferenceMap reference = readReferenceMap(folder / "ref.ply");
    EXPECT_EQ(reference.untrained, (std::vector<std::uint8_t>{1, 1, 1}));
    for (const Eigen::Matrix3d& covariance : reference.covariance)
        EXPECT_TRUE(covariance.array().isNaN().all());
}

TEST(ReferenceMapIo, TellsWhatIsWrongWithAFile) {
    const TemporaryFolder folder;
    const std::vector<PlyColumn> columns{
        {"x", ScalarType::Float32, {1.0}},      {"y", ScalarType::Float32, {2.0}},
        {"z", ScalarType::Float32, {3.0}},      {"cov_xx", ScalarType::Float32, {1.0}},
        {"cov_yy", ScalarType::Float32, {1.0}}, {"cov_zz", ScalarType::Float32, {1.0}}};
    writePly(folder / "part.ply", {}, columns);
    expectError([&] { readReferenceMap(folder / "part.ply"); }, "cov_xy, cov_xz, cov_yz");
    expectError([&] { readReferenceMap(folder / "missing.ply"); }, "no such file");
    expectError([&] { readReferenceMap(folder.write("empty.ply", "")); }, "is empty");
    expectError([&] { readReferenceMap(folder.write("text.ply", "hello")); }, "is no point cloud");
    writeReferenceMap(folder / "ref.ply", trained());
    const std::string whole = readTextFile(folder / "ref.ply");
    expectError([&] { readReferenceMap(folder.write("cut.ply", whole.substr(0, whole.size() - 1))); }, "is truncated");
    expectError([&] { writeReferenceMap(folder / "missing/ref.ply", trained()); }, "cannot be written");
}

}  // namespace
}  // namespace fodscope
