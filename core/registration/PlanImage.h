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
    /// Direction of its normal in the plan; that and the opposite are the same.
    double angle_rad = 0.0;
    double weight = 0.0;
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

/// @return at (dy, dx) the agreement of `map` shifted by (dx, dy) cells with the reference; shifts wrap round
cv::Mat correlation(const cv::Mat& referenceSpectrum, const PlanImage& map);

}  // namespace fodscope
