// SPDX-License-Identifier: MIT
#include "core/cloud/ByteWindow.h"

#include <algorithm>
#include <utility>

#include "core/cloud/TextScanner.h"
#include "core/common/Error.h"

namespace fodscope {
namespace {

/// Longer than the lines of most files; where it is not, more is looked at.
constexpr std::size_t kTextBytes = 1 << 14;

}  // namespace

ByteWindow::ByteWindow(InputFile file, OnRead onRead, std::size_t pieceBytes)
    : file_(std::move(file)),
      unread_(file_->size()),
      onRead_(std::move(onRead)),
      pieceBytes_(std::max<std::size_t>(pieceBytes, 1)) {
    if (unread_ > 0) return;
    // Only reading tells its length, which readers have to know.
    while (true) {
        const std::size_t before = buffer_.size();
        buffer_.resize(before + pieceBytes_);
        const std::size_t count = file_->read(std::span(buffer_).subspan(before));
        buffer_.resize(before + count);
        if (count == 0) break;
        if (onRead_) onRead_(0.0);
    }
    view_ = buffer_;
}

void ByteWindow::read(std::size_t count) {
    if (onRead_) onRead_(1.0 - static_cast<double>(remaining()) / static_cast<double>(file_->size()));
    const std::size_t kept = view_.size();
    std::copy(view_.begin(), view_.end(), buffer_.begin());
    const auto wanted =
        static_cast<std::size_t>(std::min<std::uint64_t>(remaining(), std::max<std::uint64_t>(count, pieceBytes_)));
    if (buffer_.size() < wanted) buffer_.resize(wanted);
    const std::span<std::byte> more = std::span(buffer_).subspan(kept, wanted - kept);
    view_ = {};
    if (file_->read(more) < more.size()) {
        throw Error(file_->path().string(), "could not be read to its end", "check the disk and copy the file anew");
    }
    unread_ -= more.size();
    view_ = std::span(buffer_).first(wanted);
}

void nextWords(ByteWindow& window, std::span<std::string_view> words) {
    std::span<const std::byte> bytes = window.ahead(kTextBytes);
    while (true) {
        TextScanner text(textOf(bytes));
        for (std::string_view& word : words)
            word = text.word();
        // A word that ends with what is in memory may go on after it.
        if (!text.atEnd() || window.isAllInMemory()) {
            window.skip(text.position());
            return;
        }
        bytes = window.ahead(2 * bytes.size());
    }
}

std::string_view nextWord(ByteWindow& window) {
    std::string_view word;
    nextWords(window, std::span(&word, 1));
    return word;
}

std::span<const std::byte> aheadWithLine(ByteWindow& window, std::string_view keyword) {
    std::span<const std::byte> bytes = window.ahead(kTextBytes);
    while (true) {
        TextScanner lines(textOf(bytes));
        while (!lines.atEnd()) {
            const std::string_view line = lines.line();
            // At the end of what is in memory the line may go on, or a CR be followed by its LF.
            if (lines.atEnd() && !window.isAllInMemory()) break;
            if (TextScanner(line).word() == keyword) return bytes.first(lines.position());
        }
        if (window.isAllInMemory()) return bytes;
        bytes = window.ahead(4 * bytes.size());
    }
}

}  // namespace fodscope
