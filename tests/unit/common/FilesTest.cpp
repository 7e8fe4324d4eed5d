// SPDX-License-Identifier: MIT
#include "core/common/Files.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/common/Error.h"

using namespace fodscope;

namespace {

class FilesTest : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (std::filesystem::temp_directory_path() / "fodscope-files-XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    std::filesystem::path folder_;
};

}  // namespace

TEST_F(FilesTest, WhatWasWrittenIsReadBack) {
    writeFile(folder_ / "a.txt", std::string_view("first"));
    writeFile(folder_ / "a.txt", std::string_view("second"));
    EXPECT_EQ(readTextFile(folder_ / "a.txt"), "second");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1) << "a temporary file was left";
}

TEST_F(FilesTest, AMissingFileIsNamedInTheError) {
    try {
        readFile(folder_ / "nothing.pcd");
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("nothing.pcd: no such file; "), std::string::npos) << error.what();
    }
}

TEST_F(FilesTest, AFullDiskLeavesTheOldFileAndSaysSo) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    EXPECT_THROW(writeFile("/dev/full/inside", std::string_view("x")), Error);
    EXPECT_THROW(writeFile(folder_ / "no" / "folder" / "a", std::string_view("x")), Error);
}

TEST_F(FilesTest, AFolderThatIsAFileIsRefused) {
    writeFile(folder_ / "file", std::string_view("x"));
    EXPECT_THROW(makeFolder(folder_ / "file" / "below"), Error);
    EXPECT_NO_THROW(makeFolder(folder_ / "a" / "b"));
    EXPECT_THROW(readFile(folder_ / "a"), Error);
}
