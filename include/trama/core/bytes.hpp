#pragma once

#include <array>
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
    const std::uint8_t* p = bytes.data();
    std::size_t n = bytes.size();
    if (n < 8) {
        std::uint8_t x = 0;
        for (; n != 0; --n, ++p) x ^= *p;
        return x;
    }
    std::uint64_t word = 0;
    for (; n >= 8; n -= 8, p += 8) word ^= load_le<std::uint64_t>(p);
    // The last bytes are the top ones of a word that overlaps the one before it.
    if (n != 0) word ^= load_le<std::uint64_t>(p + n - 8) >> (64 - 8 * n);
    return fold_xor(word);
}

/// Words that keep the first n of 16 bytes, n = 0..16.
inline constexpr auto first_bytes = [] {
    std::array<std::array<std::uint64_t, 2>, 17> masks{};
    for (std::size_t n = 0; n != masks.size(); ++n)
        for (std::size_t i = 0; i != n; ++i) masks[n][i / 8] |= std::uint64_t{0xFF} << (8 * (i % 8));
    return masks;
}();

/// Exclusive or of the first `n` bytes, up to 16, of 16 readable ones, of which `low` are the first 8.
constexpr std::uint8_t xor_of_short(std::uint64_t low, const std::uint8_t* p, std::size_t n) noexcept {
    return fold_xor((low & first_bytes[n][0]) ^ (load_le<std::uint64_t>(p + 8) & first_bytes[n][1]));
}

}  // namespace trama
