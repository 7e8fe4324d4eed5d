// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/common/Files.h"

namespace fodscope {

/// Bytes from the first to the last, of which only a window is in memory: those of a file, or such as are in memory
/// already. Readers of clouds look ahead as far as they need and pass over what they are done with.
class ByteWindow {
  public:
    /// Called with the share of the file that was read, for every piece of it; may throw.
    using OnRead = std::function<void(double fraction)>;
    static constexpr std::size_t kPieceBytes = 1 << 20;

    /// @param bytes must outlive the window
    explicit ByteWindow(std::span<const std::byte> bytes) : view_(bytes) {}
    explicit ByteWindow(InputFile file, OnRead onRead = {}, std::size_t pieceBytes = kPieceBytes);

    /// @return what is in memory of the bytes to come: at least `count` of them, unless fewer remain. Valid until the
    ///         next call.
    /// @throws Error when the file cannot be read to its end
    std::span<const std::byte> ahead(std::size_t count) {
        if (count > view_.size() && unread_ > 0) read(count);
        return view_;
    }

    /// @param count not more than ahead() gave
    void skip(std::size_t count) { view_ = view_.subspan(count); }

    /// @return how many bytes are to come
    std::uint64_t remaining() const { return view_.size() + unread_; }
    bool isAllInMemory() const { return unread_ == 0; }

  private:
    void read(std::size_t count);

    std::span<const std::byte> view_;
    std::vector<std::byte> buffer_;
    std::optional<InputFile> file_;
    std::uint64_t unread_ = 0;
    OnRead onRead_;
    std::size_t pieceBytes_ = kPieceBytes;
};

/// Passes over the next word and what separates it from what was before.
/// @return the word; valid until the next call. Empty at the end.
std::string_view nextWord(ByteWindow& window);

/// Passes over the next words, over line ends too.
/// @param words are filled; valid until the next call. Those that the file lacks are empty.
void nextWords(ByteWindow& window, std::span<std::string_view> words);

/// @return the bytes to come up to the end of the first line whose first word is `keyword`, and perhaps some more; all
///         bytes to come when there is no such line
std::span<const std::byte> aheadWithLine(ByteWindow& window, std::string_view keyword);

}  // namespace fodscope
