// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/registration/Registration.h"
#include "tests/unit/registration/SyntheticRoom.h"

namespace fodscope {
namespace {

using test::mapOf;
using test::motion;
using test::roomPanels;
using test::roomReference;

/// Error of a found pose, in the uncertainty's own terms: about its centre.
Eigen::Matrix<double, 6, 1> errorOf(const RegistrationResult& result, const Transform& truth) {
    const Eigen::Vector3d centre_map = result.T_reference_from_map.inverse() * result.uncertainty->centre_reference;
    const Eigen::AngleAxisd turn(result.T_reference_from_map.linear() * truth.linear().transpose());
    Eigen::Matrix<double, 6, 1> error;
    error << result.T_reference_from_map * centre_map - truth * centre_map, turn.angle() * turn.axis();
    return error;
}

TEST(PoseUncertainty, ErrorsOfKnownPosesLieWithinThreeDeviations) {
    const std::vector<Eigen::Vector3d> reference = roomReference();
    const Transform T_map_from_room = motion(25.0, {0.5, -1.0, 0.2});
    for (const std::uint64_t seed : {11U, 12U, 13U, 14U}) {
        Progress progress;
        const RegistrationResult result =
            registerMap(mapOf(roomPanels(), T_map_from_room, seed), reference, T_map_from_room.inverse(), {}, progress);
        ASSERT_EQ(result.quality, RegistrationQuality::Good);
        ASSERT_TRUE(result.uncertainty.has_value());
        const PoseUncertainty& uncertainty = *result.uncertainty;
        const auto error = errorOf(result, T_map_from_room.inverse());
        for (Eigen::Index i = 0; i < 6; ++i) {
            EXPECT_LT(std::abs(error[i]), 3.0 * std::sqrt(uncertainty.covariance(i, i))) << seed << " axis " << i;
        }
        EXPECT_LT(uncertainty.positionDeviation_m().maxCoeff(), 0.008);
        EXPECT_LT(uncertainty.angleDeviation_rad().maxCoeff(), 0.006);
        EXPECT_FALSE(uncertainty.isLoose());
        EXPECT_LT((uncertainty.centre_reference - Eigen::Vector3d(2.0, 1.5, 0.4)).norm(), 0.5);
    }
}

/// Three squares across each other, whose points' residuals are independent.
std::vector<PlaneEquation> cornerEquations(double deviation_m, std::size_t perPlane, double spacing_m) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> noise(0.0, deviation_m);
    std::vector<PlaneEquation> equations;
    for (int axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < perPlane; ++i) {
            for (std::size_t k = 0; k < perPlane; ++k) {
                Eigen::Vector3d point = Eigen::Vector3d::Zero();
                point[(axis + 1) % 3] = static_cast<double>(i) * spacing_m;
                point[(axis + 2) % 3] = static_cast<double>(k) * spacing_m;
                equations.push_back({point, Eigen::Vector3d::Unit(axis), noise(random), 1.0});
            }
        }
    }
    return equations;
}

TEST(PoseUncertainty, IndependentResidualsGiveTheTextbookCovariance) {
    // Points much farther apart than the correlation reaches: σ² H⁻¹.
    constexpr double kDeviation_m = 0.1;
    const std::vector<PlaneEquation> equations = cornerEquations(kDeviation_m, 14, 10.0);
    const MotionEquations motion = motionEquations(equations);
    const PoseUncertainty uncertainty = poseUncertainty(equations, motion, 0.5);
    Eigen::Matrix<double, 6, 6> information = Eigen::Matrix<double, 6, 6>::Zero();
    for (const PlaneEquation& equation : equations) {
        Eigen::Matrix<double, 6, 1> row;
        row << equation.normal, (equation.point_reference - uncertainty.centre_reference).cross(equation.normal);
        information += row * row.transpose();
    }
    Eigen::Matrix<double, 6, 6> textbook = kDeviation_m * kDeviation_m * information.inverse();
    // And the two millimetres that residuals cannot tell.
    textbook.diagonal().head<3>().array() += 4e-6;
    textbook.diagonal().tail<3>().array() += 4e-6 / (motion.length_m * motion.length_m);
    for (Eigen::Index i = 0; i < 6; ++i) {
        EXPECT_NEAR(std::sqrt(uncertainty.covariance(i, i) / textbook(i, i)), 1.0, 0.15) << i;
    }
}

TEST(PoseUncertainty, ResidualsThatGoTogetherCountAsOne) {
    // The same residual ten times at each place tells no more than once.
    const std::vector<PlaneEquation> once = cornerEquations(0.01, 8, 1.0);
    std::vector<PlaneEquation> often;
    for (const PlaneEquation& equation : once)
        often.insert(often.end(), 10, equation);
    const PoseUncertainty a = poseUncertainty(once, motionEquations(once), 0.2);
    const PoseUncertainty b = poseUncertainty(often, motionEquations(often), 0.2);
    EXPECT_TRUE(a.covariance.isApprox(b.covariance, 1e-9));
}

TEST(PoseUncertainty, DirectionsThatNothingHoldsAreNamed) {
    std::vector<PlaneEquation> equations = cornerEquations(0.01, 8, 0.5);
    // Without the planes across x.
    std::erase_if(equations, [](const PlaneEquation& equation) { return equation.normal.x() > 0.5; });
    const PoseUncertainty uncertainty = poseUncertainty(equations, motionEquations(equations), 0.5);
    ASSERT_EQ(uncertainty.looseDirections.size(), 1U);
    EXPECT_GT(std::abs(uncertainty.looseDirections[0].x()), 0.99);
    EXPECT_FALSE(uncertainty.looseTurn);
    EXPECT_EQ(looseInWords(uncertainty), "the position along x");
}

}  // namespace
}  // namespace fodscope
