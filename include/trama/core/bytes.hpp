#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

namespace trama {

/// Loads an unsigned `T`, least significant byte first.
template <class T>
constexpr T load_le(const std::uint8_t* p) noexcept {
    T v = 0;
    if (std::is_constant_evaluated() || std::endian::native != std::endian::little) {
        for (std::size_t i = 0; i != sizeof(T); ++i) v = static_cast<T>(v | static_cast<T>(static_cast<T>(p[i]) << (8 * i)));
    } else {
        std::memcpy(&v, p, sizeof(T));
    }
    return v;
}

/// Stores an unsigned `T`, least significant byte first.
template <class T>
constexpr void store_le(std::uint8_t* p, T v) noexcept {
    if (std::is_constant_evaluated() || std::endian::native != std::endian::little) {
        for (std::size_t i = 0; i != sizeof(T); ++i) p[i] = static_cast<std::uint8_t>(v >> (8 * i));
    } else {
        std::memcpy(p, &v, sizeof(T));
    }
}

/// Copies `n` bytes between places that do not overlap.
constexpr void copy_bytes(std::uint8_t* to, const std::uint8_t* from, std::size_t n) noexcept {
    if (std::is_constant_evaluated()) {
        for (std::size_t i = 0; i != n; ++i) to[i] = from[i];
    } else if (n != 0) {
        std::memcpy(to, from, n);
    }
}

/// Exclusive or of the eight bytes of `word`.
constexpr std::uint8_t fold_xor(std::uint64_t word) noexcept {
    word ^= word >> 32;
    word ^= word >> 16;
    return static_cast<std::uint8_t>(word ^ word >> 8);
}

/// Exclusive or of all `bytes`.
constexpr std::uint8_t xor_of(std::span<const std::uint8_t> bytes) noexcept {
    std::uint64_t word = 0;
    const std::uint8_t* p = bytes.data();
    std::size_t n = bytes.size();
    for (; n >= 8; n -= 8, p += 8) word ^= load_le<std::uint64_t>(p);
    std::uint8_t x = fold_xor(word);
    for (; n != 0; --n, ++p) x ^= *p;
    return x;
}

/// Exclusive or of the first `n` bytes, 5..16, of 16 readable ones, without a branch on each byte.
constexpr std::uint8_t xor_of_short(const std::uint8_t* p, std::size_t n) noexcept {
    const auto low = load_le<std::uint64_t>(p);
    const auto high = load_le<std::uint64_t>(p + 8);
    const std::uint64_t word = n <= 8 ? low << (64 - 8 * n) : low ^ high << (128 - 8 * n);
    return fold_xor(word);
}

}  // namespace trama
