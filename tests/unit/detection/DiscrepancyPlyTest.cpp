// SPDX-License-Identifier: MIT
#include "core/detection/DiscrepancyPly.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/cloud/Ply.h"
#include "core/common/Error.h"
#include "core/common/Files.h"

namespace fodscope {
namespace {

TEST(DiscrepancyPly, HoldsThePropertiesOfTheContract) {
    DiscrepancyField field;
    field.points = {{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
    field.weights = {7, 8};
    field.nearest = {0, 0};
    field.euclidean_m = {0.25, 0.5};
    field.mahalanobis = {1.5, std::nan("")};
    field.smoothedEuclidean_m = {0.375, 0.4375};
    field.smoothedMahalanobis = {1.25, 3.5};
    CandidateSet set;
    set.candidates.resize(1);
    set.candidates[0].id = "C-012";
    set.candidates[0].voxels = {1};
    set.candidateOfVoxel = {-1, 0};
    const auto file = std::filesystem::path(testing::TempDir()) / "fodscope-discrepancy.ply";
    writeDiscrepancyPly(file, field, set, Metric::Mahalanobis);
    const PlyContents contents = parsePly(readFile(file), file.string(), PlyFaces::Read);
    std::vector<std::string> names;
    for (const PlyColumn& column : contents.columns)
        names.push_back(column.name);
    EXPECT_EQ(names, (std::vector<std::string>{"x", "y", "z", "weight", "euclidean", "mahalanobis", "discrepancy",
                                               "candidate"}));
    EXPECT_EQ(contents.column("weight")->values, (std::vector<double>{7.0, 8.0}));
    EXPECT_EQ(contents.column("discrepancy")->values, (std::vector<double>{1.25, 3.5}));
    EXPECT_TRUE(std::isnan(contents.column("mahalanobis")->values[1]));
    EXPECT_EQ(contents.column("candidate")->values, (std::vector<double>{-1.0, 12.0}));

    field.mahalanobis.clear();
    field.smoothedMahalanobis.clear();
    writeDiscrepancyPly(file, field, set, Metric::Euclidean);
    const PlyContents plain = parsePly(readFile(file), file.string(), PlyFaces::Read);
    EXPECT_EQ(plain.column("mahalanobis"), nullptr);
    EXPECT_EQ(plain.column("discrepancy")->values, (std::vector<double>{0.375, 0.4375}));
    EXPECT_EQ(plain.column("chi_square"), nullptr);
    EXPECT_THROW(writeDiscrepancyPly(file, field, set, Metric::Mahalanobis), Error);
    EXPECT_THROW(writeDiscrepancyPly(file, field, set, Metric::ChiSquare), Error);

    field.chiSquare = {4.5, 250.0};
    writeDiscrepancyPly(file, field, set, Metric::ChiSquare);
    const PlyContents tested = parsePly(readFile(file), file.string(), PlyFaces::Read);
    EXPECT_EQ(tested.column("chi_square")->values, field.chiSquare);
    EXPECT_EQ(tested.column("discrepancy")->values, field.chiSquare);
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace fodscope
