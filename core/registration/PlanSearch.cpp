// SPDX-License-Identifier: MIT
#include "core/registration/PlanSearch.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <span>

#include "core/registration/OrderedSum.h"
#include "core/registration/PlanImage.h"

namespace fodscope {
namespace {

constexpr const char* kStage = "searching the start pose";
constexpr double kCell_voxels = 2.0;
/// Larger plans get coarser cells.
constexpr int kMostCells = 512;
/// Divides a half turn.
constexpr double kYawStep_rad = 3.0 / kDegreesPerRadian;
constexpr double kBlur_cells = 1.0;
constexpr std::size_t kPeaksOfAYaw = 6;
/// Proposals nearer than this to a better one lead to the same pose.
constexpr double kSamePlace_m = 0.3;
constexpr double kSameYaw_rad = 7.0 / kDegreesPerRadian;
/// Level surfaces lean by less than acos of this, 26°, before they are levelled.
constexpr double kLeastLevel = 0.9;
constexpr double kHeightBin_m = 0.025;

struct Peak {
    float value = 0.0F;
    int yaw = 0;
    Eigen::Vector2d shift_m = Eigen::Vector2d::Zero();
};

/// The frame in which both plans are drawn: the map turned round its middle, in cells.
struct Plan {
    Eigen::Vector2d mapMiddle_m;
    Eigen::Vector2d corner_m;
    double cellSize_m = 0.1;
    int edge_cells = 0;
    /// Of the map round its middle, in whole cells: turned half round, its cells come to lie on its cells.
    int mapRadius_cells = 0;

    double mapRadius_m() const { return mapRadius_cells * cellSize_m; }
};

Eigen::AlignedBox2d boundsOf(const std::vector<PlanMark>& marks) {
    Eigen::AlignedBox2d bounds;
    for (const PlanMark& mark : marks)
        bounds.extend(mark.place_m);
    return bounds;
}

Plan planFor(const std::vector<PlanMark>& map, const std::vector<PlanMark>& reference, double voxelSize_m) {
    Plan plan;
    const Eigen::AlignedBox2d mapBounds = boundsOf(map);
    const Eigen::AlignedBox2d referenceBounds = boundsOf(reference);
    plan.mapMiddle_m = mapBounds.center();
    double mapRadius_m = 0.0;
    for (const PlanMark& mark : map)
        mapRadius_m = std::max(mapRadius_m, (mark.place_m - plan.mapMiddle_m).norm());
    const double extent_m = referenceBounds.sizes().maxCoeff() + 2.0 * mapRadius_m;
    plan.cellSize_m = std::max(kCell_voxels * voxelSize_m, extent_m / (kMostCells - 4));
    plan.edge_cells = cv::getOptimalDFTSize(static_cast<int>(std::ceil(extent_m / plan.cellSize_m)) + 4);
    plan.mapRadius_cells = static_cast<int>(std::ceil(mapRadius_m / plan.cellSize_m));
    plan.corner_m = referenceBounds.min();
    return plan;
}

Eigen::Rotation2Dd turnOf(int yaw) {
    return Eigen::Rotation2Dd(yaw * kYawStep_rad);
}

PlanImage turnedMap(const std::vector<PlanMark>& map, const Plan& plan, int yaw) {
    // Its middle lies radius cells from the corner, so that all of it is in the picture at any yaw.
    PlanImage image(Eigen::Vector2d::Constant(-plan.mapRadius_m() - plan.cellSize_m / 2.0), plan.cellSize_m,
                    plan.edge_cells);
    const Eigen::Matrix2d turn = turnOf(yaw).toRotationMatrix();
    const Eigen::Matrix2d doubledTurn = turn * turn;
    for (const PlanMark& mark : map)
        image.add({turn * (mark.place_m - plan.mapMiddle_m), doubledTurn * mark.doubledNormal});
    image.compress();
    return image;
}

bool isHighest(const cv::Mat& values, int y, int x) {
    const int edge = values.rows;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            if (values.at<float>((y + dy + edge) % edge, (x + dx + edge) % edge) > values.at<float>(y, x)) return false;
        }
    }
    return true;
}

/// The greatest values of a correlation that are greater than those round them.
/// @param none_cells where the correlation holds no shift, on both axes
std::vector<Peak> peaksOf(const cv::Mat& values, const Plan& plan, int none_cells, int yaw, float scale) {
    std::vector<Peak> peaks;
    const int edge = plan.edge_cells;
    // The upper half of the shifts stands for negative ones.
    const auto shift = [&](int cell) {
        const int wrapped = (cell - none_cells + 2 * edge) % edge;
        return 2 * wrapped > edge ? wrapped - edge : wrapped;
    };
    float least = 0.0F;
    for (int y = 0; y < edge; ++y) {
        const auto* row = values.ptr<float>(y);
        for (int x = 0; x < edge; ++x) {
            if (row[x] <= least || !isHighest(values, y, x)) continue;
            const Peak peak{row[x], yaw, Eigen::Vector2d(shift(x), shift(y)) * plan.cellSize_m};
            peaks.insert(std::ranges::find_if(peaks, [&](const Peak& kept) { return kept.value < peak.value; }), peak);
            if (peaks.size() > kPeaksOfAYaw) peaks.pop_back();
            if (peaks.size() == kPeaksOfAYaw) least = peaks.back().value;
        }
    }
    for (Peak& peak : peaks)
        peak.value *= scale;
    return peaks;
}

std::vector<Peak> allPeaks(const std::vector<PlanMark>& map, const std::vector<PlanMark>& reference, const Plan& plan,
                           Progress& progress) {
    PlanImage referenceImage(plan.corner_m, plan.cellSize_m, plan.edge_cells);
    for (const PlanMark& mark : reference)
        referenceImage.add(mark);
    referenceImage.compress();
    referenceImage.blur(kBlur_cells);
    const cv::Mat spectrum = spectrumOf(referenceImage);
    const int yaws = static_cast<int>(std::lround(2.0 * std::numbers::pi / kYawStep_rad));
    std::vector<std::vector<Peak>> peaks(static_cast<std::size_t>(yaws));
    const int half = yaws / 2;
    constexpr int kTogether = 8;
    for (int first = 0; first < half; first += kTogether) {
        progress.report(kStage, static_cast<double>(first) / half);
        tbb::parallel_for(first, std::min(first + kTogether, half), [&](int yaw) {
            const PlanImage image = turnedMap(map, plan, yaw);
            const Correlations found = correlations(spectrum, image);
            // The more the cells hold, the more they agree with by chance.
            const auto scale = static_cast<float>(1.0 / std::max(image.norm(), 1e-9));
            peaks[static_cast<std::size_t>(yaw)] = peaksOf(found.asItIs, plan, 0, yaw, scale);
            // Its first cell has become the last.
            peaks[static_cast<std::size_t>(yaw + half)] =
                peaksOf(found.turned, plan, 2 * plan.mapRadius_cells, yaw + half, scale);
        });
    }
    std::vector<Peak> all;
    for (const std::vector<Peak>& found : peaks)
        all.insert(all.end(), found.begin(), found.end());
    std::ranges::stable_sort(all, [](const Peak& a, const Peak& b) { return a.value > b.value; });
    return all;
}

std::vector<Peak> differentPeaks(const std::vector<Peak>& all, std::size_t count) {
    std::vector<Peak> kept;
    for (const Peak& peak : all) {
        if (kept.size() == count) break;
        const bool known = std::ranges::any_of(kept, [&](const Peak& other) {
            return std::abs(wrapAngle((peak.yaw - other.yaw) * kYawStep_rad)) < kSameYaw_rad &&
                   (peak.shift_m - other.shift_m).norm() < kSamePlace_m;
        });
        if (!known) kept.push_back(peak);
    }
    return kept;
}

/// Heights of level surfaces by the cell of the plan that they lie in.
class HeightsByCell {
  public:
    HeightsByCell(const SurfacePatches& cloud, const Eigen::Matrix3d& levelling, double cellSize_m)
        : cellSize_m_(cellSize_m) {
        for (const SurfacePatch& patch : cloud.all()) {
            if (patch.planarity <= 0.0 || std::abs((levelling * patch.normal).z()) < kLeastLevel) continue;
            const Eigen::Vector3d centre = levelling * patch.centre;
            heights_m_[cellOf(centre.head<2>())].push_back(centre.z());
        }
    }

    /// How far up the map has to go for most of its level surfaces to meet the reference's.
    double bestRise_m(std::span<const Eigen::Vector3d> level_plan) const {
        std::map<long, double> votes;
        for (const Eigen::Vector3d& point : level_plan) {
            const auto cell = heights_m_.find(cellOf(point.head<2>()));
            if (cell == heights_m_.end()) continue;
            for (const double height_m : cell->second)
                votes[std::lround((height_m - point.z()) / kHeightBin_m)] += 1.0;
        }
        const auto votesFor = [&](long bin) {
            const auto found = votes.find(bin);
            return found == votes.end() ? 0.0 : found->second;
        };
        long best = 0;
        double most = 0.0;
        for (const auto& [bin, count] : votes) {
            const double sum = votesFor(bin - 1) + 2.0 * count + votesFor(bin + 1);
            if (sum <= most) continue;
            most = sum;
            best = bin;
        }
        return static_cast<double>(best) * kHeightBin_m;
    }

  private:
    std::pair<long, long> cellOf(const Eigen::Vector2d& place_m) const {
        return {static_cast<long>(std::floor(place_m.x() / cellSize_m_)),
                static_cast<long>(std::floor(place_m.y() / cellSize_m_))};
    }

    double cellSize_m_;
    std::map<std::pair<long, long>, std::vector<double>> heights_m_;
};

std::vector<Eigen::Vector3d> levelPoints(const SurfacePatches& cloud, const Eigen::Matrix3d& levelling) {
    constexpr std::size_t kMost = 4000;
    std::vector<Eigen::Vector3d> points;
    for (const SurfacePatch& patch : cloud.all()) {
        if (patch.planarity > 0.0 && std::abs((levelling * patch.normal).z()) >= kLeastLevel)
            points.push_back(levelling * patch.centre);
    }
    if (points.size() <= kMost) return points;
    std::vector<Eigen::Vector3d> thinned;
    for (std::size_t i = 0; i < kMost; ++i)
        thinned.push_back(points[i * points.size() / kMost]);
    return thinned;
}

/// The motion of the levelled map that a peak stands for, with the height that fits best there.
Transform turnedUp(const Peak& peak, const Plan& plan, std::span<const Eigen::Vector3d> level,
                   const HeightsByCell& heights) {
    // A mark at its turned place q was drawn at (q + radius + half a cell) / cell, one of the reference at
    // (p - corner) / cell; the shift makes them one.
    const Eigen::Vector2d place =
        peak.shift_m + plan.corner_m + Eigen::Vector2d::Constant(plan.mapRadius_m() + plan.cellSize_m / 2.0);
    Transform turn = Transform::Identity();
    turn.linear() = Eigen::AngleAxisd(turnOf(peak.yaw).angle(), Eigen::Vector3d::UnitZ()).toRotationMatrix();
    turn.translation().head<2>() = place - turnOf(peak.yaw) * plan.mapMiddle_m;
    std::vector<Eigen::Vector3d> turned;
    turned.reserve(level.size());
    for (const Eigen::Vector3d& point : level)
        turned.push_back(turn * point);
    turn.translation().z() = heights.bestRise_m(turned);
    return turn;
}

}  // namespace

Eigen::Matrix3d levelling(const SurfacePatches& cloud) {
    // The mean normal of the level surfaces, drawn to where most of them are: sloping plates do not count.
    constexpr double kFirstWidth_rad = 0.30;
    constexpr double kLastWidth_rad = 0.05;
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    for (double width_rad = kFirstWidth_rad; width_rad > kLastWidth_rad; width_rad *= 0.8) {
        const Eigen::Vector3d sum = orderedSum(cloud.size(), zero, [&](std::size_t begin, std::size_t end) {
            Eigen::Vector3d sum = zero;
            for (const SurfacePatch& patch : cloud.all().subspan(begin, end - begin)) {
                const Eigen::Vector3d normal = patch.normal.z() < 0.0 ? Eigen::Vector3d(-patch.normal) : patch.normal;
                const double away = normal.cross(up).norm() / width_rad;
                if (away < 1.0 && normal.dot(up) > 0.0) sum += patch.planarity * (1.0 - away * away) * normal;
            }
            return sum;
        });
        if (!(sum.norm() > 0.0)) break;
        up = sum.normalized();
    }
    return Eigen::Quaterniond::FromTwoVectors(up, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

std::vector<Transform> searchPlan(const SurfacePatches& map, const SurfacePatches& reference, std::size_t count,
                                  Progress& progress) {
    const Eigen::Matrix3d mapLevel = levelling(map);
    const Eigen::Matrix3d referenceLevel = levelling(reference);
    const std::vector<PlanMark> mapMarks = planMarks(map, mapLevel);
    const std::vector<PlanMark> referenceMarks = planMarks(reference, referenceLevel);
    if (mapMarks.empty() || referenceMarks.empty()) return {};
    const Plan plan = planFor(mapMarks, referenceMarks, reference.voxelSize_m());
    const std::vector<Peak> peaks = differentPeaks(allPeaks(mapMarks, referenceMarks, plan, progress), count);

    const HeightsByCell heights(reference, referenceLevel, plan.cellSize_m);
    const std::vector<Eigen::Vector3d> level = levelPoints(map, mapLevel);
    std::vector<Transform> motions(peaks.size());
    tbb::parallel_for(std::size_t{0}, peaks.size(), [&](std::size_t i) {
        progress.throwIfCancelled();
        const Transform turn = turnedUp(peaks[i], plan, level, heights);
        motions[i] = Transform::Identity();
        motions[i].linear() = referenceLevel.transpose() * turn.linear() * mapLevel;
        motions[i].translation() = referenceLevel.transpose() * turn.translation();
    });
    return motions;
}

}  // namespace fodscope
