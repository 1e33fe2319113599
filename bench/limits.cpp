#include "limits.hpp"

#include <algorithm>
#include <cstring>
#include <memory>

#if defined(__SSE2__)
#include <emmintrin.h>
#elif defined(__ARM_NEON) && defined(__aarch64__)
#include <arm_neon.h>
#endif

namespace trama::bench {

tally copy_all(std::span<const std::uint8_t> in, std::vector<std::uint8_t>& out) {
    std::memcpy(out.data(), in.data(), in.size());
    return {0, out[in.size() / 2], 0};
}

tally read_all(std::span<const std::uint8_t> in) {
    std::uint64_t sums[8] = {};
    std::size_t at = 0;
    for (; at + 64 <= in.size(); at += 64)
        for (std::size_t i = 0; i != 8; ++i) {
            std::uint64_t word;
            std::memcpy(&word, in.data() + at + 8 * i, sizeof word);
            sums[i] += word;
        }
    std::uint64_t sum = 0;
    for (const std::uint64_t s : sums) sum += s;
    for (; at != in.size(); ++at) sum += in[at];
    return {0, sum, 0};
}

namespace {

/// Bytes that may stand in a stream of intact records: printable, STX, ETX.
bool allowed(std::uint8_t c) { return static_cast<std::uint8_t>(c - 2) <= 0x7E - 2; }

}  // namespace

// The limit only looks for bytes that no record may hold anywhere. It leaves the controls above ETX out, which costs nothing.
tally check_printable(std::span<const std::uint8_t> in) {
    std::size_t at = 0;
    bool good = true;
#if defined(__SSE2__)
    __m128i worst[4] = {};
    for (; at + 64 <= in.size(); at += 64)
        for (std::size_t i = 0; i != 4; ++i) {
            __m128i x;
            std::memcpy(&x, in.data() + at + 16 * i, sizeof x);
            worst[i] = _mm_max_epu8(worst[i], _mm_sub_epi8(x, _mm_set1_epi8(2)));
        }
    worst[0] = _mm_max_epu8(_mm_max_epu8(worst[0], worst[1]), _mm_max_epu8(worst[2], worst[3]));
    std::uint8_t most[16];
    std::memcpy(most, worst, sizeof most);
    good = *std::max_element(most, most + 16) <= 0x7E - 2;
#elif defined(__ARM_NEON) && defined(__aarch64__)
    uint8x16_t worst = vdupq_n_u8(0);
    for (; at + 16 <= in.size(); at += 16) worst = vmaxq_u8(worst, vsubq_u8(vld1q_u8(in.data() + at), vdupq_n_u8(2)));
    good = vmaxvq_u8(worst) <= 0x7E - 2;
#endif
    for (; at != in.size(); ++at) good &= allowed(in[at]);
    return {0, good ? 1U : 0U, 0};
}

void add_memory_limits(race& r, std::span<const std::uint8_t> in, std::uint64_t messages) {
    const auto out = std::make_shared<std::vector<std::uint8_t>>(in.size());
    r.contenders.push_back({"memcpy", "whole", role::limit, in.size(), messages, [in, out] { return copy_all(in, *out); }});
    r.contenders.push_back({"vector pass", "whole", role::limit, in.size(), messages, [in] { return read_all(in); }});
}

}  // namespace trama::bench
