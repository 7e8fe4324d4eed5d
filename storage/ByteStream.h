// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/common/Error.h"

namespace fodscope {

static_assert(std::endian::native == std::endian::little, "blobs are little-endian and copied as they lie in memory");

/// Appends numbers to bytes.
class ByteWriter {
  public:
    explicit ByteWriter(std::string_view magic) { append(magic.data(), magic.size()); }

    template <typename Number>
    void number(Number value) {
        append(&value, sizeof value);
    }

    template <typename Number>
    void array(std::span<const Number> values) {
        append(values.data(), values.size_bytes());
    }

    std::vector<std::byte> take() { return std::move(bytes_); }

  private:
    void append(const void* data, std::size_t size) {
        const auto* first = static_cast<const std::byte*>(data);
        bytes_.insert(bytes_.end(), first, first + size);
    }

    std::vector<std::byte> bytes_;
};

/// Takes numbers from bytes, never past their end, and allocates nothing that the bytes cannot fill.
class ByteReader {
  public:
    ByteReader(std::span<const std::byte> bytes, std::string_view magic, std::string subject)
        : rest_(bytes), subject_(std::move(subject)) {
        const auto found = take(magic.size());
        if (std::memcmp(found.data(), magic.data(), magic.size()) != 0) fail();
    }

    template <typename Number>
    Number number() {
        Number value;
        std::memcpy(&value, take(sizeof value).data(), sizeof value);
        return value;
    }

    template <typename Number>
    std::vector<Number> array(std::uint64_t count) {
        if (count > rest_.size() / sizeof(Number)) fail();
        const auto bytes = take(static_cast<std::size_t>(count) * sizeof(Number));
        std::vector<Number> values(static_cast<std::size_t>(count));
        if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
        return values;
    }

    void expectEnd() const {
        if (!rest_.empty()) fail();
    }

    [[noreturn]] void fail() const {
        throw Error(subject_, "the session file is damaged (a cloud in it is not laid out as it should be)",
                    "restore it from a copy");
    }

  private:
    std::span<const std::byte> take(std::size_t size) {
        if (size > rest_.size()) fail();
        const auto first = rest_.first(size);
        rest_ = rest_.subspan(size);
        return first;
    }

    std::span<const std::byte> rest_;
    std::string subject_;
};

}  // namespace fodscope
