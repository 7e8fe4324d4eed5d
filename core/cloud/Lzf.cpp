// SPDX-License-Identifier: MIT
#include "core/cloud/Lzf.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

namespace fodscope {
namespace {

constexpr std::size_t kLongestLiteral = 32;
constexpr std::size_t kShortestMatch = 3;
constexpr std::size_t kLongestMatch = 7 + 255 + 2;
constexpr unsigned kHashBits = 15;

std::size_t hashOf(std::span<const std::byte> bytes, std::size_t at) {
    const std::uint32_t three = std::to_integer<std::uint32_t>(bytes[at]) << 16 |
                                std::to_integer<std::uint32_t>(bytes[at + 1]) << 8 |
                                std::to_integer<std::uint32_t>(bytes[at + 2]);
    return (three * 2654435761u) >> (32 - kHashBits);
}

std::size_t matchLength(std::span<const std::byte> input, std::size_t earlier, std::size_t at) {
    const std::size_t most = std::min(kLongestMatch, input.size() - at);
    std::size_t length = 0;
    while (length < most && input[earlier + length] == input[at + length])
        ++length;
    return length;
}

void appendLiterals(std::vector<std::byte>& output, std::span<const std::byte> literals) {
    while (!literals.empty()) {
        const std::size_t count = std::min(kLongestLiteral, literals.size());
        output.push_back(static_cast<std::byte>(count - 1));
        output.insert(output.end(), literals.begin(), literals.begin() + static_cast<std::ptrdiff_t>(count));
        literals = literals.subspan(count);
    }
}

void appendMatch(std::vector<std::byte>& output, std::size_t distance, std::size_t length) {
    const std::size_t back = distance - 1;
    const std::size_t coded = length - 2;
    output.push_back(static_cast<std::byte>(std::min<std::size_t>(coded, 7) << 5 | back >> 8));
    if (coded >= 7) output.push_back(static_cast<std::byte>(coded - 7));
    output.push_back(static_cast<std::byte>(back & 0xff));
}

/// A match may overlap what it writes.
void copyMatch(std::span<std::byte> output, std::size_t at, std::size_t distance, std::size_t length) {
    constexpr std::size_t word = 8;
    // Whole words write past the match, into room that is there and filled later.
    if (distance >= word && length + word <= output.size() - at) {
        for (std::size_t i = 0; i < length; i += word)
            std::memcpy(&output[at + i], &output[at + i - distance], word);
        return;
    }
    for (std::size_t i = 0; i < length; ++i)
        output[at + i] = output[at + i - distance];
}

}  // namespace

std::vector<std::byte> lzfCompress(std::span<const std::byte> input) {
    constexpr std::size_t never = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> lastSeen(std::size_t{1} << kHashBits, never);
    std::vector<std::byte> output;
    output.reserve(input.size() + input.size() / kLongestLiteral + 1);
    std::size_t literalStart = 0;
    std::size_t at = 0;
    while (at + kShortestMatch <= input.size()) {
        std::size_t& slot = lastSeen[hashOf(input, at)];
        const std::size_t earlier = std::exchange(slot, at);
        const bool reachable = earlier != never && at - earlier <= kLzfFarthestMatch;
        const std::size_t length = reachable ? matchLength(input, earlier, at) : 0;
        if (length < kShortestMatch) {
            ++at;
            continue;
        }
        appendLiterals(output, input.subspan(literalStart, at - literalStart));
        appendMatch(output, at - earlier, length);
        at += length;
        literalStart = at;
    }
    appendLiterals(output, input.subspan(literalStart));
    return output;
}

LzfSteps lzfDecode(std::span<const std::byte> input, std::span<std::byte> output, std::size_t written) {
    LzfSteps steps{0, written};
    while (steps.read < input.size()) {
        std::size_t in = steps.read;
        const auto control = std::to_integer<std::size_t>(input[in++]);
        if (control < kLongestLiteral) {
            const std::size_t count = control + 1;
            if (count > input.size() - in || count > output.size() - steps.written) break;
            std::memcpy(&output[steps.written], &input[in], count);
            steps = {in + count, steps.written + count};
            continue;
        }
        std::size_t length = (control >> 5) + 2;
        if (control >> 5 == 7) {
            if (in == input.size()) break;
            length += std::to_integer<std::size_t>(input[in++]);
        }
        if (in == input.size()) break;
        const std::size_t distance = ((control & 31) << 8 | std::to_integer<std::size_t>(input[in++])) + 1;
        if (distance > steps.written || length > output.size() - steps.written) break;
        copyMatch(output, steps.written, distance, length);
        steps = {in, steps.written + length};
    }
    return steps;
}

bool lzfDecompress(std::span<const std::byte> input, std::span<std::byte> output) {
    const LzfSteps steps = lzfDecode(input, output, 0);
    return steps.read == input.size() && steps.written == output.size();
}

}  // namespace fodscope
