// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "core/cloud/PointCloud.h"

namespace fodscope {

/// How a point of a surface answers light: reflectance in linear RGB 0…1, and how much of it is a shine.
struct Finish {
    Eigen::Vector3f reflectance = Eigen::Vector3f::Zero();
    float shine = 0.0f;
    /// Blinn-Phong exponent.
    float gloss = 1.0f;
};

/// sRGB bytes to linear light.
Eigen::Vector3f linearFromSrgb(Rgb colour);
/// Linear light 0…1 to an sRGB value 0…1.
float srgbFromLinear(float value);

/// Old paint on the tank's structure: stained, with rust patches and streaks that are fixed in the world. Dark paint
/// (rubber, plastic) does not rust.
Finish rustyPaint(const Eigen::Vector3f& point_world, const Eigen::Vector3f& normal_world, Rgb paint);

/// An object in its own colour.
Finish cleanFinish(Rgb colour);

}  // namespace fodscope
