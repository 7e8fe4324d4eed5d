// SPDX-License-Identifier: MIT
#include "core/simulation/PhotoCamera.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "core/common/Error.h"
#include "core/simulation/Random.h"
#include "core/simulation/RustyPaint.h"

namespace fodscope {
namespace {

constexpr double kRange_m = 12.0;
/// Two lamps beside and over the lens, as on the paper's robot.
const std::array<Eigen::Vector3d, 2> kLamps_camera{Eigen::Vector3d(-0.07, -0.06, 0.0),
                                                   Eigen::Vector3d(0.07, -0.06, 0.0)};
constexpr float kLampSpread_rad = 0.56f;
/// Light that comes back from all the walls.
constexpr float kAmbient = 0.012f;
/// The lamps are no points: their light does not grow without bound close by.
constexpr float kLampSize_m2 = 0.01f;

/// One ray's answer: linear light and what was hit, to find the edges by.
struct Sample {
    Eigen::Vector3f light = Eigen::Vector3f::Zero();
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();
    float distance_m = 0.0f;
    int object = -2;
};

class Shader {
  public:
    Shader(const Raycaster& raycaster, const Transform& T_world_from_camera, const CameraIntrinsics& intrinsics)
        : raycaster_(raycaster), T_world_from_camera_(T_world_from_camera), intrinsics_(intrinsics) {
        for (std::size_t i = 0; i < lamps_world_.size(); ++i)
            lamps_world_[i] = T_world_from_camera * kLamps_camera[i];
    }

    Sample sample(double column_px, double row_px) const {
        const Eigen::Vector3d ray_camera((column_px - intrinsics_.cx_px) / intrinsics_.fx_px,
                                         (row_px - intrinsics_.cy_px) / intrinsics_.fy_px, 1.0);
        const Eigen::Vector3d direction = T_world_from_camera_.linear() * ray_camera.normalized();
        const Eigen::Vector3d origin = T_world_from_camera_.translation();
        Sample result;
        const std::optional<RayHit> hit = raycaster_.cast(origin, direction, kRange_m);
        if (!hit) return result;
        const Eigen::Vector3d point = origin + hit->distance_m * direction;
        result.normal = hit->normal_world.cast<float>();
        result.distance_m = static_cast<float>(hit->distance_m);
        result.object = hit->object;
        const Finish finish =
            hit->object < 0 ? rustyPaint(point.cast<float>(), result.normal, hit->colour) : cleanFinish(hit->colour);
        result.light = kAmbient * finish.reflectance;
        for (const Eigen::Vector3d& lamp : lamps_world_)
            result.light += lampLight(lamp, point, result.normal, direction, finish);
        return result;
    }

  private:
    Eigen::Vector3f lampLight(const Eigen::Vector3d& lamp, const Eigen::Vector3d& point, const Eigen::Vector3f& normal,
                              const Eigen::Vector3d& direction, const Finish& finish) const {
        const Eigen::Vector3d toLamp = lamp - point;
        const double distance = toLamp.norm();
        const Eigen::Vector3f towards = (toLamp / distance).cast<float>();
        const float facing = towards.dot(normal);
        if (facing <= 0.0f) return Eigen::Vector3f::Zero();
        const Eigen::Vector3d start = point + 0.0015 * normal.cast<double>();
        if (raycaster_.blocked(start, lamp)) return Eigen::Vector3f::Zero();
        const float off = std::acos(
            std::clamp(static_cast<float>(-T_world_from_camera_.linear().col(2).dot(toLamp) / distance), -1.0f, 1.0f));
        const float beam = std::exp(-(off / kLampSpread_rad) * (off / kLampSpread_rad));
        const auto squared = static_cast<float>(distance * distance);
        const float strength = 0.5f * beam / (squared + kLampSize_m2);
        const Eigen::Vector3f half = (towards - direction.cast<float>()).normalized();
        const float shine = finish.shine * std::pow(std::max(0.0f, half.dot(normal)), finish.gloss);
        return strength * (facing * finish.reflectance + Eigen::Vector3f::Constant(shine));
    }

    const Raycaster& raycaster_;
    Transform T_world_from_camera_;
    CameraIntrinsics intrinsics_;
    std::array<Eigen::Vector3d, 2> lamps_world_;
};

bool isEdge(const Sample& a, const Sample& b) {
    if (a.object != b.object) return true;
    return std::abs(a.distance_m - b.distance_m) > 0.03f * std::min(a.distance_m, b.distance_m) ||
           a.normal.dot(b.normal) < 0.85f;
}

/// One ray a pixel, and four more where neighbours differ, so that outlines are smooth.
std::vector<Eigen::Vector3f> renderLight(const Shader& shader, int width, int height, const Progress& progress) {
    const auto index = [width](int column, int row) {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
    };
    std::vector<Sample> samples(index(0, height));
    tbb::parallel_for(tbb::blocked_range<int>(0, height, 8), [&](const tbb::blocked_range<int>& rows) {
        for (int row = rows.begin(); row < rows.end(); ++row) {
            progress.throwIfCancelled();
            for (int column = 0; column < width; ++column)
                samples[index(column, row)] = shader.sample(column + 0.5, row + 0.5);
        }
    });
    std::vector<Eigen::Vector3f> light(samples.size());
    constexpr std::array<std::array<double, 2>, 4> kOffsets{
        {{0.125, 0.375}, {0.375, 0.875}, {0.625, 0.125}, {0.875, 0.625}}};
    tbb::parallel_for(tbb::blocked_range<int>(0, height, 8), [&](const tbb::blocked_range<int>& rows) {
        for (int row = rows.begin(); row < rows.end(); ++row) {
            progress.throwIfCancelled();
            for (int column = 0; column < width; ++column) {
                const Sample& here = samples[index(column, row)];
                Eigen::Vector3f sum = here.light;
                const bool edge = (column > 0 && isEdge(here, samples[index(column - 1, row)])) ||
                                  (column + 1 < width && isEdge(here, samples[index(column + 1, row)])) ||
                                  (row > 0 && isEdge(here, samples[index(column, row - 1)])) ||
                                  (row + 1 < height && isEdge(here, samples[index(column, row + 1)]));
                if (edge) {
                    for (const auto& offset : kOffsets)
                        sum += shader.sample(column + offset[0], row + offset[1]).light;
                    sum /= 5.0f;
                }
                light[index(column, row)] = sum;
            }
        }
    });
    return light;
}

float luminance(const Eigen::Vector3f& light) {
    return 0.2126f * light.x() + 0.7152f * light.y() + 0.0722f * light.z();
}

/// Exposure by percentile: the bright end of the picture's middle comes out light but not white. The middle is
/// metered, since that is where the candidate is.
float exposureOf(const std::vector<Eigen::Vector3f>& light, int width, int height) {
    std::vector<float> metered;
    for (int row = height / 4; row < height * 9 / 10; row += 4)
        for (int column = width / 5; column < width * 4 / 5; column += 4)
            metered.push_back(luminance(light[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                              static_cast<std::size_t>(column)]));
    if (metered.empty()) return 1.0f;
    const auto at = metered.begin() + static_cast<std::ptrdiff_t>(metered.size() * 80 / 100);
    std::nth_element(metered.begin(), at, metered.end());
    // In the dark nothing but the lamps shines: the gain has an end.
    return std::min(0.34f / std::max(*at, 1e-6f), 60.0f);
}

/// Rises like light at first and bends towards white, so that highlights keep some colour.
float toneCurve(float value) {
    constexpr float kWhite = 2.5f;
    return value * (1.0f + value / (kWhite * kWhite)) / (1.0f + value);
}

cv::Mat develop(const std::vector<Eigen::Vector3f>& light, int width, int height, std::uint64_t seed) {
    const float exposure = exposureOf(light, width, height);
    const float scale = 1.15f / toneCurve(2.5f);
    cv::Mat image(height, width, CV_8UC3);
    tbb::parallel_for(tbb::blocked_range<int>(0, height, 8), [&](const tbb::blocked_range<int>& rows) {
        for (int row = rows.begin(); row < rows.end(); ++row) {
            Random random(streamSeed(seed, static_cast<std::uint64_t>(row)));
            for (int column = 0; column < width; ++column) {
                const float x = (static_cast<float>(column) + 0.5f) / static_cast<float>(width) - 0.5f;
                const float y = (static_cast<float>(row) + 0.5f) / static_cast<float>(height) - 0.5f;
                const float vignette = 1.0f - 0.45f * (x * x + y * y);
                const Eigen::Vector3f value = exposure * vignette *
                                              light[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                                    static_cast<std::size_t>(column)];
                cv::Vec3b& pixel = image.at<cv::Vec3b>(row, column);
                for (int channel = 0; channel < 3; ++channel) {
                    // Photon noise grows with the root of the light; the read noise is what darkness shows.
                    const float level = std::max(0.0f, value[channel]);
                    const float noisy =
                        level + (0.004f + 0.012f * std::sqrt(level)) *
                                    static_cast<float>(random.uniform(-1.0, 1.0) + random.uniform(-1.0, 1.0));
                    const float shown = srgbFromLinear(scale * toneCurve(std::max(0.0f, noisy)));
                    pixel[2 - channel] = static_cast<std::uint8_t>(std::lround(255.0f * shown));
                }
            }
        }
    });
    return image;
}

void requireImage(const CameraIntrinsics& intrinsics) {
    constexpr int kMost_px = 16384;
    if (intrinsics.width_px < 1 || intrinsics.height_px < 1 || intrinsics.width_px > kMost_px ||
        intrinsics.height_px > kMost_px || !(intrinsics.fx_px > 0.0) || !(intrinsics.fy_px > 0.0))
        throw Error("photo camera", "the image size or field of view is out of range",
                    "set 1 to 16384 pixels and a field of view between 0 and 180 degrees");
}

}  // namespace

std::vector<std::byte> renderPhoto(const World&, const Raycaster& raycaster, const Transform& T_world_from_camera,
                                   const PhotoCameraSettings& settings, const Progress& progress) {
    const CameraIntrinsics intrinsics = intrinsicsOf(settings);
    requireImage(intrinsics);
    const Shader shader(raycaster, T_world_from_camera, intrinsics);
    const std::vector<Eigen::Vector3f> light = renderLight(shader, settings.width_px, settings.height_px, progress);
    progress.throwIfCancelled();
    const cv::Mat image = develop(light, settings.width_px, settings.height_px, settings.seed);
    progress.throwIfCancelled();
    std::vector<unsigned char> jpeg;
    if (!cv::imencode(".jpg", image, jpeg, {cv::IMWRITE_JPEG_QUALITY, 92}))
        throw Error("photo camera", "the image could not be written as JPEG", "install OpenCV with JPEG support");
    std::vector<std::byte> bytes(jpeg.size());
    std::transform(jpeg.begin(), jpeg.end(), bytes.begin(), [](unsigned char b) { return std::byte{b}; });
    return bytes;
}

}  // namespace fodscope
