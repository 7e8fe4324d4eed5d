// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace fodscope {

/// Numbers as binary cloud files hold them.
enum class ScalarType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float32, Float64 };

constexpr std::size_t sizeOf(ScalarType type) {
    switch (type) {
        case ScalarType::Int8:
        case ScalarType::UInt8:
            return 1;
        case ScalarType::Int16:
        case ScalarType::UInt16:
            return 2;
        case ScalarType::Int32:
        case ScalarType::UInt32:
        case ScalarType::Float32:
            return 4;
        default:
            return 8;
    }
}

constexpr bool isFloating(ScalarType type) {
    return type == ScalarType::Float32 || type == ScalarType::Float64;
}

/// @return the value as a binary file would give it back: text of the type float32 has no more digits than that
inline double asStored(double value, ScalarType type) {
    return type == ScalarType::Float32 ? static_cast<double>(static_cast<float>(value)) : value;
}

template <class Number>
Number loadNumber(const std::byte* bytes, std::endian order = std::endian::little) {
    std::byte copy[sizeof(Number)];
    std::memcpy(copy, bytes, sizeof(Number));
    if (order != std::endian::native) std::reverse(copy, copy + sizeof(Number));
    return std::bit_cast<Number>(copy);
}

/// @param bytes at least sizeOf(type) of them
inline double loadScalar(const std::byte* bytes, ScalarType type, std::endian order) {
    switch (type) {
        case ScalarType::Int8:
            return loadNumber<std::int8_t>(bytes, order);
        case ScalarType::UInt8:
            return loadNumber<std::uint8_t>(bytes, order);
        case ScalarType::Int16:
            return loadNumber<std::int16_t>(bytes, order);
        case ScalarType::UInt16:
            return loadNumber<std::uint16_t>(bytes, order);
        case ScalarType::Int32:
            return loadNumber<std::int32_t>(bytes, order);
        case ScalarType::UInt32:
            return loadNumber<std::uint32_t>(bytes, order);
        case ScalarType::Int64:
            return static_cast<double>(loadNumber<std::int64_t>(bytes, order));
        case ScalarType::UInt64:
            return static_cast<double>(loadNumber<std::uint64_t>(bytes, order));
        case ScalarType::Float32:
            return static_cast<double>(loadNumber<float>(bytes, order));
        case ScalarType::Float64:
            return loadNumber<double>(bytes, order);
    }
    return 0.0;
}

/// Appends the number's bytes, little end first.
template <class Number>
void appendNumber(std::string& bytes, Number number) {
    char copy[sizeof(Number)];
    std::memcpy(copy, &number, sizeof(Number));
    if (std::endian::native != std::endian::little) std::reverse(copy, copy + sizeof(Number));
    bytes.append(copy, sizeof(Number));
}

inline void appendScalar(std::string& bytes, double value, ScalarType type) {
    switch (type) {
        case ScalarType::Int8:
            return appendNumber(bytes, static_cast<std::int8_t>(value));
        case ScalarType::UInt8:
            return appendNumber(bytes, static_cast<std::uint8_t>(value));
        case ScalarType::Int16:
            return appendNumber(bytes, static_cast<std::int16_t>(value));
        case ScalarType::UInt16:
            return appendNumber(bytes, static_cast<std::uint16_t>(value));
        case ScalarType::Int32:
            return appendNumber(bytes, static_cast<std::int32_t>(value));
        case ScalarType::UInt32:
            return appendNumber(bytes, static_cast<std::uint32_t>(value));
        case ScalarType::Int64:
            return appendNumber(bytes, static_cast<std::int64_t>(value));
        case ScalarType::UInt64:
            return appendNumber(bytes, static_cast<std::uint64_t>(value));
        case ScalarType::Float32:
            return appendNumber(bytes, static_cast<float>(value));
        case ScalarType::Float64:
            return appendNumber(bytes, value);
    }
}

}  // namespace fodscope
