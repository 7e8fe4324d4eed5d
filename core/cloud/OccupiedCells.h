// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fodscope {

/// Which cells of a row of cells are taken: a bit for each. Once all are marked, it tells how many taken cells come
/// before one, so that what belongs to the taken cells can lie close together, in the order of the cells.
class OccupiedCells {
  public:
    explicit OccupiedCells(std::uint64_t cells) : words_(static_cast<std::size_t>(cells / kBits + 1)) {}

    void mark(std::uint64_t cell) { words_[wordOf(cell)] |= bitOf(cell); }

    void merge(const OccupiedCells& other) {
        for (std::size_t word = 0; word < words_.size(); ++word)
            words_[word] |= other.words_[word];
    }

    /// Call after the last mark and before what follows.
    void count() {
        before_.resize(words_.size());
        std::uint32_t taken = 0;
        for (std::size_t word = 0; word < words_.size(); ++word) {
            before_[word] = taken;
            taken += static_cast<std::uint32_t>(std::popcount(words_[word]));
        }
        taken_ = taken;
    }

    /// @return the number of taken cells
    std::uint32_t taken() const { return taken_; }

    /// @return the number of taken cells before this one
    std::uint32_t takenBefore(std::uint64_t cell) const {
        const std::size_t word = wordOf(cell);
        return before_[word] + static_cast<std::uint32_t>(std::popcount(words_[word] & (bitOf(cell) - 1)));
    }

    /// @return the first cell of the earliest word that has at least this many taken cells before it, or the number of
    ///         cells, rounded up to whole words
    std::uint64_t cellWithBefore(std::uint32_t takenBefore) const {
        const auto word = std::ranges::lower_bound(before_, takenBefore);
        return static_cast<std::uint64_t>(word - before_.begin()) * kBits;
    }

  private:
    static constexpr std::uint64_t kBits = 64;
    static std::size_t wordOf(std::uint64_t cell) { return static_cast<std::size_t>(cell / kBits); }
    static std::uint64_t bitOf(std::uint64_t cell) { return std::uint64_t{1} << (cell % kBits); }

    std::vector<std::uint64_t> words_;
    std::vector<std::uint32_t> before_;
    std::uint32_t taken_ = 0;
};

}  // namespace fodscope
