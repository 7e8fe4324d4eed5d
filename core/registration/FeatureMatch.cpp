// SPDX-License-Identifier: MIT
#include "core/registration/FeatureMatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "core/registration/Icp.h"
#include "core/registration/PointFeatures.h"

namespace fodscope {
namespace {

constexpr const char* kStage = "searching a coarse alignment";
/// Radii of normals and features in voxels: the usual proportions for FPFH.
constexpr double kNormalRadius_voxels = 2.0;
constexpr double kFeatureRadius_voxels = 5.0;
/// Only the points whose surroundings are the least ordinary are matched: floor and walls look alike everywhere.
constexpr std::size_t kDistinctivePoints = 1500;
constexpr std::size_t kMatchesOfAPoint = 3;
constexpr int kTriples = 60000;
/// The edges of a true pair of triangles have nearly the same length.
constexpr double kEdgeRatio = 0.85;
constexpr double kAgreement_voxels = 2.0;
/// Leaning by more than this, cos 20°, is not proposed: both frames have z up.
constexpr double kLeastUprightness = 0.94;
constexpr std::size_t kProposals = 24;

struct Match {
    std::uint32_t source = 0;
    std::uint32_t target = 0;
};

double squaredDifference(const PointFeature& a, const PointFeature& b) {
    float sum = 0.0F;
    for (std::size_t bin = 0; bin < a.size(); ++bin)
        sum += (a[bin] - b[bin]) * (a[bin] - b[bin]);
    return sum;
}

std::vector<std::uint32_t> distinctive(std::span<const PointFeature> features) {
    PointFeature mean{};
    for (const PointFeature& feature : features) {
        for (std::size_t bin = 0; bin < mean.size(); ++bin)
            mean[bin] += feature[bin];
    }
    for (float& bin : mean)
        bin /= static_cast<float>(features.size());
    std::vector<std::pair<double, std::uint32_t>> ranked;
    for (std::uint32_t i = 0; i < features.size(); ++i)
        ranked.emplace_back(-squaredDifference(features[i], mean), i);
    std::ranges::sort(ranked);
    std::vector<std::uint32_t> chosen;
    // Every other one of the most unusual: neighbours share their surroundings and would only repeat each other.
    const std::size_t step = ranked.size() > 2 * kDistinctivePoints ? 2 : 1;
    for (std::size_t i = 0; i < ranked.size() && chosen.size() < kDistinctivePoints; i += step) {
        chosen.push_back(ranked[i].second);
    }
    return chosen;
}

std::vector<Match> matchesOf(std::span<const PointFeature> source, std::span<const PointFeature> target,
                             Progress& progress) {
    std::vector<Match> matches;
    std::vector<std::pair<double, std::uint32_t>> ranked(target.size());
    const std::vector<std::uint32_t> chosen = distinctive(source);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (i % 16 == 0) progress.report(kStage, 0.3 * static_cast<double>(i) / static_cast<double>(chosen.size()));
        for (std::uint32_t t = 0; t < target.size(); ++t) {
            ranked[t] = {squaredDifference(source[chosen[i]], target[t]), t};
        }
        const std::size_t kept = std::min(kMatchesOfAPoint, ranked.size());
        std::ranges::partial_sort(ranked, ranked.begin() + static_cast<std::ptrdiff_t>(kept));
        for (std::size_t k = 0; k < kept; ++k)
            matches.push_back({chosen[i], ranked[k].second});
    }
    return matches;
}

bool sameShape(const std::array<Eigen::Vector3d, 3>& from, const std::array<Eigen::Vector3d, 3>& to,
               double leastEdge_m) {
    for (std::size_t i = 0; i < 3; ++i) {
        const double a_m = (from[i] - from[(i + 1) % 3]).norm();
        const double b_m = (to[i] - to[(i + 1) % 3]).norm();
        if (a_m < leastEdge_m || std::min(a_m, b_m) < kEdgeRatio * std::max(a_m, b_m)) return false;
    }
    return true;
}

struct Proposal {
    Transform motion = Transform::Identity();
    std::size_t agreeing = 0;
};

bool alike(const Transform& a, const Transform& b, const Eigen::Vector3d& middle, double tolerance_m) {
    const Eigen::AngleAxisd turn(a.linear() * b.linear().transpose());
    return turn.angle() < 0.15 && (a * middle - b * middle).norm() < tolerance_m;
}

/// Keeps the proposals that differ, the one with most agreement first.
void keepProposal(std::vector<Proposal>& proposals, const Proposal& proposal, const Eigen::Vector3d& middle,
                  double tolerance_m) {
    const auto same = std::ranges::find_if(
        proposals, [&](const Proposal& kept) { return alike(kept.motion, proposal.motion, middle, tolerance_m); });
    if (same != proposals.end()) {
        if (same->agreeing >= proposal.agreeing) return;
        proposals.erase(same);
    }
    const auto place =
        std::ranges::find_if(proposals, [&](const Proposal& kept) { return kept.agreeing < proposal.agreeing; });
    proposals.insert(place, proposal);
    if (proposals.size() > kProposals) proposals.pop_back();
}

}  // namespace

std::vector<Transform> matchFeatures(std::span<const Eigen::Vector3d> source, std::span<const Eigen::Vector3d> target,
                                     double voxelSize_m, Progress& progress) {
    if (source.size() < 3 || target.size() < 3) return {};
    const double normalRadius_m = kNormalRadius_voxels * voxelSize_m;
    const double featureRadius_m = kFeatureRadius_voxels * voxelSize_m;
    const auto sourceFeatures = pointFeatures(source, normalRadius_m, featureRadius_m, progress);
    const auto targetFeatures = pointFeatures(target, normalRadius_m, featureRadius_m, progress);
    const std::vector<Match> matches = matchesOf(sourceFeatures, targetFeatures, progress);

    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : source)
        middle += point;
    middle /= static_cast<double>(source.size());

    const double agreement_m = kAgreement_voxels * voxelSize_m;
    std::mt19937_64 random(20240607);
    std::vector<Proposal> proposals;
    for (int trial = 0; trial < kTriples; ++trial) {
        if (trial % 512 == 0) progress.report(kStage, 0.3 + 0.7 * trial / kTriples);
        std::array<Eigen::Vector3d, 3> from;
        std::array<Eigen::Vector3d, 3> to;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Match& match = matches[random() % matches.size()];
            from[corner] = source[match.source];
            to[corner] = target[match.target];
        }
        if (!sameShape(from, to, 3.0 * featureRadius_m / 2.0)) continue;
        Proposal proposal{rigidMotion(from, to), 0};
        if (proposal.motion.linear()(2, 2) < kLeastUprightness) continue;
        for (const Match& match : matches) {
            const double away_m2 = (proposal.motion * source[match.source] - target[match.target]).squaredNorm();
            if (away_m2 < agreement_m * agreement_m) ++proposal.agreeing;
        }
        keepProposal(proposals, proposal, middle, 3.0 * voxelSize_m);
    }
    std::vector<Transform> motions;
    for (const Proposal& proposal : proposals)
        motions.push_back(proposal.motion);
    return motions;
}

}  // namespace fodscope
