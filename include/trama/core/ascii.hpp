#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#if defined(__SSE2__)
#include <emmintrin.h>
#elif defined(__ARM_NEON) && defined(__aarch64__)
#include <arm_neon.h>
#endif

#include "trama/core/bytes.hpp"

namespace trama {

/// True for 0x20..0x7E.
constexpr bool is_printable(std::uint8_t c) noexcept { return static_cast<std::uint8_t>(c - 0x20) <= 0x5E; }

/// The top bit of each byte of `word` that is not printable ASCII; bits above the lowest one set may be wrong.
constexpr std::uint64_t unprintable_tops(std::uint64_t word) noexcept {
    return ((word - 0x2020202020202020) | (word + 0x0101010101010101) | word) & 0x8080808080808080;
}

/// Printable bytes at the front of the `n` at `p`: the reference that the vector versions are tested against.
constexpr std::size_t printable_run_scalar(const std::uint8_t* p, std::size_t n) noexcept {
    std::size_t i = 0;
    for (; i + 8 <= n; i += 8)
        if (const std::uint64_t stray = unprintable_tops(load_le<std::uint64_t>(p + i)); stray != 0)
            return i + static_cast<std::size_t>(std::countr_zero(stray)) / 8;
    while (i != n && is_printable(p[i])) ++i;
    return i;
}

/// True when all `n` bytes at `p` are printable. Scalar reference.
constexpr bool all_printable_scalar(const std::uint8_t* p, std::size_t n) noexcept { return printable_run_scalar(p, n) == n; }

/// True when the first `n` bytes at `p`, up to `few_bytes` of as many readable ones, are printable. Without a branch on `n`.
constexpr bool few_printable_bytes(const std::uint8_t* p, std::size_t n) noexcept {
    const std::uint8_t* mask = first_bytes.data() + few_bytes - n;
    std::uint64_t stray = 0;
    for (std::size_t i = 0; i != few_bytes; i += 8) {
        const auto kept = load_le<std::uint64_t>(mask + i);
        stray |= unprintable_tops((load_le<std::uint64_t>(p + i) & kept) | (~kept & 0x2020202020202020));
    }
    return stray == 0;
}

#if defined(__SSE2__)

/// Printable bytes at the front of the 16 at `p`.
inline std::size_t printable_run_16(const std::uint8_t* p) noexcept {
    const __m128i most = _mm_set1_epi8(0x5E);
    const __m128i x = _mm_sub_epi8(load_vector(p), _mm_set1_epi8(0x20));
    const auto good = static_cast<unsigned>(_mm_movemask_epi8(_mm_cmpeq_epi8(_mm_max_epu8(x, most), most)));
    return static_cast<std::size_t>(std::countr_one(good));
}

/// Printable bytes at the front of the `n` at `p`. The last vector overlaps the one before it.
inline std::size_t printable_run_vector(const std::uint8_t* p, std::size_t n) noexcept {
    if (n < 16) return printable_run_scalar(p, n);
    for (std::size_t i = 0; i + 16 <= n; i += 16)
        if (const std::size_t run = printable_run_16(p + i); run != 16) return i + run;
    return n - 16 + printable_run_16(p + n - 16);
}

/// True when all `n` bytes at `p` are printable. One test at the end; the last vector overlaps the one before it.
inline bool all_printable_vector(const std::uint8_t* p, std::size_t n) noexcept {
    if (n < 16) return all_printable_scalar(p, n);
    const __m128i low = _mm_set1_epi8(0x20), most = _mm_set1_epi8(0x5E);
    __m128i worst = _mm_setzero_si128();
    for (std::size_t i = 0; i + 16 <= n; i += 16) worst = _mm_max_epu8(worst, _mm_sub_epi8(load_vector(p + i), low));
    worst = _mm_max_epu8(worst, _mm_sub_epi8(load_vector(p + n - 16), low));
    return _mm_movemask_epi8(_mm_cmpeq_epi8(_mm_max_epu8(worst, most), most)) == 0xFFFF;
}

/// True when the 8..16 characters at `p` are printable; `Byte` is any type of one byte.
template <std::size_t Count, class Byte>
bool few_printable_vector(const Byte* p) noexcept {
    std::uint64_t first, last;
    std::memcpy(&first, p, sizeof first);
    std::memcpy(&last, p + Count - sizeof last, sizeof last);
    const __m128i most = _mm_set1_epi8(0x5E);
    const __m128i x = _mm_sub_epi8(_mm_set_epi64x(static_cast<long long>(last), static_cast<long long>(first)), _mm_set1_epi8(0x20));
    return _mm_movemask_epi8(_mm_cmpeq_epi8(_mm_max_epu8(x, most), most)) == 0xFFFF;
}

#elif defined(__ARM_NEON) && defined(__aarch64__)

/// True when the 8..16 characters at `p` are printable; `Byte` is any type of one byte.
template <std::size_t Count, class Byte>
bool few_printable_vector(const Byte* p) noexcept {
    std::uint64_t first, last;
    std::memcpy(&first, p, sizeof first);
    std::memcpy(&last, p + Count - sizeof last, sizeof last);
    const uint8x16_t x = vcombine_u8(vcreate_u8(first), vcreate_u8(last));
    return vmaxvq_u8(vsubq_u8(x, vdupq_n_u8(0x20))) <= 0x5E;
}

/// True when all `n` bytes at `p` are printable. One test at the end; the last vector overlaps the one before it.
inline bool all_printable_vector(const std::uint8_t* p, std::size_t n) noexcept {
    if (n < 16) return all_printable_scalar(p, n);
    const uint8x16_t low = vdupq_n_u8(0x20);
    uint8x16_t worst = vdupq_n_u8(0);
    for (std::size_t i = 0; i + 16 <= n; i += 16) worst = vmaxq_u8(worst, vsubq_u8(vld1q_u8(p + i), low));
    worst = vmaxq_u8(worst, vsubq_u8(vld1q_u8(p + n - 16), low));
    return vmaxvq_u8(worst) <= 0x5E;
}
inline std::size_t printable_run_vector(const std::uint8_t* p, std::size_t n) noexcept {
    std::size_t i = 0;
    while (i + 16 <= n && all_printable_vector(p + i, 16)) i += 16;
    return i + printable_run_scalar(p + i, n - i);
}

#else

/// True when the 8..16 characters at `p` are printable; `Byte` is any type of one byte.
template <std::size_t Count, class Byte>
bool few_printable_vector(const Byte* p) noexcept {
    std::uint64_t first, last;
    std::memcpy(&first, p, sizeof first);
    std::memcpy(&last, p + Count - sizeof last, sizeof last);
    return (unprintable_tops(first) | unprintable_tops(last)) == 0;
}
inline bool all_printable_vector(const std::uint8_t* p, std::size_t n) noexcept { return all_printable_scalar(p, n); }
inline std::size_t printable_run_vector(const std::uint8_t* p, std::size_t n) noexcept { return printable_run_scalar(p, n); }

#endif

/// Printable bytes at the front of the `n` at `p`.
constexpr std::size_t printable_run(const std::uint8_t* p, std::size_t n) noexcept {
    if (std::is_constant_evaluated()) return printable_run_scalar(p, n);
    return printable_run_vector(p, n);
}

/// True when all `n` bytes at `p` are printable.
constexpr bool all_printable(const std::uint8_t* p, std::size_t n) noexcept {
    if (std::is_constant_evaluated()) return all_printable_scalar(p, n);
    return all_printable_vector(p, n);
}

}  // namespace trama
