// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace fodscope {

/// What the bytes of a photo are.
struct PhotoCheck {
    /// "image/jpeg" or "image/png" by their signature; empty for anything else.
    std::string mediaType;
    /// Empty for a photo that is whole, else what is wrong with it.
    std::string problem;
    /// Grey levels, of 255, between the darkest and the brightest hundredth of its pixels; 0 for one that is not whole.
    double contrast = 0.0;
};

/// Looks whether a photo came through whole: JPEG or PNG, complete to its end mark, and decodable.
PhotoCheck checkPhoto(std::span<const std::byte> bytes);

}  // namespace fodscope
