// SPDX-License-Identifier: MIT
// Sums over neighbourhoods do not depend on how many threads share the work.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstring>

#include "core/detection/Discrepancy.h"
#include "core/reference/CovarianceFit.h"
#include "tests/unit/cloud/RandomPoints.h"

namespace fodscope {
namespace {

struct Smoothed {
    std::vector<Eigen::Matrix3d> covariance;
    std::vector<double> mahalanobis;
};

Smoothed smoothedWith(std::size_t threads, SmoothingNeighbourhood neighbourhood) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Progress progress;
    ReferenceMap reference;
    reference.points = randomPoints(20000, 91);
    collectScatter(randomPoints(30000, 92), reference, progress);
    CovarianceFitSettings fit;
    fit.smoothing = {neighbourhood, 40, 0.08, SmoothingWeights::Gaussian, 0.03};
    fitCovariances(reference, fit, progress);
    DiscrepancySettings settings;
    settings.smoothing = fit.smoothing;
    settings.smoothingPasses = 2;
    DiscrepancyField field =
        measureDiscrepancy(randomPoints(20000, 93), Transform::Identity(), reference, settings, progress);
    return {std::move(reference.covariance), std::move(field.smoothedMahalanobis)};
}

template <class Value>
bool sameBytes(const std::vector<Value>& a, const std::vector<Value>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0;
}

TEST(SmoothingThreads, OneAndTwoGiveTheSameBytes) {
    for (const auto neighbourhood : {SmoothingNeighbourhood::Ball, SmoothingNeighbourhood::NearestNeighbours}) {
        const Smoothed one = smoothedWith(1, neighbourhood);
        const Smoothed two = smoothedWith(2, neighbourhood);
        EXPECT_TRUE(sameBytes(one.covariance, two.covariance));
        EXPECT_TRUE(sameBytes(one.mahalanobis, two.mahalanobis));
    }
}

}  // namespace
}  // namespace fodscope
