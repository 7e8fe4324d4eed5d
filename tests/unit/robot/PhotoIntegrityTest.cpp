// SPDX-License-Identifier: MIT
#include "core/robot/PhotoIntegrity.h"

#include <gtest/gtest.h>

#include "tests/fakes/ScriptedRobotLink.h"

namespace fodscope {
namespace {

TEST(PhotoIntegrity, wholePhotosPass) {
    EXPECT_EQ(checkPhoto(photoBytes(".jpg")).problem, "");
    EXPECT_EQ(checkPhoto(photoBytes(".jpg")).mediaType, "image/jpeg");
    EXPECT_EQ(checkPhoto(photoBytes(".png")).problem, "");
    EXPECT_EQ(checkPhoto(photoBytes(".png")).mediaType, "image/png");
    auto padded = photoBytes();
    padded.resize(padded.size() + 500);
    EXPECT_EQ(checkPhoto(padded).problem, "");
}

TEST(PhotoIntegrity, brokenPhotosAreNamed) {
    EXPECT_EQ(checkPhoto({}).problem, "it has no bytes");
    const std::vector<std::byte> zeros(100);
    EXPECT_EQ(checkPhoto(zeros).problem, "it is neither a JPEG nor a PNG image");
    for (const std::string extension : {".jpg", ".png"}) {
        const auto whole = photoBytes(extension);
        for (std::size_t length = 8; length + 8 < whole.size(); length += 7) {
            EXPECT_NE(checkPhoto(std::span(whole).first(length)).problem, "") << extension << " of " << length;
        }
    }
    auto holed = photoBytes();
    std::fill(holed.begin() + 10, holed.end() - 10, std::byte{0});
    EXPECT_EQ(checkPhoto(holed).problem, "it cannot be decoded");
    auto huge = photoBytes(".png");
    huge[16] = huge[20] = std::byte{0x7f};
    EXPECT_EQ(checkPhoto(huge).problem, "it has too many pixels");
}

}  // namespace
}  // namespace fodscope
