#pragma once

#include "trama/core/window.hpp"
#include "trama/daisy/packet.hpp"

/// Where in a run of bytes a documented header may begin. The hunt spends most of its time here.
namespace trama::daisy::recovery {

/// The first place in the `n` bytes at `p` where a documented header may begin and `wanted(place)` holds, or the first of
/// the last four bytes, which are too few to tell. The reference that the vector version is tested against.
constexpr std::size_t find_candidate_scalar(const std::uint8_t* p, std::size_t n, std::size_t from, auto&& wanted) noexcept {
    std::size_t i = from;
    while (i + min_packet <= n && !(may_be_documented(p + i) && wanted(i))) ++i;
    return i;
}

#if defined(__SSE2__)

inline constexpr unsigned bits_per_place = 1;

/// Bit i tells whether the header that begins at `p + i` has a group of boards or everyone as its destination, a group
/// as its source, and a command with a place in the tables. 19 bytes are readable.
inline std::uint64_t plausible_headers(const std::uint8_t* p) noexcept {
    const __m128i destination = load_vector(p + 1), source = load_vector(p + 2), command = load_vector(p + 3), last_group = _mm_set1_epi8(0x6F);
    const __m128i everyone_called = _mm_cmpeq_epi8(destination, _mm_set1_epi8(-1));
    // Compared as signed numbers: 0x00..0x6F are those from 0 to 0x6F, and the top bit is looked at apart.
    const __m128i no_destination = _mm_andnot_si128(everyone_called, _mm_or_si128(destination, _mm_cmpgt_epi8(destination, last_group)));
    const __m128i no_source = _mm_or_si128(source, _mm_cmpgt_epi8(source, last_group));
    const __m128i no_command = _mm_cmpgt_epi8(_mm_and_si128(command, _mm_set1_epi8(0x30)), _mm_setzero_si128());
    return static_cast<std::uint64_t>(_mm_movemask_epi8(_mm_or_si128(_mm_or_si128(no_destination, no_source), no_command))) ^ 0xFFFF;
}

#elif defined(__ARM_NEON) && defined(__aarch64__)

inline constexpr unsigned bits_per_place = 4;

/// Bit 4 i tells what bit i does on other machines.
inline std::uint64_t plausible_headers(const std::uint8_t* p) noexcept {
    const uint8x16_t destination = vld1q_u8(p + 1), source = vld1q_u8(p + 2), command = vld1q_u8(p + 3), groups = vdupq_n_u8(0x70);
    const uint8x16_t good_destination = vorrq_u8(vcltq_u8(destination, groups), vceqq_u8(destination, vdupq_n_u8(0xFF)));
    const uint8x16_t good_command = vceqzq_u8(vandq_u8(command, vdupq_n_u8(0x30)));
    const uint8x16_t good = vandq_u8(vandq_u8(good_destination, vcltq_u8(source, groups)), good_command);
    return vget_lane_u64(vreinterpret_u64_u8(vshrn_n_u16(vreinterpretq_u16_u8(good), 4)), 0) & 0x1111111111111111;
}

#endif

#if defined(__SSE2__) || (defined(__ARM_NEON) && defined(__aarch64__))

/// As `find_candidate_scalar`.
inline std::size_t find_candidate_vector(const std::uint8_t* p, std::size_t n, std::size_t from, auto&& wanted) noexcept {
    std::size_t i = from;
    for (; i + 20 <= n; i += 16)
        for (std::uint64_t places = plausible_headers(p + i); places != 0; places &= places - 1) {
            const std::size_t place = i + static_cast<std::size_t>(std::countr_zero(places)) / bits_per_place;
            if (may_be_documented(p + place) && wanted(place)) return place;
        }
    return find_candidate_scalar(p, n, i, wanted);
}

#else

inline std::size_t find_candidate_vector(const std::uint8_t* p, std::size_t n, std::size_t from, auto&& wanted) noexcept { return find_candidate_scalar(p, n, from, wanted); }

#endif

/// The first place in `run` from `from` on where a documented header may begin and `wanted(place)` holds, or the first of
/// the last four bytes.
constexpr std::size_t find_candidate(std::span<const std::uint8_t> run, std::size_t from, auto&& wanted) noexcept {
    if (std::is_constant_evaluated()) return find_candidate_scalar(run.data(), run.size(), from, wanted);
    return find_candidate_vector(run.data(), run.size(), from, wanted);
}

/// The first place from `at` on where a documented header may begin, or where its five bytes do not lie in one piece.
constexpr std::size_t next_candidate(const window& w, std::size_t at) noexcept {
    if (at >= w.size()) return at;
    return at + find_candidate(w.run(at), 0, [](std::size_t) { return true; });
}

/// Exclusive or over packets that begin close to each other, as those that hostile input promises do: what two
/// neighbours share is not added up again.
class rolling_xor {
public:
    constexpr explicit rolling_xor(std::span<const std::uint8_t> run) noexcept : run_(run) {}

    /// Exclusive or of `n` bytes of the run, at least 1, from `at` on, which never falls from call to call.
    constexpr std::uint8_t over(std::size_t at, std::size_t n) noexcept {
        const std::size_t end = at + n, from = std::min(end, end_), to = std::max(end, end_);
        const bool close = at - at_ <= step && to - from <= step && from + step <= run_.size();
        if (close && at < end_) value_ ^= fold_xor(word_of_few<step>(run_.data() + at_, at - at_) ^ word_of_few<step>(run_.data() + from, to - from));
        else value_ = xor_of(run_.subspan(at, n));
        at_ = at;
        end_ = end;
        return value_;
    }

private:
    static constexpr std::size_t step = 16;
    std::span<const std::uint8_t> run_;
    std::size_t at_ = 0, end_ = 0;  ///< What `value_` is over.
    std::uint8_t value_ = 0;
};

}  // namespace trama::daisy::recovery
