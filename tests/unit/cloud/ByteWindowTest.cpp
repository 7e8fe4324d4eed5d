// SPDX-License-Identifier: MIT
#include "core/cloud/ByteWindow.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "core/cloud/PointCloudIo.h"
#include "core/cloud/TextScanner.h"
#include "core/common/Error.h"
#include "tests/unit/cloud/ExpectError.h"
#include "tests/unit/cloud/RandomPoints.h"
#include "tests/unit/cloud/TemporaryFolder.h"

namespace fodscope {
namespace {

std::string numbered(int count) {
    std::string text;
    for (int i = 0; i < count; ++i)
        text += std::to_string(i) + (i % 7 == 0 ? "\r\n" : "  ");
    return text;
}

TEST(ByteWindow, GivesTheBytesOfAFileInWindowsOfAnySize) {
    const TemporaryFolder folder;
    const std::string text = numbered(500);
    const auto file = folder.write("a.txt", text);
    for (const std::size_t piece : {1u, 3u, 64u, 100'000u}) {
        ByteWindow window(InputFile(file), {}, piece);
        std::string again;
        for (std::size_t step = 0; window.remaining() > 0; step = (step + 1) % 9) {
            const std::span<const std::byte> bytes = window.ahead(step);
            ASSERT_GE(bytes.size(), std::min<std::uint64_t>(step, window.remaining()));
            const std::size_t count = std::min(step, bytes.size());
            again += textOf(bytes.first(count));
            window.skip(count);
            ASSERT_EQ(again.size() + window.remaining(), text.size());
        }
        EXPECT_EQ(again, text);
    }
}

TEST(ByteWindow, CutsNoWordAndNoLineEndWhereThePiecesMeet) {
    const TemporaryFolder folder;
    const auto file = folder.write("a.txt", numbered(20'000));
    for (const std::size_t piece : {1u, 17u, 4096u}) {
        ByteWindow window(InputFile(file), {}, piece);
        std::array<std::string_view, 3> words;
        for (int i = 0; i < 19'998; i += 3) {
            nextWords(window, words);
            for (int at = 0; at < 3; ++at)
                ASSERT_EQ(words[static_cast<std::size_t>(at)], std::to_string(i + at));
        }
        EXPECT_EQ(nextWord(window), "19998");
        EXPECT_EQ(nextWord(window), "19999");
        EXPECT_EQ(nextWord(window), "");
    }
    const std::string longLines(40'000, '#');
    for (std::size_t length = 16'380; length < 16'388; ++length) {
        const auto other = folder.write("b.txt", longLines.substr(0, length) + "\r\nend of header\r\n12");
        ByteWindow window(InputFile(other), {}, 1);
        EXPECT_EQ(aheadWithLine(window, "end").size(), length + 17);
        EXPECT_EQ(aheadWithLine(window, "other").size(), length + 19);
    }
}

TEST(ByteWindow, SaysSoWhenAFileLosesItsEndWhileItIsRead) {
    const TemporaryFolder folder;
    const auto file = folder.write("a.txt", numbered(500));
    ByteWindow window(InputFile(file), {}, 16);
    window.ahead(16);
    std::filesystem::resize_file(file, 20);
    expectError([&] { window.ahead(1000); }, "could not be read to its end");
}

TEST(ByteWindow, ReadsWhatDoesNotTellItsLength) {
    const TemporaryFolder folder;
    const auto pipe = folder / "pipe.pcd";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::thread writer([&] {
        std::ofstream(pipe)
            << "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\nDATA ascii\n1 2 3";
    });
    const PointCloud cloud = readPointCloud(pipe);
    writer.join();
    EXPECT_EQ(cloud.points, std::vector<Eigen::Vector3d>{Eigen::Vector3d(1.0, 2.0, 3.0)});
}

/// More than a piece of the file, with every tenth point to be dropped.
PointCloud largeCloud() {
    PointCloud cloud;
    for (const Eigen::Vector3d& point : randomPoints(150'000, 44)) {
        cloud.points.push_back(point.cast<float>().cast<double>());
        cloud.colours.push_back({static_cast<std::uint8_t>(cloud.size()), static_cast<std::uint8_t>(cloud.size() >> 8),
                                 static_cast<std::uint8_t>(cloud.size() >> 16)});
        if (cloud.size() % 10 == 0)
            cloud.points.back()[static_cast<Eigen::Index>(cloud.size() / 10 % 3)] = std::nan("");
    }
    return cloud;
}

void expectFinitePointsOf(const PointCloud& cloud, const PointCloud& read) {
    PointCloud finite;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        if (!cloud.points[i].allFinite()) continue;
        finite.points.push_back(cloud.points[i]);
        finite.colours.push_back(cloud.colours[i]);
    }
    EXPECT_EQ(read.points, finite.points);
    EXPECT_EQ(read.colours, finite.colours);
    EXPECT_EQ(read.droppedNonFinite, cloud.size() - finite.size());
}

TEST(ReadPointCloud, GivesLargeFilesBackFromEveryEncoding) {
    const TemporaryFolder folder;
    const PointCloud cloud = largeCloud();
    for (const PcdEncoding encoding : {PcdEncoding::Ascii, PcdEncoding::Binary, PcdEncoding::BinaryCompressed}) {
        writePointCloud(folder / "a.pcd", cloud, encoding);
        expectFinitePointsOf(cloud, readPointCloud(folder / "a.pcd"));
    }
    writePointCloud(folder / "a.ply", cloud);
    expectFinitePointsOf(cloud, readPointCloud(folder / "a.ply"));
}

TEST(ReadPointCloud, TellsHowFarItIsAndCanBeCancelled) {
    const TemporaryFolder folder;
    writePointCloud(folder / "a.pcd", largeCloud(), PcdEncoding::Ascii);
    std::vector<double> fractions;
    Progress watched([&](const std::string& stage, double fraction) {
        EXPECT_EQ(stage, "reading the map");
        fractions.push_back(fraction);
    });
    readPointCloud(folder / "a.pcd", watched, "reading the map");
    ASSERT_GT(fractions.size(), 2u);
    EXPECT_TRUE(std::ranges::is_sorted(fractions));
    EXPECT_EQ(fractions.front(), 0.0);
    EXPECT_LT(fractions.back(), 1.0);
    Progress stopped([&](const std::string&, double fraction) {
        if (fraction > 0.0) stopped.cancel();
    });
    EXPECT_THROW(readPointCloud(folder / "a.pcd", stopped), Cancelled);
}

}  // namespace
}  // namespace fodscope
