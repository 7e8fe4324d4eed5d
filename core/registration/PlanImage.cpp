// SPDX-License-Identifier: MIT
#include "core/registration/PlanImage.h"

#include <cmath>
#include <complex>
#include <opencv2/imgproc.hpp>

namespace fodscope {
namespace {

/// Normals of upright surfaces rise by less than 30°.
constexpr double kMostRise = 0.5;

/// Without the standard's care for infinities.
std::complex<float> times(std::complex<float> a, std::complex<float> b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

}  // namespace

std::vector<PlanMark> planMarks(const SurfacePatches& cloud, const Eigen::Matrix3d& levelling) {
    std::vector<PlanMark> marks;
    for (const SurfacePatch& patch : cloud.all()) {
        const Eigen::Vector3d normal = levelling * patch.normal;
        if (patch.planarity <= 0.0 || std::abs(normal.z()) > kMostRise) continue;
        const Eigen::Vector3d centre = levelling * patch.centre;
        const Eigen::Vector2d across(normal.x() * normal.x() - normal.y() * normal.y(), 2.0 * normal.x() * normal.y());
        marks.push_back({centre.head<2>(), across * (patch.planarity / across.norm())});
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
    value[0] += static_cast<float>(mark.doubledNormal.x());
    value[1] += static_cast<float>(mark.doubledNormal.y());
}

void PlanImage::compress() {
    cells_.forEach<cv::Vec2f>([](cv::Vec2f& value, const int*) {
        const float size = std::sqrt(value[0] * value[0] + value[1] * value[1]);
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

Correlations correlations(const cv::Mat& referenceSpectrum, const PlanImage& map) {
    using Complex = std::complex<float>;
    const cv::Mat mapSpectrum = spectrumOf(map);
    const int rows = mapSpectrum.rows;
    const int columns = mapSpectrum.cols;
    cv::Mat both(mapSpectrum.size(), mapSpectrum.type());
    for (int y = 0; y < rows; ++y) {
        const int oppositeY = y == 0 ? 0 : rows - y;
        const auto* reference = referenceSpectrum.ptr<Complex>(y);
        const auto* referenceOpposite = referenceSpectrum.ptr<Complex>(oppositeY);
        const auto* at = mapSpectrum.ptr<Complex>(y);
        const auto* atOpposite = mapSpectrum.ptr<Complex>(oppositeY);
        auto* result = both.ptr<Complex>(y);
        for (int x = 0; x < columns; ++x) {
            const int oppositeX = x == 0 ? 0 : columns - x;
            const Complex here = reference[x];
            const Complex there = std::conj(referenceOpposite[oppositeX]);
            // The spectra of the real parts: what is conjugate to its opposite.
            const Complex asItIs = times(here, std::conj(at[x])) + times(there, atOpposite[oppositeX]);
            const Complex turned = times(here, std::conj(atOpposite[oppositeX])) + times(there, at[x]);
            result[x] = 0.5F * Complex(asItIs.real() - turned.imag(), asItIs.imag() + turned.real());
        }
    }
    cv::idft(both, both, cv::DFT_COMPLEX_OUTPUT | cv::DFT_SCALE);
    Correlations found;
    cv::extractChannel(both, found.asItIs, 0);
    cv::extractChannel(both, found.turned, 1);
    return found;
}

}  // namespace fodscope
