#include "trama/core/window.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "laws/rng.hpp"

namespace trama {
namespace {

TEST(window, reads_two_pieces_as_one_wherever_the_seam_is) {
    test::rng random(2);
    const test::octets bytes = random.bytes(40);
    for (std::size_t seam = 0; seam <= bytes.size(); ++seam) {
        const window w{std::span(bytes).first(seam), std::span(bytes).subspan(seam)};
        ASSERT_EQ(w.size(), bytes.size());
        for (std::size_t i = 0; i != bytes.size(); ++i) ASSERT_EQ(w[i], bytes[i]);
        for (std::size_t at = 0; at <= bytes.size(); ++at)
            for (std::size_t n = 0; at + n <= bytes.size(); ++n) {
                const auto part = std::span(bytes).subspan(at, n);
                ASSERT_EQ(w.xor_of(at, n), xor_of(part)) << seam << ", " << at << ", " << n;
                std::array<std::uint8_t, 40> spare{};
                const auto piece = w.piece(at, n, spare);
                ASSERT_TRUE(std::equal(piece.begin(), piece.end(), part.begin(), part.end()));
                const bool copied = at < seam && at + n > seam;
                if (n != 0) { ASSERT_EQ(piece.data() == spare.data(), copied) << "only what lies in both is copied"; }
            }
    }
}

}  // namespace
}  // namespace trama
