// SPDX-License-Identifier: MIT
#include "core/cloud/TextScanner.h"

#include <algorithm>
#include <charconv>

namespace fodscope {
namespace {

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
}

template <class Number>
std::optional<Number> parse(std::string_view word) {
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    Number value{};
    const char* end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (stop != end || error != std::errc{}) return std::nullopt;
    return value;
}

}  // namespace

std::string_view TextScanner::line() {
    const std::size_t end = std::min(text_.find_first_of("\r\n", position_), text_.size());
    const std::string_view found = text_.substr(position_, end - position_);
    position_ = end;
    if (position_ < text_.size() && text_[position_] == '\r') ++position_;
    // A lone CR ends a line too; CR LF is one end.
    if (position_ < text_.size() && text_[position_] == '\n') ++position_;
    return found;
}

std::string_view TextScanner::word() {
    while (position_ < text_.size() && isBlank(text_[position_]))
        ++position_;
    const std::size_t start = position_;
    while (position_ < text_.size() && !isBlank(text_[position_]))
        ++position_;
    return text_.substr(start, position_ - start);
}

std::string_view textOf(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::optional<double> numberFrom(std::string_view word) {
    return parse<double>(word);
}

std::optional<std::uint64_t> countFrom(std::string_view word) {
    return parse<std::uint64_t>(word);
}

std::optional<std::int64_t> integerFrom(std::string_view word) {
    return parse<std::int64_t>(word);
}

}  // namespace fodscope
