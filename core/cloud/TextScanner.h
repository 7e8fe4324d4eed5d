// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace fodscope {

/// Walks through text by lines and words. Lines end with LF, CR LF or CR.
class TextScanner {
  public:
    explicit TextScanner(std::string_view text, std::size_t position = 0) : text_(text), position_(position) {}

    bool atEnd() const { return position_ >= text_.size(); }
    std::size_t position() const { return position_; }

    /// @return the rest of this line without its end; empty at the end of the text
    std::string_view line();

    /// @return the next word, over line ends too; empty at the end of the text
    std::string_view word();

  private:
    std::string_view text_;
    std::size_t position_;
};

std::string_view textOf(std::span<const std::byte> bytes);

/// @return the word as a number, NaN and infinities included; empty when it is none
std::optional<double> numberFrom(std::string_view word);
std::optional<std::uint64_t> countFrom(std::string_view word);
std::optional<std::int64_t> integerFrom(std::string_view word);

}  // namespace fodscope
