#pragma once

#include <array>

#include "trama/core/decimal.hpp"

#if defined(__SSE2__)
#include <emmintrin.h>
#elif defined(__ARM_NEON) && defined(__aarch64__)
#include <arm_neon.h>
#endif

/// Reading many numbers of one record: all columns are classified at once, then each number is a look-up and a few
/// multiplications. `decimal.hpp` holds the code for one number, which is the reference.
namespace trama {

/// What up to 64 columns hold; bit i stands for column i.
struct column_map {
    std::uint64_t digits = 0;
    std::uint64_t others = 0;  ///< Neither digits nor spaces.
    friend constexpr bool operator==(const column_map&, const column_map&) = default;
};

/// Classifies 16 columns. Reference.
constexpr column_map map_columns_scalar(const std::uint8_t* p) noexcept {
    column_map map;
    for (std::size_t i = 0; i != 16; ++i) {
        const bool digit = p[i] >= '0' && p[i] <= '9';
        map.digits |= std::uint64_t{digit} << i;
        map.others |= std::uint64_t{!digit && p[i] != ' '} << i;
    }
    return map;
}

#if defined(__SSE2__)

/// Classifies 16 columns.
inline column_map map_columns_vector(const std::uint8_t* p) noexcept {
    const __m128i x = load_vector(p);
    const __m128i value = _mm_xor_si128(x, _mm_set1_epi8('0'));
    const __m128i digit = _mm_cmpeq_epi8(_mm_min_epu8(value, _mm_set1_epi8(9)), value);
    const __m128i known = _mm_or_si128(digit, _mm_cmpeq_epi8(x, _mm_set1_epi8(' ')));
    return {static_cast<std::uint64_t>(_mm_movemask_epi8(digit)), static_cast<std::uint64_t>(_mm_movemask_epi8(known)) ^ 0xFFFF};
}

/// Classifies the eight columns of a word, first one lowest.
inline column_map map_word(std::uint64_t word) noexcept {
    const __m128i x = _mm_set_epi64x(0, static_cast<long long>(word));  // 32-bit x86 has no _mm_cvtsi64_si128
    const __m128i value = _mm_xor_si128(x, _mm_set1_epi8('0'));
    const __m128i digit = _mm_cmpeq_epi8(_mm_min_epu8(value, _mm_set1_epi8(9)), value);
    const __m128i both = _mm_unpacklo_epi64(digit, _mm_cmpeq_epi8(x, _mm_set1_epi8(' ')));
    const auto flags = static_cast<unsigned>(_mm_movemask_epi8(both));
    return {flags & 0xFF, ((flags | flags >> 8) & 0xFF) ^ 0xFF};
}

#elif defined(__ARM_NEON) && defined(__aarch64__)

/// Classifies 16 columns.
inline column_map map_columns_vector(const std::uint8_t* p) noexcept {
    static constexpr std::uint8_t weights[16] = {1, 2, 4, 8, 16, 32, 64, 128, 1, 2, 4, 8, 16, 32, 64, 128};
    const auto bits_of = [weight = vld1q_u8(weights)](uint8x16_t flags) noexcept {
        const uint8x16_t bits = vandq_u8(flags, weight);
        return static_cast<std::uint64_t>(vaddv_u8(vget_low_u8(bits))) | static_cast<std::uint64_t>(vaddv_u8(vget_high_u8(bits))) << 8;
    };
    const uint8x16_t x = vld1q_u8(p);
    const uint8x16_t digit = vcleq_u8(vsubq_u8(x, vdupq_n_u8('0')), vdupq_n_u8(9));
    return {bits_of(digit), bits_of(vorrq_u8(digit, vceqq_u8(x, vdupq_n_u8(' ')))) ^ 0xFFFF};
}

#else

inline column_map map_columns_vector(const std::uint8_t* p) noexcept { return map_columns_scalar(p); }

#endif

/// Classifies those groups of 16 of the `Size` columns at `p` that have a bit in `Wanted`; the bits of others may be 0.
/// The last group reaches back over the one before it where fewer than 16 columns are left.
template <std::size_t Size, std::uint64_t Wanted>
[[gnu::always_inline]] constexpr column_map map_columns(const std::uint8_t* p) noexcept {
    static_assert(Size >= 16);
    column_map map;
    const auto add = [&]<std::size_t Group>() __attribute__((always_inline)) {
        constexpr std::size_t from = 16 * Group + 16 <= Size ? 16 * Group : Size - 16;
        if constexpr ((Wanted >> (16 * Group) & 0xFFFF) != 0) {
            const column_map group = std::is_constant_evaluated() ? map_columns_scalar(p + from) : map_columns_vector(p + from);
            map.digits |= group.digits << from;
            map.others |= group.others << from;
        }
    };
    add.template operator()<0>();
    if constexpr (Size > 16) add.template operator()<1>();
    if constexpr (Size > 32) add.template operator()<2>();
    if constexpr (Size > 48) add.template operator()<3>();
    return map;
}

/// By the digits among up to 7 columns, as bits: how far to shift a word of eight columns so that the last digit comes to
/// its top byte; odd where spaces split the digits. Without digits, so far that only the first column remains.
inline constexpr auto column_shift = [] {
    std::array<std::uint8_t, 128> shift{};
    shift[0] = 56;
    for (unsigned digits = 1; digits != shift.size(); ++digits) {
        const unsigned run = digits >> std::countr_zero(digits);
        const bool split = (run & (run + 1)) != 0;
        shift[digits] = static_cast<std::uint8_t>(8 * (7 - (std::bit_width(digits) - 1)) + (split ? 1 : 0));
    }
    return shift;
}();

/// The number in the first `Columns` bytes of `word`, which `digits` describes from bit 0 on. Odd when spaces split its
/// digits; whether the columns hold anything else is for the caller to see.
template <std::size_t Columns>
[[gnu::always_inline]] constexpr std::uint32_t value_of(std::uint64_t word, std::uint64_t digits, std::uint32_t& value) noexcept {
    const std::uint32_t shift = column_shift[digits & ((1U << Columns) - 1)];
    if constexpr (Columns <= 4) {
        std::uint32_t v = (static_cast<std::uint32_t>(word) & 0x0F0F0F0F) << ((shift - 32) & 0x1F);
        v = v * 10 + (v >> 8);
        if constexpr (Columns <= 2) value = v >> 16 & 0xFF;
        else value = (v & 0x00FF00FF) * (100U << 16 | 1U) >> 16;
    } else {
        std::uint64_t v = (word & 0x0F0F0F0F0F0F0F0F) << (shift & 0x3F);
        v = v * 10 + (v >> 8);
        constexpr std::uint64_t pairs = 0x000000FF000000FF, high = 1000000ULL << 32 | 100, low = 10000ULL << 32 | 1;
        value = static_cast<std::uint32_t>(((v & pairs) * high + (v >> 16 & pairs) * low) >> 32);
    }
    return shift;
}

/// As `value_of` for the columns at `p`, of which `Readable` may be read.
template <std::size_t Columns, std::size_t Readable>
[[gnu::always_inline]] constexpr std::uint32_t read_mapped(const std::uint8_t* p, std::uint64_t digits, std::uint32_t& value) noexcept {
    static_assert(Columns <= 7 && Columns <= Readable);
    if constexpr (Columns == 1) {
        value = p[0] & 0x0FU;
        return 0;
    } else if constexpr (Columns <= 4) {
        return value_of<Columns>(Readable >= 4 ? load_le<std::uint32_t>(p) : load_columns<Columns>(p), digits, value);
    } else {
        return value_of<Columns>(Readable >= 8 ? load_le<std::uint64_t>(p) : load_columns<Columns>(p), digits, value);
    }
}

/// As `read_columns`, quicker where single numbers can be classified in a vector. `Readable` columns may be read.
template <std::size_t Columns, std::size_t Readable = Columns>
[[gnu::always_inline]] constexpr std::uint64_t read_one(const std::uint8_t* p, std::uint32_t& value) noexcept {
#if defined(__SSE2__)
    if constexpr (Columns >= 2 && Columns <= 7)
        if (!std::is_constant_evaluated()) {
            const std::uint64_t word = Readable >= 8 ? load_le<std::uint64_t>(p) : load_columns<Columns>(p);
            const column_map map = map_word(word);
            const std::uint32_t odd = value_of<Columns>(word, map.digits, value);
            return (odd & 1) | (map.others & ((1U << Columns) - 1));
        }
#endif
    return read_columns<Columns>(p, value);
}

}  // namespace trama
