// What the tables of golden vectors leave open about text output: values without names, escapes, field by field notation.
#include <gtest/gtest.h>

#include <string>

#include "golden/check.hpp"
#include "trama/trama.hpp"

namespace trama::golden {
namespace {

template <class M>
std::string plain(const M& m) {
    std::array<char, 4096> out{};
    const auto size = to_text(m, out);
    return size ? std::string(out.data(), *size) : std::string("does not fit");
}

TEST(json, an_enumerator_without_a_name_is_a_number) {
    EXPECT_EQ(fields_json(daisy::dc_motor::set_direction{static_cast<daisy::direction>(2)}), R"({"direction":2})");
    EXPECT_EQ(fields_json(gateway::ack{1, 2, static_cast<gateway::order_type>(999), 3}), R"({"msg_id":1,"cart_id":2,"src_type":999,"src_msg_id":3})");
    EXPECT_EQ(fields_json(can::define_function{1, 1, static_cast<can::function>(22617), {}, {}, 0, {}}),
              R"({"node":1,"message_id":1,"function":22617,"start":{"year":0,"month":0,"day":0,"hour":0,"minute":0,"second":0},"end":{"year":0,"month":0,"day":0,"hour":0,"minute":0,"second":0},"sensor_count":0,"sensors":[0,0,0,0]})");
}
TEST(json, types_that_no_client_sends_print_as_names_all_the_same) {
    EXPECT_EQ(fields_json(gateway::ack{0, 0, gateway::order_type::none, 0}), R"({"msg_id":0,"cart_id":0,"src_type":"none","src_msg_id":0})");
    EXPECT_EQ(fields_json(gateway::ack{0, 0, gateway::order_type::cart_state, 0}), R"({"msg_id":0,"cart_id":0,"src_type":"cart_state","src_msg_id":0})");
}
TEST(json, a_bit_without_a_name_is_the_number_of_its_value) {
    // 9999 = 8192+1024+512+256+8+4+2+1; the named bits end at 2048
    gateway::cart_state s{};
    s.cart_status = static_cast<gateway::cart_status>(9999);
    EXPECT_NE(fields_json(s).find(R"("cart_status":["cart_error","hook_error","warning","paused","parking","loaded","house_keeping",8192],)"), std::string::npos);
    // 9999999 = 8388608+1048576+524288+32768+4096+1024+512+64+32+16+8+4+2+1; the named bits end at 2097152
    gateway::circuit_state c{};
    c.check = static_cast<gateway::circuit_check>(9999999);
    const std::string text = fields_json(c);
    EXPECT_NE(text.find(R"("circuit_breaker_48v",8388608],)"), std::string::npos) << text;
}
TEST(json, trailing_spaces_are_not_printed_and_quotes_are_escaped) {
    EXPECT_EQ(fields_json(gateway::send_command{1, 2, R"( "a\)", ""}), R"({"msg_id":1,"cart_id":2,"transit_id":" \"a\\","command":""})");
}
TEST(json, every_byte_of_a_description) {
    std::array<std::uint8_t, 251> bytes{};
    std::string expected = R"({"description":")";
    constexpr std::string_view hex = "0123456789abcdef";
    for (unsigned i = 0; i != 251; ++i) {
        const unsigned c = i + 5;  // 5..255
        bytes[i] = static_cast<std::uint8_t>(c);
        if (c == '"') expected += "\\\"";
        else if (c == '\\') expected += "\\\\";
        else if (c >= 0x20 && c < 0x7F) expected += static_cast<char>(c);
        else expected += std::string("\\u00") + hex[c / 16] + hex[c % 16];
    }
    expected += "\"}";
    EXPECT_EQ(fields_json(daisy::common::init_reply{byte_view{bytes}}), expected);
}
TEST(json, a_buffer_too_small_is_an_error_at_every_size) {
    const can::set_clock m{10, 9, 2011, 4, 1, 12, 20, 30};
    const std::string whole = fields_json(m), words = plain(m);
    for (std::size_t room = 0; room <= whole.size(); ++room) {
        std::string out(room + 1, '#');
        const auto size = to_json(m, std::span(out).first(room));
        EXPECT_EQ(size.code(), room < whole.size() ? errc::buffer_too_small : errc::ok) << room;
        EXPECT_EQ(out[room], '#');
    }
    for (std::size_t room = 0; room <= words.size(); ++room) {
        std::string out(room + 1, '#');
        EXPECT_EQ(to_text(m, std::span(out).first(room)).code(), room < words.size() ? errc::buffer_too_small : errc::ok) << room;
    }
}
TEST(json, names_and_values_as_words) {
    EXPECT_EQ(plain(can::set_clock{10, 9, 2011, 4, 1, 12, 20, 30}), "node=10 message_id=9 year=2011 month=4 day=1 hour=12 minute=20 second=30");
    EXPECT_EQ(plain(daisy::servo_motor::switch_alarm{2, daisy::trigger::rising_edge, daisy::state::high}), "switch_id=2 trigger=rising_edge state=high");
    EXPECT_EQ(plain(daisy::common::ping{}), "");
    EXPECT_EQ(plain(daisy::servo_motor::get_all_positions_reply{{1, 2, 3, 4, 5}}), "positions=[1,2,3,4,5]");
}

}  // namespace
}  // namespace trama::golden
