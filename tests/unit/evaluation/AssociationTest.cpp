// SPDX-License-Identifier: MIT
#include "core/evaluation/Association.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/common/Error.h"

namespace fodscope {
namespace {

using Points = std::vector<Eigen::Vector3d>;

TEST(Association, ChargesTheMeanDistanceAndEveryUnassociatedCandidate) {
    const Points fods = {{0, 0, 0}, {4, 0, 0}};
    const Points candidates = {{0.1, 0, 0}, {4, 0.3, 0}, {2, 2, 0}, {4.1, 0.4, 0}};
    const Association result = associate(fods, candidates, 0.05);
    EXPECT_DOUBLE_EQ(0.1, *result.fods[0].distance_m);
    EXPECT_DOUBLE_EQ(0.3, *result.fods[1].distance_m);
    EXPECT_EQ(0u, *result.fods[0].nearest);
    EXPECT_EQ(1u, *result.fods[1].nearest);
    EXPECT_EQ((std::vector<std::uint8_t>{1, 1, 0, 0}), result.isAssociated);
    EXPECT_EQ(2u, result.unassociatedCandidates);
    EXPECT_DOUBLE_EQ(0.2 + 0.05 * 2, result.cost);
}

TEST(Association, OneCandidateMayServeSeveralFod) {
    const Points fods = {{0, 0, 0}, {0.2, 0, 0}};
    const Association result = associate(fods, Points{{0.1, 0, 0}}, 0.05);
    EXPECT_EQ(0u, result.unassociatedCandidates);
    EXPECT_NEAR(0.1, result.cost, 1e-15);
}

TEST(Association, GivesATieToTheLowerIndex) {
    const Association result = associate(Points{{0, 0, 0}}, Points{{5, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}}, 0.05);
    EXPECT_EQ(1u, *result.fods[0].nearest);
}

TEST(Association, CountsTheFarCandidateOfAMissedFodAsAssociatedAndAsFalse) {
    const Association result = associate(Points{{0, 0, 0}}, Points{{3, 0, 0}}, 0.05);
    EXPECT_EQ(0u, result.unassociatedCandidates);
    EXPECT_EQ(1u, result.falseCandidates);
}

TEST(Association, MeasuresInThreeDimensions) {
    const Association result = associate(Points{{0, 0, 0}}, Points{{0.3, 0.4, 1.2}}, 0.05);
    EXPECT_DOUBLE_EQ(1.3, *result.fods[0].distance_m);
}

TEST(Association, CountsACandidateAtExactlyTheLimitAsNotFalse) {
    EXPECT_EQ(0u, associate(Points{{0, 0, 0}}, Points{{0.3, 0, 0}}, 0.05).falseCandidates);
    EXPECT_EQ(1u, associate(Points{{0, 0, 0}}, Points{{0.300001, 0, 0}}, 0.05).falseCandidates);
}

TEST(Association, ChargesAFodWithoutCandidates) {
    const Association result = associate(Points{{0, 0, 0}, {1, 0, 0}}, Points{}, 0.05);
    EXPECT_FALSE(result.fods[0].distance_m.has_value());
    EXPECT_FALSE(result.fods[0].nearest.has_value());
    EXPECT_DOUBLE_EQ(7.5, result.cost);
}

TEST(Association, CountsEveryCandidateWhereNoFodLies) {
    const Association result = associate(Points{}, Points{{0, 0, 0}, {1, 0, 0}}, 0.05);
    EXPECT_EQ(2u, result.unassociatedCandidates);
    EXPECT_EQ(2u, result.falseCandidates);
    EXPECT_DOUBLE_EQ(0.1, result.cost);
}

TEST(Association, RefusesWhatIsNoNumber) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_THROW(associate(Points{{nan, 0, 0}}, Points{}, 0.05), Error);
    EXPECT_THROW(associate(Points{{0, 0, 0}}, Points{{0, infinity, 0}}, 0.05), Error);
    EXPECT_THROW(associate(Points{{0, 0, 0}}, Points{}, nan), Error);
    EXPECT_THROW(associate(Points{{0, 0, 0}}, Points{}, -0.05), Error);
}

}  // namespace
}  // namespace fodscope
