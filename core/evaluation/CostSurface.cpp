// SPDX-License-Identifier: MIT
#include "core/evaluation/CostSurface.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/common/Error.h"
#include "core/evaluation/Numpy.h"

namespace fodscope {
namespace {

// Layout in pixels.
constexpr int kPlotWidth = 640;
constexpr int kPlotHeight = 600;
constexpr int kLeft = 90;
constexpr int kTop = 60;
constexpr int kBottom = 80;
constexpr int kBarGap = 30;
constexpr int kBarWidth = 24;
constexpr int kRight = 130;
const cv::Scalar kInk(40, 40, 40);
const cv::Scalar kPaper(255, 255, 255);

std::string shortest(double number) {
    char text[64];
    return std::string(text, std::to_chars(text, text + sizeof text, number).ptr);
}

std::string tickText(double number) {
    char text[64];
    std::snprintf(text, sizeof text, "%.3g", number);
    return text;
}

void write(cv::Mat& image, const std::string& text, cv::Point at, double scale = 0.5) {
    cv::putText(image, text, at, cv::FONT_HERSHEY_SIMPLEX, scale, kInk, 1, cv::LINE_AA);
}

int widthOf(const std::string& text, double scale = 0.5) {
    int baseline = 0;
    return cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, scale, 1, &baseline).width;
}

/// The plot's cells: costs at the best least points, cutoffs upwards.
class CostPlot {
  public:
    explicit CostPlot(const ParameterSearchResult& result)
        : result_(result),
          image_(kTop + kPlotHeight + kBottom, kLeft + kPlotWidth + kBarGap + kBarWidth + kRight, CV_8UC3, kPaper) {
        std::vector<double> costs;
        for (std::size_t c = 0; c < result.cutoffs_m.size(); ++c)
            for (std::size_t t = 0; t < result.thresholds.size(); ++t)
                costs.push_back(costAt(c, t));
        // A cost of 0 has no logarithm.
        low_ = std::max(*std::ranges::min_element(costs), 1e-6);
        high_ = std::max(percentileOfKnown(costs, 90.0).value_or(low_), low_);
    }

    cv::Mat draw() {
        drawCells();
        drawAxes();
        drawBar();
        drawBest();
        return image_;
    }

  private:
    double costAt(std::size_t cutoff, std::size_t threshold) const {
        return result_.at({cutoff, threshold, result_.best.leastPoints}).cost;
    }

    cv::Vec3b colourOf(double share) const {
        const cv::Mat grey(1, 1, CV_8UC1, cv::Scalar(255.0 * std::clamp(share, 0.0, 1.0)));
        cv::Mat colour;
        cv::applyColorMap(grey, colour, cv::COLORMAP_VIRIDIS);
        return colour.at<cv::Vec3b>(0, 0);
    }

    /// By the logarithm, since the costs near the best one differ little and those far away a lot.
    double shareOf(double cost) const { return high_ > low_ ? std::log(cost / low_) / std::log(high_ / low_) : 0.0; }

    cv::Rect cell(std::size_t cutoff, std::size_t threshold) const {
        const auto column = [&](std::size_t i) {
            return kLeft + static_cast<int>(i * kPlotWidth / result_.thresholds.size());
        };
        const auto row = [&](std::size_t i) {
            return kTop + kPlotHeight - static_cast<int>(i * kPlotHeight / result_.cutoffs_m.size());
        };
        return {cv::Point(column(threshold), row(cutoff + 1)), cv::Point(column(threshold + 1), row(cutoff))};
    }

    void drawCells() {
        for (std::size_t c = 0; c < result_.cutoffs_m.size(); ++c)
            for (std::size_t t = 0; t < result_.thresholds.size(); ++t)
                image_(cell(c, t)).setTo(colourOf(shareOf(costAt(c, t))));
        cv::rectangle(image_, cv::Rect(kLeft, kTop, kPlotWidth, kPlotHeight), kInk, 1);
    }

    void drawAxes() {
        const std::string title = "Mean cost [m] over " + std::to_string(result_.trialCount) +
                                  " trials, least points " +
                                  std::to_string(result_.leastPoints[result_.best.leastPoints]);
        write(image_, title, {kLeft, 24}, 0.6);
        const std::size_t columns = result_.thresholds.size();
        for (std::size_t t = 0; t < columns; t += std::max<std::size_t>(1, columns / 6)) {
            const cv::Rect at = cell(0, t);
            const std::string text = tickText(result_.thresholds[t]);
            write(image_, text, {at.x + at.width / 2 - widthOf(text) / 2, kTop + kPlotHeight + 24});
        }
        const std::size_t rows = result_.cutoffs_m.size();
        for (std::size_t c = 0; c < rows; c += std::max<std::size_t>(1, rows / 8)) {
            const cv::Rect at = cell(c, 0);
            const std::string text = tickText(result_.cutoffs_m[c]);
            write(image_, text, {kLeft - 10 - widthOf(text), at.y + at.height / 2 + 5});
        }
        const std::string threshold = result_.settings.metric == Metric::Euclidean ? "threshold [m]" : "threshold";
        write(image_, threshold, {kLeft + kPlotWidth / 2 - widthOf(threshold) / 2, kTop + kPlotHeight + 56});
        write(image_, "cutoff [m]", {8, kTop - 10});
    }

    void drawBar() {
        const int left = kLeft + kPlotWidth + kBarGap;
        for (int y = 0; y < kPlotHeight; ++y) {
            const double share = 1.0 - static_cast<double>(y) / (kPlotHeight - 1);
            image_(cv::Rect(left, kTop + y, kBarWidth, 1)).setTo(colourOf(share));
        }
        constexpr int kTicks = 5;
        for (int i = 0; i <= kTicks; ++i) {
            const double share = static_cast<double>(i) / kTicks;
            const std::string text = tickText(low_ * std::pow(high_ / low_, share)) + (i == kTicks ? " and more" : "");
            write(image_, text, {left + kBarWidth + 6, kTop + static_cast<int>((1.0 - share) * kPlotHeight) + 5}, 0.45);
        }
    }

    void drawBest() {
        const cv::Rect at = cell(result_.best.cutoff, result_.best.threshold);
        const cv::Point centre(at.x + at.width / 2, at.y + at.height / 2);
        const int radius = std::max(8, std::min(at.width, at.height));
        cv::circle(image_, centre, radius, kPaper, 4, cv::LINE_AA);
        cv::circle(image_, centre, radius, cv::Scalar(30, 30, 220), 2, cv::LINE_AA);
    }

    const ParameterSearchResult& result_;
    cv::Mat image_;
    double low_ = 0.0;
    double high_ = 0.0;
};

}  // namespace

std::string costSurfaceCsv(const ParameterSearchResult& result) {
    std::string text = "cluster_cutoff_m,threshold,least_points,cost,distance_m,unassociated_candidates,candidates\n";
    for (std::size_t c = 0; c < result.cutoffs_m.size(); ++c) {
        for (std::size_t t = 0; t < result.thresholds.size(); ++t) {
            for (std::size_t l = 0; l < result.leastPoints.size(); ++l) {
                const SearchCost& cost = result.at({c, t, l});
                text += shortest(result.cutoffs_m[c]) + "," + shortest(result.thresholds[t]) + "," +
                        std::to_string(result.leastPoints[l]) + "," + shortest(cost.cost) + "," +
                        shortest(cost.distance_m) + "," + shortest(cost.unassociatedCandidates) + "," +
                        shortest(cost.candidates) + "\n";
            }
        }
    }
    return text;
}

std::vector<std::byte> costSurfacePng(const ParameterSearchResult& result) {
    std::vector<std::uint8_t> encoded;
    if (!cv::imencode(".png", CostPlot(result).draw(), encoded))
        throw Error("cost surface", "cannot be made a PNG", "use the CSV instead");
    std::vector<std::byte> bytes(encoded.size());
    std::memcpy(bytes.data(), encoded.data(), encoded.size());
    return bytes;
}

}  // namespace fodscope
