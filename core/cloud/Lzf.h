// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fodscope {

/// LZF, the compression inside binary_compressed PCD files. A stream is a row of instructions by their first byte c:
/// c < 32: the c + 1 bytes that follow are literal; else copy from bytes already written: length (c >> 5) + 2 — when
/// c >> 5 is 7, the next byte is added to it — starting ((c & 31) << 8 | next byte) + 1 bytes back.
std::vector<std::byte> lzfCompress(std::span<const std::byte> input);

/// @param output is filled to its end
/// @return whether the stream was sound and gave exactly that many bytes
bool lzfDecompress(std::span<const std::byte> input, std::span<std::byte> output);

/// How far a decoding came.
struct LzfSteps {
    std::size_t read = 0;
    std::size_t written = 0;
};

/// Decodes up to the first instruction that cannot be carried out, because the input ends within it, its bytes find no
/// room in the output, or it copies from before the output's begin.
/// @param output holds the bytes before this input up to `written`, as far as kLzfFarthestMatch back
LzfSteps lzfDecode(std::span<const std::byte> input, std::span<std::byte> output, std::size_t written);

inline constexpr std::size_t kLzfFarthestMatch = 1 << 13;
inline constexpr std::size_t kLzfLongestInstruction = 33;

/// No LZF stream grows by more than this factor: three bytes copy at most 7 + 255 + 2.
inline constexpr std::size_t kLzfLargestExpansion = 88;

}  // namespace fodscope
