#include "trama/core/body.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "trama/trama.hpp"

namespace trama {
namespace {

using octets = std::vector<std::uint8_t>;

template <class M>
error loaded(const octets& body, M& m) {
    return load_body(std::span<const std::uint8_t>(body), m);
}

TEST(codec, a_fixed_body_has_exactly_its_size) {
    daisy::dc_motor::set_dc_speed m;
    for (std::size_t n = 0; n != 8; ++n) EXPECT_EQ(loaded(octets(n), m).code, n == 3 ? errc::ok : errc::bad_length) << n;
    EXPECT_EQ(loaded({1, 0xD4, 0xFE}, m).code, errc::ok);
    EXPECT_EQ(m.direction, daisy::direction::counter_clockwise);
    EXPECT_EQ(m.speed, -300);
}

TEST(codec, readings_are_as_many_as_the_mask_has_bits) {
    for (unsigned mask = 0; mask != 256; ++mask)
        for (std::size_t n = 0; n != 20; ++n) {
            octets body(n);
            if (n != 0) body[0] = static_cast<std::uint8_t>(mask);
            daisy::distance_sensor::get_value_reply m;
            const bool right = n == 1 + 2 * static_cast<std::size_t>(std::popcount(mask));
            ASSERT_EQ(loaded(body, m).code, right ? errc::ok : errc::bad_length) << mask << ", " << n;
            ASSERT_EQ((daisy::distance_sensor::get_value_reply::body_fits(n, n == 0 ? nullptr : body.data())), right) << mask << ", " << n;
            if (right) { ASSERT_EQ(m.readings.size(), m.expected_count()); }
        }
}

TEST(codec, an_error_has_its_rejected_packet_only_for_code_0) {
    daisy::common::error m;
    for (std::size_t n = 0; n != 30; ++n) {
        octets body(n, 7);
        EXPECT_EQ(loaded(body, m).code, n == 1 ? errc::ok : errc::bad_length) << n;
        if (n == 0) continue;
        body[0] = 0;
        EXPECT_EQ(loaded(body, m).code, n >= 7 ? errc::ok : errc::bad_length) << n;
        if (n >= 7) { EXPECT_EQ(m.rejected.size(), n - 2); }
    }
}

TEST(codec, a_text_is_all_there_is) {
    daisy::common::init_reply m;
    for (std::size_t n = 0; n <= 251; ++n) {
        const octets body(n, 'x');
        EXPECT_EQ(loaded(body, m).code, errc::ok);
        EXPECT_EQ(m.description.size(), n);
        EXPECT_EQ(body_size(m), n);
    }
}

/// Spoils each number of a message in turn: the error names that field, and with two of them the first.
template <class M>
void expect_located() {
    octets body(M::layout.size, ' ');
    M m;
    ASSERT_FALSE(loaded(body, m));
    std::vector<std::pair<std::size_t, field_ref>> numbers;
    each_index<M>([&]<std::size_t I>() {
        using wire_type = typename std::remove_cvref_t<decltype(field_of<M, I>)>::wire_type;
        if constexpr (requires { wire_type::decimal; }) numbers.push_back({M::layout.offsets[I], {static_cast<std::uint8_t>(I)}});
        if constexpr (requires { wire_type::element::value::layout; }) {
            using inner = typename wire_type::element::value;
            for (std::size_t i = 0; i != wire_type::count; ++i)
                each_index<inner>([&]<std::size_t J>() {
                    if constexpr (requires { std::remove_cvref_t<decltype(field_of<inner, J>)>::wire_type::decimal; })
                        numbers.push_back({M::layout.offsets[I] + i * inner::layout.size + inner::layout.offsets[J], {static_cast<std::uint8_t>(I), static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(J)}});
                });
        }
    });
    for (std::size_t i = 0; i != numbers.size(); ++i)
        for (std::size_t j = i; j != numbers.size(); ++j) {
            octets bad = body;
            bad[numbers[i].first] = bad[numbers[j].first] = '*';
            EXPECT_EQ(loaded(bad, m), (error{errc::bad_number, numbers[i].second})) << M::name << ", " << i << ", " << j;
        }
}
TEST(codec, a_malformed_number_is_located) {
    expect_located<gateway::cart_state>();
    expect_located<gateway::circuit_state>();
    expect_located<gateway::load>();
    expect_located<gateway::nack>();
}

TEST(codec, signed_numbers_and_tenths_of_the_gateway) {
    octets body(gateway::cart_state::layout.size, ' ');
    gateway::cart_state m;
    const auto speed_at = gateway::cart_state::layout.offsets[8];
    const auto put = [&](std::string_view s) { std::copy(s.begin(), s.end(), body.begin() + static_cast<std::ptrdiff_t>(speed_at)); };
    put("-0   ");
    EXPECT_FALSE(loaded(body, m));
    EXPECT_EQ(m.speed_mms, 0) << "[D16]";
    put(" -12 ");
    EXPECT_FALSE(loaded(body, m));
    EXPECT_EQ(m.speed_mms, -12);
    for (const std::string_view bad : {"- 12 ", "-    ", "--1  ", "1-   ", "+1   ", " 1-2 "}) {
        put(bad);
        EXPECT_EQ(loaded(body, m), (error{errc::bad_number, {8}})) << bad;
    }
    put("     ");
    body[0] = '-';
    body[1] = '1';
    EXPECT_EQ(loaded(body, m), (error{errc::bad_number, {0}})) << "speed alone may be negative";
}

}  // namespace
}  // namespace trama
