// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "core/common/Error.h"
#include "core/common/Files.h"
#include "core/planning/OccupancyGrid.h"
#include "tests/fakes/PictureGrid.h"

namespace fodscope {
namespace {

class MapServerGrid : public testing::Test {
  protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() / (std::string("fodscope-grid-") + test->name());
        std::filesystem::remove_all(folder_);
        makeFolder(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path write(const std::string& name, const std::string& text) const {
        writeFile(folder_ / name, text);
        return folder_ / name;
    }

    /// A YAML file as map_server writes it, with lines replaced or added.
    std::filesystem::path writeYaml(const std::string& image, const std::string& rest = kRest) const {
        return write("map.yaml", "image: " + image + "\n" + rest);
    }

    /// One row of grey pixels as PGM.
    void writePgm(const std::vector<int>& pixels) const {
        std::string text = "P5\n# made by a test\n" + std::to_string(pixels.size()) + " 1\n255\n";
        for (const int pixel : pixels)
            text += static_cast<char>(pixel);
        write("map.pgm", text);
    }

    std::string errorOf(const std::filesystem::path& yaml) const {
        try {
            readMapServerGrid(yaml);
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    }

    static inline const std::string kRest =
        "resolution: 0.05\norigin: [-0.8, 0.4, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
    std::filesystem::path folder_;
};

constexpr Cell F = Cell::Free;
constexpr Cell O = Cell::Occupied;
constexpr Cell U = Cell::Unknown;

TEST_F(MapServerGrid, whatIsWrittenIsReadBack) {
    const OccupancyGrid grid = pictureGrid({"#..?", "#.#?", "####"}, 0.05, {-1.5, 0.1, 0.3});
    writeMapServerGrid(folder_ / "out.yaml", grid);
    const OccupancyGrid back = readMapServerGrid(folder_ / "out.yaml");
    EXPECT_EQ(back.cells, grid.cells);
    EXPECT_EQ(back.width, 4);
    EXPECT_EQ(back.height, 3);
    EXPECT_EQ(back.resolution_m, 0.05);
    EXPECT_EQ(back.origin_map, grid.origin_map);
}

TEST_F(MapServerGrid, trinaryFollowsTheThresholds) {
    writePgm({254, 205, 206, 204, 0, 90, 89, 88});
    const OccupancyGrid grid = readMapServerGrid(writeYaml("map.pgm"));
    // Darkness over 0.65 (pixels under 89.25) is occupied, under 0.196 (pixels over 205.02) free.
    EXPECT_EQ(grid.cells, (std::vector<Cell>{F, U, F, U, O, U, O, O}));
    EXPECT_EQ(grid.origin_map, (Pose2{-0.8, 0.4, 0.0}));
}

TEST_F(MapServerGrid, negateTurnsBlackAndWhiteRound) {
    writePgm({254, 50, 0});
    std::string rest = kRest;
    rest.replace(rest.find("negate: 0"), 9, "negate: 1");
    EXPECT_EQ(readMapServerGrid(writeYaml("map.pgm", rest)).cells, (std::vector<Cell>{O, U, F}));
}

TEST_F(MapServerGrid, scaleKeepsTheMiddleUnknown) {
    writePgm({254, 150, 0});
    EXPECT_EQ(readMapServerGrid(writeYaml("map.pgm", kRest + "mode: scale\n")).cells, (std::vector<Cell>{F, U, O}));
}

TEST_F(MapServerGrid, rawPixelsArePercent) {
    writePgm({0, 19, 50, 66, 100, 101, 255});
    EXPECT_EQ(readMapServerGrid(writeYaml("map.pgm", kRest + "mode: raw\n")).cells,
              (std::vector<Cell>{F, F, U, O, O, U, U}));
}

TEST_F(MapServerGrid, readsColourPngWithTransparency) {
    cv::Mat image(2, 2, CV_8UC4, cv::Scalar(255, 255, 255, 255));
    image.at<cv::Vec4b>(0, 1) = {0, 0, 0, 0};          // upper right
    image.at<cv::Vec4b>(1, 0) = {150, 150, 150, 255};  // lower left
    cv::imwrite((folder_ / "map.png").string(), image);
    EXPECT_EQ(readMapServerGrid(writeYaml("map.png", kRest + "mode: scale\n")).cells, (std::vector<Cell>{U, F, F, O}));
}

TEST_F(MapServerGrid, namesTheMissingKey) {
    writePgm({0});
    for (const std::string key : {"image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"}) {
        std::string text = "image: map.pgm\n" + kRest;
        const auto at = text.find(key + ":");
        text.erase(at, text.find('\n', at) - at);
        EXPECT_THAT(errorOf(write("map.yaml", text)), testing::HasSubstr("'" + key + "'"));
    }
}

TEST_F(MapServerGrid, refusesBrokenHeaders) {
    writePgm({0});
    EXPECT_THAT(errorOf(folder_ / "absent.yaml"), testing::HasSubstr("no such file"));
    for (const std::string text : {"", "- a\n- b\n", "image: [", "just words", "\x01\x02"}) {
        EXPECT_NE(errorOf(write("map.yaml", text)), "no error") << text;
    }
    for (const auto& [from, to] :
         std::vector<std::pair<std::string, std::string>>{{"resolution: 0.05", "resolution: 0"},
                                                          {"resolution: 0.05", "resolution: -1"},
                                                          {"resolution: 0.05", "resolution: .nan"},
                                                          {"resolution: 0.05", "resolution: wide"},
                                                          {"origin: [-0.8, 0.4, 0.0]", "origin: [1, 2]"},
                                                          {"origin: [-0.8, 0.4, 0.0]", "origin: [1, 2, .inf]"},
                                                          {"negate: 0", "negate: 7"},
                                                          {"occupied_thresh: 0.65", "occupied_thresh: 65"},
                                                          {"free_thresh: 0.196", "free_thresh: 0.9"},
                                                          {"negate: 0", "negate: 0\nmode: sepia"}}) {
        std::string text = kRest;
        text.replace(text.find(from), from.size(), to);
        EXPECT_NE(errorOf(writeYaml("map.pgm", text)), "no error") << to;
    }
}

TEST_F(MapServerGrid, refusesBrokenImages) {
    EXPECT_THAT(errorOf(writeYaml("absent.pgm")), testing::HasSubstr("absent.pgm: no such file"));
    const std::string huge = "P5\n100000 100000\n255\n";
    for (const std::string& bytes :
         {std::string(), std::string("P5"), std::string("P5\n#"), std::string("P5\n0 0\n255\n"),
          std::string("P5\n4 4\n255\nabc"), std::string("GIF89a-and-more-bytes"), huge,
          std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1", 24)}) {
        write("map.pgm", bytes);
        EXPECT_THAT(errorOf(writeYaml("map.pgm")), testing::HasSubstr("map.pgm: ")) << bytes;
    }
    write("map.pgm", huge);
    EXPECT_THAT(errorOf(writeYaml("map.pgm")), testing::HasSubstr("25 million"));
}

}  // namespace
}  // namespace fodscope
