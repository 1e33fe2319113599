#include "trama/gateway/format.hpp"

#include <gtest/gtest.h>

#include <string>

#include "laws/gateway_subject.hpp"
#include "trama/core/print.hpp"

namespace trama::gateway {
namespace {

/// STX and ETX stand as `<` and `>`.
template <class M>
std::string written(const M& m, justify side = justify::right, bool checked = true) {
    std::array<std::uint8_t, max_record> out{};
    const auto size = checked ? format::encode({}, m, out, side) : format::encode_unchecked({}, m, out, side);
    if (!size) return std::string(trama::name_of(size.code()));
    std::string all;
    for (std::size_t i = 0; i != *size; ++i) all += out[i] == stx ? '<' : out[i] == etx ? '>' : static_cast<char>(out[i]);
    return all;
}

TEST(gateway_format, justifies_numbers_on_either_side_and_text_on_the_left) {
    load m{1, 20, 300, 0, 7, "opt", "", "c 1"};
    EXPECT_EQ(written(m), "<  1    1   20  300    0 7opt                 c 1       >");
    EXPECT_EQ(written(m, justify::left), "<1  1    20   300  0    7 opt                 c 1       >");
}

TEST(gateway_format, writes_decimals_and_signs) {
    circuit_state c;
    c.circuit_voltage = 482;
    c.circuit_current = 5;
    EXPECT_EQ(written(c), "<201    0 48.2  0.5    0      000>");
    EXPECT_EQ(written(c, justify::left), "<2010    48.2 0.5  0    0      00>");
    c.circuit_voltage = 9999;
    EXPECT_EQ(written(c).substr(9, 5), "999.9");
    c.circuit_voltage = 10000;
    EXPECT_EQ(written(c, justify::right, false), "out_of_range");
    cart_state s;
    s.speed_mms = -9999;
    EXPECT_EQ(written(s).substr(1 + 3 + 5 + 5 + 4 + 1 + 5 + 3 + 5 + 5, 5), "-9999");
    s.speed_mms = -5;
    EXPECT_EQ(written(s).substr(1 + 3 + 5 + 5 + 4 + 1 + 5 + 3 + 5 + 5, 5), "   -5");
    EXPECT_EQ(written(s, justify::left).substr(1 + 3 + 5 + 5 + 4 + 1 + 5 + 3 + 5 + 5, 5), "-5   ");
    s.speed_mms = -10000;
    EXPECT_EQ(written(s, justify::right, false), "out_of_range");
    s.speed_mms = 99999;
    EXPECT_EQ(written(s).size(), 208U);
}

TEST(gateway_format, left_and_right_decode_to_the_same_message) {
    for (std::uint64_t seed = 1; seed != 301; ++seed) {
        test::rng random(seed);
        SCOPED_TRACE(seed);
        test::memory views;
        messages::at(seed % messages::count, [&]<class M>() {
            const M m = test::random_message<M>(random, test::manners::wild, views);
            for (const justify side : {justify::left, justify::right}) {
                std::array<std::uint8_t, max_record> out{};
                const auto size = format::encode_unchecked({}, m, out, side);
                ASSERT_TRUE(size);
                decoder d;
                std::span<const std::uint8_t> in = std::span(out).first(*size);
                const event e = d.next(in);
                ASSERT_EQ(e.code, errc::ok);
                EXPECT_TRUE(decode<M>(e.packet) == result<M>(m));
            }
        });
    }
}

TEST(gateway_format, text_that_would_break_the_framing_is_refused_even_unchecked) {
    send_command m{1, 2, "t1", "go"};
    EXPECT_EQ(written(m, justify::right, false).size(), 35U);
    for (const char c : {'\x02', '\x03', '\n', '\0', '\x7F', '\xE1'}) {
        m.command = std::string_view(&c, 1);
        EXPECT_EQ(written(m), "out_of_range");
        EXPECT_EQ(written(m, justify::right, false), "out_of_range");
    }
    m.command = "longer than ten";
    EXPECT_EQ(written(m, justify::right, false), "out_of_range");
    m.command = "exactly 10";
    EXPECT_EQ(written(m).size(), 35U);
}

TEST(gateway_format, a_violation_is_written_only_unchecked) {
    load m;
    m.level = 16;
    EXPECT_EQ(written(m), "out_of_range");
    EXPECT_EQ(written(m, justify::right, false).substr(24, 2), "16");
    m.level = 100;
    EXPECT_EQ(written(m, justify::right, false), "out_of_range") << "two columns carry 0..99";
    go_node n;
    n.msg_id = 100000;
    EXPECT_EQ(written(n, justify::right, false), "out_of_range");
    ack a;
    EXPECT_EQ(written(a), "out_of_range") << "no order is answered";
    EXPECT_EQ(written(a, justify::right, false), "<101    0    0  0    0>");
}

TEST(gateway_format, the_free_encoders_are_those_of_the_format) {
    load m{1, 20, 300, 0, 16, "opt", "", "c 1"};
    for (const justify side : {justify::right, justify::left}) {
        std::array<std::uint8_t, max_record> free{}, own{};
        EXPECT_EQ(encode(m, free, side).error(), (error{errc::out_of_range, {4}}));
        EXPECT_EQ(encode_unchecked(m, free, side), format::encode_unchecked({}, m, own, side));
        EXPECT_EQ(free, own);
        EXPECT_EQ(free[24], '1');
    }
    std::array<std::uint8_t, max_record> free{}, own{};
    EXPECT_EQ(encode_unchecked(m, free).value_or(0), 57U);
    EXPECT_TRUE(encode_unchecked(m, own, justify::right));
    EXPECT_EQ(free, own);
    m.level = 7;
    EXPECT_EQ(encode(m, free), format::encode({}, m, own, justify::right));
    EXPECT_EQ(free, own);
    m.level = 100;
    EXPECT_EQ(encode_unchecked(m, free).error(), (error{errc::out_of_range, {4}}));
}

TEST(gateway_format, sizes_are_those_of_the_table) {
    const auto payload = []<class M>(const M& m) { return format::encoded_size(m) - 2; };
    EXPECT_EQ(payload(load{}), 55U);
    EXPECT_EQ(payload(transit{}), 55U);
    EXPECT_EQ(payload(unload{}), 55U);
    EXPECT_EQ(payload(go_parking{}), 18U);
    EXPECT_EQ(payload(go_node{}), 18U);
    EXPECT_EQ(payload(cancel_transits{}), 13U);
    EXPECT_EQ(payload(send_command{}), 33U);
    EXPECT_EQ(payload(send_inputs{}), 33U);
    EXPECT_EQ(payload(send_cargo_id{}), 33U) << "[D13]";
    EXPECT_EQ(payload(cross_granted{}), 18U);
    EXPECT_EQ(payload(idle_processing{}), 8U);
    EXPECT_EQ(payload(transit_ack{}), 31U);
    EXPECT_EQ(payload(ack{}), 21U);
    EXPECT_EQ(payload(nack{}), 101U) << "[D14]";
    EXPECT_EQ(payload(cart_state{}), 206U);
    EXPECT_EQ(payload(circuit_state{}), 32U);
    EXPECT_EQ(messages::count, 16U);
}

TEST(gateway_format, a_blank_field_reads_as_zero_but_a_blank_type_does_not_D15) {
    const std::string blank = "\x02" "101" + std::string(18, ' ') + "\x03";
    decoder d;
    const test::octets bytes(blank.begin(), blank.end());
    std::span<const std::uint8_t> in(bytes);
    const event e = d.next(in);
    ASSERT_EQ(e.code, errc::ok);
    const auto m = decode<ack>(e.packet);
    ASSERT_TRUE(m);
    EXPECT_EQ(*m, ack{}) << "[D18]: an ack of idle_processing has no cart to name";
}

}  // namespace
}  // namespace trama::gateway
