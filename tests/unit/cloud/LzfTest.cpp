// SPDX-License-Identifier: MIT
#include "core/cloud/Lzf.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <string>

namespace fodscope {
namespace {

std::vector<std::byte> bytesOf(const std::string& text) {
    std::vector<std::byte> bytes(text.size());
    std::memcpy(bytes.data(), text.data(), text.size());
    return bytes;
}

std::string decompressed(const std::vector<std::byte>& stream, std::size_t size) {
    std::vector<std::byte> output(size);
    EXPECT_TRUE(lzfDecompress(stream, output));
    return {reinterpret_cast<const char*>(output.data()), output.size()};
}

TEST(Lzf, DecodesStreamsWrittenByHand) {
    using std::string_literals::operator""s;
    // Two literals "ab", then 4 + 2 bytes from 2 back.
    EXPECT_EQ(decompressed(bytesOf("\x01"s + "ab" + "\x80\x01"s), 8), "abababab");
    // One literal, then 7 + 3 + 2 bytes from 1 back.
    EXPECT_EQ(decompressed(bytesOf("\x00x\xe0\x03\x00"s), 13), std::string(13, 'x'));
}

TEST(Lzf, GivesBackWhatItWasGiven) {
    std::mt19937 generator(5);
    for (const std::size_t size : {0u, 1u, 2u, 3u, 31u, 32u, 33u, 1000u, 50000u}) {
        for (const unsigned alphabet : {1u, 2u, 20u, 256u}) {
            std::string text(size, '\0');
            for (char& c : text)
                c = static_cast<char>(generator() % alphabet);
            const std::vector<std::byte> stream = lzfCompress(bytesOf(text));
            EXPECT_EQ(decompressed(stream, size), text);
            EXPECT_LE(size, stream.size() * kLzfLargestExpansion);
            EXPECT_LE(stream.size(), size + size / 32 + 1);
        }
    }
}

TEST(Lzf, CompressesRepetitions) {
    EXPECT_LT(lzfCompress(std::vector<std::byte>(100000, std::byte{7})).size(), 1300u);
}

TEST(Lzf, RefusesDamagedStreams) {
    using std::string_literals::operator""s;
    std::vector<std::byte> output(8);
    EXPECT_FALSE(lzfDecompress(bytesOf("\x80\x01"s), output));              // copies from before the start
    EXPECT_FALSE(lzfDecompress(bytesOf("\x05"s + "ab"), output));           // literals missing
    EXPECT_FALSE(lzfDecompress(bytesOf("\x01"s + "ab" + "\x80"), output));  // distance missing
    EXPECT_FALSE(lzfDecompress(bytesOf("\x00x\xe0"s), output));             // length missing
    EXPECT_FALSE(lzfDecompress(bytesOf("\x00x\xe0\xff\x00"s), output));     // more than asked for
    EXPECT_FALSE(lzfDecompress(bytesOf("\x00x"s), output));                 // less than asked for
    std::mt19937 generator(6);
    for (int i = 0; i < 2000; ++i) {
        std::vector<std::byte> noise(generator() % 40);
        for (std::byte& byte : noise)
            byte = static_cast<std::byte>(generator());
        lzfDecompress(noise, output);  // must not read or write out of bounds
    }
}

}  // namespace
}  // namespace fodscope
