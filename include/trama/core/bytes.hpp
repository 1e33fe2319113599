#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

#if defined(__SSE2__)
#include <emmintrin.h>
#elif defined(__ARM_NEON) && defined(__aarch64__)
#include <arm_neon.h>
#endif

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

/// Exclusive or of the `n` bytes at `p`: the reference that the vector versions are tested against.
constexpr std::uint8_t xor_of_scalar(const std::uint8_t* p, std::size_t n) noexcept {
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

inline constexpr std::size_t few_bytes = 64;

/// `few_bytes` of these from place `few_bytes` - n on keep the first n of as many bytes.
inline constexpr auto first_bytes = [] {
    std::array<std::uint8_t, 2 * few_bytes> mask{};
    for (std::size_t i = 0; i != few_bytes; ++i) mask[i] = 0xFF;
    return mask;
}();

/// A word whose bytes fold to the exclusive or of the first `n` bytes at `p`, up to `Most`, of as many readable ones.
/// Without a branch on `n`.
template <std::size_t Most>
constexpr std::uint64_t word_of_few(const std::uint8_t* p, std::size_t n) noexcept {
    static_assert(Most <= few_bytes && Most % 8 == 0);
    const std::uint8_t* mask = first_bytes.data() + few_bytes - n;
    std::uint64_t word = 0;
    for (std::size_t i = 0; i != Most; i += 8) word ^= load_le<std::uint64_t>(p + i) & load_le<std::uint64_t>(mask + i);
    return word;
}
/// Exclusive or of the first `n` bytes at `p`, up to `few_bytes`, of as many readable ones. Without a branch on `n`.
constexpr std::uint8_t xor_of_few(const std::uint8_t* p, std::size_t n) noexcept { return fold_xor(word_of_few<few_bytes>(p, n)); }

/// 16 bytes from place n on keep the last n of 16 bytes.
inline constexpr auto last_bytes = [] {
    std::array<std::uint8_t, 32> mask{};
    for (std::size_t i = 16; i != mask.size(); ++i) mask[i] = 0xFF;
    return mask;
}();

#if defined(__SSE2__)

/// The 16 bytes at `p`.
inline __m128i load_vector(const std::uint8_t* p) noexcept {
    __m128i v;
    std::memcpy(&v, p, sizeof v);
    return v;
}

/// Exclusive or of the `n` bytes at `p`, 16 or more. The last vector overlaps the one before it.
inline std::uint8_t xor_of_vector(const std::uint8_t* p, std::size_t n) noexcept {
    __m128i even = _mm_setzero_si128(), odd = _mm_and_si128(load_vector(p + n - 16), load_vector(last_bytes.data() + n % 16));
    std::size_t i = 0;
    for (; i + 32 <= n; i += 32) {
        even = _mm_xor_si128(even, load_vector(p + i));
        odd = _mm_xor_si128(odd, load_vector(p + i + 16));
    }
    if (i + 16 <= n) even = _mm_xor_si128(even, load_vector(p + i));
    std::uint64_t words[2];
    even = _mm_xor_si128(even, odd);
    std::memcpy(words, &even, sizeof words);
    return fold_xor(words[0] ^ words[1]);
}

#elif defined(__ARM_NEON) && defined(__aarch64__)

/// Exclusive or of the `n` bytes at `p`, 16 or more. The last vector overlaps the one before it.
inline std::uint8_t xor_of_vector(const std::uint8_t* p, std::size_t n) noexcept {
    uint8x16_t x = vandq_u8(vld1q_u8(p + n - 16), vld1q_u8(last_bytes.data() + n % 16));
    for (std::size_t i = 0; i + 16 <= n; i += 16) x = veorq_u8(x, vld1q_u8(p + i));
    const uint64x2_t words = vreinterpretq_u64_u8(x);
    return fold_xor(vgetq_lane_u64(words, 0) ^ vgetq_lane_u64(words, 1));
}

#else

inline std::uint8_t xor_of_vector(const std::uint8_t* p, std::size_t n) noexcept { return xor_of_scalar(p, n); }

#endif

/// Exclusive or of all `bytes`.
constexpr std::uint8_t xor_of(std::span<const std::uint8_t> bytes) noexcept {
    if (std::is_constant_evaluated() || bytes.size() < 16) return xor_of_scalar(bytes.data(), bytes.size());
    return xor_of_vector(bytes.data(), bytes.size());
}

}  // namespace trama
