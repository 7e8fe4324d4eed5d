// SPDX-License-Identifier: MIT
#include "core/simulation/DepthCamera.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/simulation/Random.h"

namespace fodscope {
namespace {

/// What a pixel would show without any error; z = 0 is nothing in range.
struct TruePixel {
    double z_m = 0.0;
    double grazing_cosine = 0.0;
    int object = -1;
    Rgb colour;
};

struct PixelRays {
    int columns, rows;
    double tanX, tanY;

    Eigen::Vector3d at(int column, int row) const {
        return {tanX * (2.0 * (column + 0.5) / columns - 1.0), tanY * (2.0 * (row + 0.5) / rows - 1.0), 1.0};
    }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
    }
};

std::vector<TruePixel> trueImage(const Raycaster& raycaster, const Transform& T_world_from_camera,
                                 const PixelRays& rays, double range_m) {
    std::vector<TruePixel> image(rays.index(0, rays.rows));
    const Eigen::Vector3d origin = T_world_from_camera.translation();
    for (int row = 0; row < rays.rows; ++row) {
        for (int column = 0; column < rays.columns; ++column) {
            const Eigen::Vector3d ray = rays.at(column, row);
            const double length = ray.norm();
            const Eigen::Vector3d direction = T_world_from_camera.linear() * (ray / length);
            // Somewhat past the range: an edge may have its far side there.
            const auto hit = raycaster.cast(origin, direction, 1.2 * range_m * length);
            if (!hit) continue;
            image[rays.index(column, row)] = {hit->distance_m / length, std::abs(hit->normal_world.dot(direction)),
                                              hit->object, hit->colour};
        }
    }
    return image;
}

/// The neighbour across the nearest depth edge, if the pixel lies at one.
const TruePixel* acrossEdge(const std::vector<TruePixel>& image, const PixelRays& rays, int column, int row) {
    constexpr double kEdge = 0.06;
    const TruePixel& here = image[rays.index(column, row)];
    const TruePixel* found = nullptr;
    for (const auto& [dx, dy] : {std::array{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const int x = column + dx, y = row + dy;
        if (x < 0 || y < 0 || x >= rays.columns || y >= rays.rows) continue;
        const TruePixel& other = image[rays.index(x, y)];
        // A floor seen flat also jumps between rows; an edge jumps by more than the slant explains.
        const double slant = 2.0 * rays.tanY / rays.rows / std::max(0.05, here.grazing_cosine);
        if (other.z_m > 0.0 && std::abs(other.z_m - here.z_m) > (kEdge + 2.0 * slant) * here.z_m) found = &other;
    }
    return found;
}

}  // namespace

double inDisparitySteps(double z_m, const DepthMappingSettings& settings) {
    const double scale = settings.disparityFocal_px * settings.disparityBaseline_m;
    if (!(settings.disparityStep_px > 0.0) || !(z_m > 0.0)) return z_m;
    const double steps = std::round(scale / z_m / settings.disparityStep_px);
    return steps >= 1.0 ? scale / (steps * settings.disparityStep_px) : 0.0;
}

std::vector<DepthReturn> depthFrame(const Raycaster& raycaster, const Transform& T_world_from_camera,
                                    const DepthMappingSettings& settings, std::uint64_t frameSeed) {
    const PixelRays rays{settings.columns, settings.rows, std::tan(0.5 * settings.horizontalFieldOfView_rad),
                         std::tan(0.5 * settings.verticalFieldOfView_rad)};
    const std::vector<TruePixel> image = trueImage(raycaster, T_world_from_camera, rays, settings.maximumRange_m);
    const double grazing = std::sin(settings.grazingAngle_rad);
    Random random(frameSeed);
    std::vector<DepthReturn> returns;
    returns.reserve(image.size());
    for (int row = 0; row < rays.rows; ++row) {
        for (int column = 0; column < rays.columns; ++column) {
            const TruePixel& pixel = image[rays.index(column, row)];
            if (!(pixel.z_m > 0.0)) continue;
            double z = pixel.z_m;
            int object = pixel.object;
            if (const TruePixel* other = acrossEdge(image, rays, column, row);
                other && random.uniform() < settings.flyingPixelShare) {
                z += random.uniform() * (other->z_m - z);
                object = -1;
            } else if (pixel.grazing_cosine < grazing && random.uniform() > pixel.grazing_cosine / grazing) {
                continue;
            }
            z += settings.depthNoise_per_m * z * z * random.normal();
            z = inDisparitySteps(z, settings);
            if (z < settings.minimumRange_m || z > settings.maximumRange_m) continue;
            returns.push_back({(z * rays.at(column, row)).cast<float>(), object, pixel.colour});
        }
    }
    return returns;
}

}  // namespace fodscope
