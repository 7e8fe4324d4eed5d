// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace fodscope {

/// One line of the record, as the table `acts` holds it.
struct Act {
    std::int64_t sequence = 0;
    std::string kind;
    std::string payload;
    std::string author;
    std::string timeUtc;
    std::string softwareVersion;
    std::string previousHash;
    std::string hash;
};

/// What the first act names as the hash of the one before: 64 zeros.
std::string firstPreviousHash();

/// SHA-256 over "fodscope.act/1\n" and then, for sequence, kind, payload, author, time, software version and previous
/// hash in this order, the length in bytes as a decimal number, ":", the text and "\n". The lengths keep text from
/// moving between columns unnoticed.
std::string hashOf(const Act& act);

/// @return what is wrong with an act that should follow `expectedSequence` − 1 and `previousHash`, in words; empty when
///         nothing is
std::string chainProblem(const Act& act, std::int64_t expectedSequence, const std::string& previousHash);

/// @return "act 12 (decision by Anna, 2026-11-21T10:15:30.250Z)"
std::string nameOf(const Act& act);

}  // namespace fodscope
