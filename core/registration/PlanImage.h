// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>

#include "core/registration/SurfacePatches.h"

namespace fodscope {

/// A piece of an upright surface seen from above.
struct PlanMark {
    Eigen::Vector2d place_m;
    /// Towards twice the angle of its normal in the plan, for that and the opposite are the same; as long as it weighs.
    Eigen::Vector2d doubledNormal = Eigen::Vector2d::Zero();
};

/// The upright surfaces of a levelled cloud, seen from above.
std::vector<PlanMark> planMarks(const SurfacePatches& cloud, const Eigen::Matrix3d& levelling);

/// A plan as a picture whose cells hold the doubled directions of the walls as complex numbers, so that the real part
/// of a product is 1 for walls of one direction and -1 for walls across. The corner is the place of cell (0, 0).
class PlanImage {
  public:
    /// @param edge_cells edge of the square picture
    PlanImage(const Eigen::Vector2d& corner_m, double cellSize_m, int edge_cells);

    void add(const PlanMark& mark);
    /// High walls are not more true than low ones: a cell grows with the root of what it holds.
    void compress();
    void blur(double cells);
    double norm() const;
    const cv::Mat& cells() const { return cells_; }

  private:
    Eigen::Vector2d corner_m_;
    double cellSize_m_;
    cv::Mat cells_;
};

/// @return spectrum of a picture
cv::Mat spectrumOf(const PlanImage& image);

/// Pictures whose cells (dy, dx) hold how a map shifted by (dx, dy) cells agrees with the reference; shifts wrap round.
struct Correlations {
    cv::Mat asItIs;
    /// Of the map turned half round: its cell (0, 0), seen from the corner that is then the last, comes to the shift.
    cv::Mat turned;
};

/// Both at once, for the time of one: turning half round conjugates a spectrum, and the two real pictures come back as
/// the parts of one complex picture.
Correlations correlations(const cv::Mat& referenceSpectrum, const PlanImage& map);

}  // namespace fodscope
