// SPDX-License-Identifier: MIT
#include "core/registration/PlanImage.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace fodscope {
namespace {

/// Normals of upright surfaces rise by less than 30°.
constexpr double kMostRise = 0.5;

}  // namespace

std::vector<PlanMark> planMarks(const SurfacePatches& cloud, const Eigen::Matrix3d& levelling) {
    std::vector<PlanMark> marks;
    for (const SurfacePatch& patch : cloud.all()) {
        const Eigen::Vector3d normal = levelling * patch.normal;
        if (patch.planarity <= 0.0 || std::abs(normal.z()) > kMostRise) continue;
        const Eigen::Vector3d centre = levelling * patch.centre;
        marks.push_back({centre.head<2>(), std::atan2(normal.y(), normal.x()), patch.planarity});
    }
    return marks;
}

PlanImage::PlanImage(const Eigen::Vector2d& corner_m, double cellSize_m, int edge_cells)
    : corner_m_(corner_m), cellSize_m_(cellSize_m), cells_(cv::Mat::zeros(edge_cells, edge_cells, CV_32FC2)) {}

void PlanImage::add(const PlanMark& mark) {
    const Eigen::Vector2d cell = (mark.place_m - corner_m_) / cellSize_m_;
    const int x = static_cast<int>(std::floor(cell.x()));
    const int y = static_cast<int>(std::floor(cell.y()));
    if (x < 0 || y < 0 || x >= cells_.cols || y >= cells_.rows) return;
    auto& value = cells_.at<cv::Vec2f>(y, x);
    value[0] += static_cast<float>(mark.weight * std::cos(2.0 * mark.angle_rad));
    value[1] += static_cast<float>(mark.weight * std::sin(2.0 * mark.angle_rad));
}

void PlanImage::compress() {
    cells_.forEach<cv::Vec2f>([](cv::Vec2f& value, const int*) {
        const float size = std::hypot(value[0], value[1]);
        if (size > 0.0F) value *= 1.0F / std::sqrt(size);
    });
}

void PlanImage::blur(double cells) {
    cv::GaussianBlur(cells_, cells_, cv::Size(0, 0), cells, cells, cv::BORDER_CONSTANT);
}

double PlanImage::norm() const {
    return cv::norm(cells_);
}

cv::Mat spectrumOf(const PlanImage& image) {
    cv::Mat spectrum;
    cv::dft(image.cells(), spectrum, cv::DFT_COMPLEX_INPUT);
    return spectrum;
}

cv::Mat correlation(const cv::Mat& referenceSpectrum, const PlanImage& map) {
    cv::Mat product;
    cv::mulSpectrums(referenceSpectrum, spectrumOf(map), product, 0, true);
    cv::Mat result;
    cv::idft(product, result, cv::DFT_COMPLEX_OUTPUT | cv::DFT_SCALE);
    cv::Mat real;
    cv::extractChannel(result, real, 0);
    return real;
}

}  // namespace fodscope
