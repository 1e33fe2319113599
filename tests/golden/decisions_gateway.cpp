// As decisions.cpp, of the gateway's records.
#include "golden/check.hpp"
#include "golden/gateway_limits.hpp"
#include "golden/vectors/gateway_row.hpp"
#include "trama/trama.hpp"

namespace trama::golden {
namespace {

template <class M>
[[gnu::noinline]] result<M> gateway_message(std::span<const std::uint8_t> in) {
    gateway::decoder d;
    const auto e = d.next(in);
    if (e.code != errc::ok) return error{e.code, {}};
    return decode<M>(e.packet);
}

TEST(decisions, d13_send_cargo_id_has_type_23) {
    const auto as = [](const auto& wire) { gateway::decoder d; std::span<const std::uint8_t> in = wire; return d.next(in).packet.type(); };
    constexpr auto cargo = record(" 23", "    1", "    2", "T         ", "C         ");
    constexpr auto command = record(" 21", "    1", "    2", "T         ", "C         ");
    EXPECT_EQ(as(cargo), 23);
    EXPECT_TRUE(gateway_message<gateway::send_cargo_id>(cargo));
    EXPECT_EQ(gateway_message<gateway::send_cargo_id>(command).code(), errc::unknown_message);
    EXPECT_TRUE(gateway_message<gateway::send_command>(command));
}

TEST(decisions, d14_the_text_of_a_nack_has_80_characters) {
    EXPECT_EQ(gateway::nack::layout.size, 101U - 3U);
    EXPECT_EQ(gateway_message<gateway::nack>(record("102", "    1", "    2", "  1", "    3", "0123456789")).code(), errc::bad_length);
}

TEST(decisions, d15_spaces_stand_on_either_side_of_a_number) {
    const gateway::go_node expected{7, 12, 0};
    EXPECT_EQ(gateway_message<gateway::go_node>(record(" 15", "    7", "   12", "    0")), expected);
    EXPECT_EQ(gateway_message<gateway::go_node>(record("15 ", "7    ", "12   ", "     ")), expected);
    EXPECT_EQ(gateway_message<gateway::go_node>(record("015", " 7   ", "00012", "0    ")), expected);
    EXPECT_EQ(gateway_message<gateway::go_node>(record(" 15", "  007", " 012 ", "00000")), expected);
    const auto fails_at = [](std::uint8_t field) { return error{errc::bad_number, {field}}; };
    EXPECT_EQ(gateway_message<gateway::go_node>(record(" 15", "  0 7", "   12", "    0")).error(), fails_at(0));
    EXPECT_EQ(gateway_message<gateway::go_node>(record(" 15", "    7", "  +12", "    0")).error(), fails_at(1));
    EXPECT_EQ(gateway_message<gateway::go_node>(record(" 15", "    7", "   12", "   -0")).error(), fails_at(2));
    EXPECT_EQ(gateway_message<gateway::go_node>(record("   ", "    7", "   12", "    0")).code(), errc::bad_number);
    // The left side is an option of the encoder.
    std::array<std::uint8_t, 20> out{};
    ASSERT_TRUE(gateway::encode(expected, out, gateway::justify::left));
    EXPECT_EQ(out, record("15 ", "7    ", "12   ", "0    "));
}
TEST(decisions, d15_decimals_have_one_digit_behind_the_point_or_none) {
    const auto volts = [](const auto& wire) { return gateway_message<gateway::circuit_state>(wire); };
    const gateway::circuit_state expected{1, 480, 5, 0, {}, {}, {}};
    EXPECT_EQ(volts(record("201", "    1", "   48", "  0.5", "    0", "      0", "0", "0")), expected);
    EXPECT_EQ(volts(record("201", "    1", "48.0 ", "0.5  ", "     ", "       ", " ", " ")), expected);
    EXPECT_EQ(volts(record("201", "    1", "048.0", "000.5", "    0", "      0", "0", "0")), expected);
    EXPECT_EQ(volts(record("201", "    1", "  48.", "  0.5", "    0", "      0", "0", "0")).error(), (error{errc::bad_number, {1}}));
    EXPECT_EQ(volts(record("201", "    1", " 48.0", "   .5", "    0", "      0", "0", "0")).error(), (error{errc::bad_number, {2}}));
    EXPECT_EQ(volts(record("201", "    1", " 1000", "  0.5", "    0", "      0", "0", "0")).error(), (error{errc::bad_number, {1}}));
    EXPECT_EQ(fields_json(expected), R"({"msg_id":1,"circuit_voltage":48.0,"circuit_current":0.5,"working_carts":0,"check":[],"target_mode":"no_power_freezing","mode":"no_power_freezing"})");
}

/// A cart_state with `speed` in the speed's columns and `node` in those of ini_node.
template <std::size_t N, std::size_t K>
constexpr auto cart_with(const char (&speed)[N], const char (&node)[K]) {
    auto wire = record("200", "    0", "    0", "   0", "0", "    0", "  0", "    0", "    0", "    0", "0",
                       "0", "  0", "    0", "    0", "    0", " 0", "          ", "          ", "          ", "0", "          ", "          ", "          ",
                       "0", "  0", "    0", "    0", "    0", " 0", "          ", "          ", "          ", "0", "          ", "          ", "          ");
    for (std::size_t i = 0; i != 5; ++i) wire[1 + 36 + i] = static_cast<std::uint8_t>(speed[i]);
    for (std::size_t i = 0; i != 5; ++i) wire[1 + 18 + i] = static_cast<std::uint8_t>(node[i]);
    return wire;
}
TEST(decisions, d16_speed_alone_may_be_negative) {
    const auto speed = [](const auto& wire) { const auto m = gateway_message<gateway::cart_state>(wire); return m ? m->speed_mms : -100000; };
    EXPECT_EQ(speed(cart_with("-9999", "    0")), -9999);
    EXPECT_EQ(speed(cart_with("  -12", "    0")), -12);
    EXPECT_EQ(speed(cart_with("-12  ", "    0")), -12);
    EXPECT_EQ(speed(cart_with("   -0", "    0")), 0);
    EXPECT_EQ(speed(cart_with("99999", "    0")), 99999);
    EXPECT_EQ(gateway_message<gateway::cart_state>(cart_with(" - 12", "    0")).error(), (error{errc::bad_number, {8}}));
    EXPECT_EQ(gateway_message<gateway::cart_state>(cart_with("    -", "    0")).error(), (error{errc::bad_number, {8}}));
    EXPECT_EQ(gateway_message<gateway::cart_state>(cart_with("  12-", "    0")).error(), (error{errc::bad_number, {8}}));
    EXPECT_EQ(gateway_message<gateway::cart_state>(cart_with("    0", "   -1")).error(), (error{errc::bad_number, {4}}));
}

TEST(decisions, d17_text_keeps_its_characters_and_loses_trailing_spaces_only_when_read) {
    const auto m = gateway_message<gateway::send_command>(record(" 21", "    1", "    2", "  T 1     ", "          "));
    ASSERT_TRUE(m);
    EXPECT_EQ(m->transit_id.view(), "  T 1");
    EXPECT_EQ(m->command.view(), "");
    EXPECT_EQ((text<10>{"A"}), (text<10>{"A "}));
    EXPECT_NE((text<10>{"A"}), (text<10>{" A"}));
    std::array<std::uint8_t, 35> out{};
    ASSERT_TRUE(gateway::encode(*m, out));
    EXPECT_EQ(out, record(" 21", "    1", "    2", "  T 1     ", "          "));
    EXPECT_EQ(gateway::encode(gateway::send_command{1, 2, "12345678901", ""}, out).error(), (error{errc::out_of_range, {2}}));
    EXPECT_EQ(gateway::encode(gateway::send_command{1, 2, "", "\n"}, out).error(), (error{errc::out_of_range, {3}}));
}

TEST(decisions, d18_an_ack_of_idle_processing_names_no_cart) {
    const gateway::ack expected{3, 0, gateway::order_type::idle_processing, 11};
    EXPECT_EQ(gateway_message<gateway::ack>(record("101", "    3", "     ", " 50", "   11")), expected);
    EXPECT_EQ(gateway_message<gateway::ack>(record("101", "    3", "    0", " 50", "   11")), expected);
    EXPECT_TRUE(is_valid(expected));
}

TEST(decisions, d19_every_reply_may_answer_every_order_of_a_client) {
    for (const int type : {1, 2, 3, 10, 15, 20, 21, 22, 23, 30, 50}) {
        const auto src = static_cast<gateway::order_type>(type);
        EXPECT_TRUE(is_valid(gateway::transit_ack{1, 2, src, 3, ""}) && is_valid(gateway::ack{1, 2, src, 3}) && is_valid(gateway::nack{1, 2, src, 3, ""})) << type;
    }
    for (const int type : {0, 4, 51, 100, 101, 102, 200, 201, 999}) {
        const auto src = static_cast<gateway::order_type>(type);
        EXPECT_FALSE(is_valid(gateway::transit_ack{1, 2, src, 3, ""}) || is_valid(gateway::ack{1, 2, src, 3}) || is_valid(gateway::nack{1, 2, src, 3, ""})) << type;
    }
}

TEST(decisions, d20_a_level_is_0_to_15) {
    for (unsigned level = 0; level != 100; ++level) {
        const auto l = static_cast<std::uint8_t>(level);
        gateway::cart_state cart{};
        cart.orders[1].level = l;
        EXPECT_EQ(is_valid(gateway::load{1, 2, 3, 4, l, "", "", ""}), level <= 15) << level;
        EXPECT_EQ(is_valid(gateway::transit{1, 2, 3, 4, l, "", "", ""}), level <= 15) << level;
        EXPECT_EQ(is_valid(gateway::unload{1, 2, 3, 4, l, "", "", ""}), level <= 15) << level;
        EXPECT_EQ(is_valid(cart), level <= 15) << level;
    }
}

}  // namespace
}  // namespace trama::golden
