// Each place where a source document contradicts itself or is silent, and how it is read: one test for each decision.
// Those of daisy and can; decisions_gateway.cpp has the others.
#include "golden/check.hpp"
#include "golden/limits.hpp"
#include "golden/vectors/can_row.hpp"
#include "trama/trama.hpp"

namespace trama::golden {
namespace {

using daisy::envelope, daisy::trigger, daisy::state;
using daisy_errc = std::pair<errc, std::size_t>;

/// The first event of a daisy stream behind a ping, which puts the decoder in step.
/// Not inline: with the array's size in sight g++ 12 warns about reads that the decoder's own size check rules out.
[[gnu::noinline]] daisy_errc second_event(std::span<const std::uint8_t> wire) {
    constexpr auto ping = octets("04 11 00 03 16");
    daisy::decoder d;
    std::span<const std::uint8_t> in = ping;
    EXPECT_EQ(d.next(in).code, errc::ok);
    in = wire;
    const auto e = d.next(in);
    return {e.code, e.packet.index()};
}
errc code_of(std::span<const std::uint8_t> wire) { return second_event(wire).first; }
template <class M>
bool is_a(std::span<const std::uint8_t> wire) {
    const auto [code, index] = second_event(wire);
    bool same = false;
    if (code == errc::ok) daisy::messages::at(index, [&]<class Found>() { same = std::is_same_v<Found, M>; });
    return same;
}
template <class F, class M>
[[gnu::noinline]] result<M> decoded(std::span<const typename F::unit> in) {
    typename F::decoder d;
    const auto e = d.next(in);
    if (e.code != errc::ok) return error{e.code, {}};
    return decode<M>(e.packet);
}

template <class M>
result<M> can_message(const std::vector<can::frame>& frames) { return decoded<can::format, M>(frames); }

TEST(decisions, d1_no_family_defines_0x7e_or_0x7f) {
    for (unsigned group = 0; group != 7; ++group)
        for (const unsigned command : {0x7EU, 0x7FU, 0xFEU, 0xFFU}) {
            const bool response = command >= 0x80;
            const auto board = static_cast<std::uint8_t>(group << 4 | 1);
            std::array<std::uint8_t, 5> p{0x04, response ? std::uint8_t{0} : board, response ? board : std::uint8_t{0}, static_cast<std::uint8_t>(command), 0};
            p[4] = static_cast<std::uint8_t>(p[0] ^ p[1] ^ p[2] ^ p[3]);
            EXPECT_EQ(code_of(p), errc::unknown_message) << group << ' ' << command;
        }
}

TEST(decisions, d2_group_6_is_a_second_group_of_battery_controllers) {
    using namespace daisy::battery_controller;
    EXPECT_TRUE(is_a<battery_empty_alarm>(octets("06 00 62 45 6B 03 49")));  // §12.2
    EXPECT_TRUE(is_a<battery_empty_alarm>(octets("06 00 42 45 6B 03 69")));  // the same from group 4: 49^62^42 = 69
    EXPECT_TRUE(is_a<enable>(octets("04 62 00 40 26")));                     // 04^62^00^40 = 26
    EXPECT_TRUE(is_a<enable_reply>(octets("04 00 62 C0 A6")));               // 04^00^62^C0 = A6
    // The encoder keeps the address that it is given.
    for (const std::uint8_t board : {std::uint8_t{0x42}, std::uint8_t{0x62}}) {
        std::array<std::uint8_t, 7> out{};
        ASSERT_TRUE(daisy::encode({{0x00}, {board}}, battery_empty_alarm{0x036B}, out));
        EXPECT_EQ(out[2], board);
    }
}

TEST(decisions, d3_requests_belong_to_the_destination_and_responses_to_the_source) {
    // 40 between a motor and a servo board, both ways. LEN tells: set_direction has one byte, set_position two.
    EXPECT_TRUE(is_a<daisy::dc_motor::set_direction>(octets("05 11 21 40 00 75")));              // 05^11^21^40^00 = 75
    EXPECT_TRUE(is_a<daisy::servo_motor::set_position>(octets("06 21 11 40 00 00 76")));         // 06^21^11^40 = 76
    EXPECT_TRUE(is_a<daisy::dc_motor::get_encoder_reply>(octets("08 21 11 C3 01 00 00 00 FA"))); // 08^21^11^C3^01 = FA
    EXPECT_TRUE(is_a<daisy::servo_motor::get_all_positions_reply>(octets("09 11 21 C3 01 02 03 04 05 FB")));
    // Where that end is the main controller, the other end decides.
    EXPECT_TRUE(is_a<daisy::dc_motor::motor_stress_alarm>(octets("06 00 11 49 00 01 5F")));      // 06^00^11^49^00^01 = 5F
    EXPECT_TRUE(is_a<daisy::dc_motor::motor_stress_alarm_reply>(octets("04 11 00 C9 DC")));      // 04^11^00^C9 = DC
    EXPECT_EQ(code_of(octets("05 00 00 40 00 45")), errc::unknown_message);                      // main to main
    EXPECT_EQ(code_of(octets("04 71 00 40 35")), errc::unknown_message);                         // no such group
    EXPECT_EQ(code_of(octets("04 FF 00 43 B8")), errc::unknown_message);                         // everyone is no family
    EXPECT_EQ(code_of(octets("04 51 00 43 16")), errc::unknown_message);                         // trash bins end at 42
    // Encoders refuse addresses of another family and name the destination.
    const error wrong_family{errc::out_of_range, {field_ref::destination}};
    std::array<std::uint8_t, 16> out{};
    const auto refused_between = [&](std::uint8_t to, std::uint8_t from, const auto& m) {
        return daisy::format::encode({{to}, {from}}, m, out).error() == wrong_family && daisy::format::encode_unchecked({{to}, {from}}, m, out).error() == wrong_family;
    };
    EXPECT_TRUE(refused_between(0x21, 0x00, daisy::dc_motor::set_direction{}));
    EXPECT_TRUE(refused_between(0x21, 0x11, daisy::dc_motor::set_direction{}));
    EXPECT_TRUE(refused_between(0x00, 0x00, daisy::dc_motor::set_direction{}));
    EXPECT_TRUE(refused_between(0xFF, 0x00, daisy::dc_motor::set_direction{}));
    EXPECT_TRUE(refused_between(0x11, 0x21, daisy::dc_motor::set_direction_reply{}));
    EXPECT_TRUE(daisy::encode({{0x11}, {0x21}}, daisy::dc_motor::set_direction{}, out));
    EXPECT_TRUE(daisy::encode({{0x00}, {0x11}}, daisy::dc_motor::motor_stress_alarm{}, out));
}

TEST(decisions, d4_switch_alarm_carries_trigger_then_state) {
    // LEN 4+2 = 06; CRC 06^00^31^47^02^01 = 73
    const auto m = decoded<daisy::format, daisy::distance_sensor::switch_alarm>(octets("06 00 31 47 02 01 73"));
    ASSERT_TRUE(m);
    EXPECT_EQ(m->trigger, trigger::falling_edge);
    EXPECT_EQ(m->state, state::high);
    // LEN 4+3 = 07; CRC 07^00^21^4C^05^01^00 = 6E
    const auto s = decoded<daisy::format, daisy::servo_motor::switch_alarm>(octets("07 00 21 4C 05 01 00 6E"));
    ASSERT_TRUE(s);
    EXPECT_EQ(*s, (daisy::servo_motor::switch_alarm{5, trigger::rising_edge, state::low}));
    // Both in one byte would be LEN 05, which the message cannot have: in step a fault, whatever its CRC.
    constexpr auto one_byte = octets("04 11 00 03 16 05 00 31 47 02 71");
    std::string events;
    daisy::decoder d;
    (void)properties::feed<daisy::format>(d, one_byte, [](std::size_t) { return std::size_t{99}; }, [&](const auto& e) { events += std::string(name_of(e.code)) + ' '; });
    EXPECT_EQ(events, "ok bad_length ");
}

TEST(decisions, d5_a_rejected_packet_of_more_than_249_bytes_is_never_cut) {
    std::array<std::uint8_t, 256> rejected{};
    std::array<std::uint8_t, 256> out{};
    const envelope e{{0x11}, {0x00}};
    const auto send = [&](std::size_t n) { return daisy::encode(e, daisy::common::error{0, byte_view{std::span(rejected).first(n)}, 0}, out); };
    const auto longest = send(249);  // 4 header bytes, code, 249, expected_crc, CRC: 256
    ASSERT_TRUE(longest);
    EXPECT_EQ(*longest, 256U);
    EXPECT_EQ(out[0], 255);
    for (const std::size_t n : {std::size_t{250}, std::size_t{251}, std::size_t{256}}) EXPECT_EQ(send(n).error(), (error{errc::out_of_range, {1}})) << n;
    for (const std::size_t n : {std::size_t{0}, std::size_t{4}}) EXPECT_EQ(send(n).error(), (error{errc::out_of_range, {1}})) << n;
}

TEST(decisions, d6_requests_and_replies_bear_the_same_identifier) {
    using namespace can;
    const std::vector<frame> bus{data(0x81, 2, 4, 'R'), data(0x81, 2, 4, 'R', 1, 7, 100, 0, 0), data(0x83, 0, 0, 0, 0), data(0x81, 0, 0, 0, 0), data(0x7F, 1, 2, 'R')};
    reassembler r;
    std::span<const frame> in = bus;
    const auto request = r.next(in);
    EXPECT_EQ(request.id, 0x81U);
    EXPECT_TRUE(decode<read_sensors>(request.packet));
    const auto reply = r.next(in);
    EXPECT_EQ(reply.id, 0x81U);
    EXPECT_TRUE(decode<sensor_readings>(reply.packet));
    EXPECT_EQ(r.next(in).code, errc::need_more);
    EXPECT_EQ(r.counters().foreign, 2U);
}

TEST(decisions, d7_continuation_frames_carry_no_header) {
    using namespace can;
    // The second frame looks like the head of another define_function and is day, year, month ... all the same.
    const auto m = can_message<define_function>({data(0x80, 1, 2, 'F', 'I', 'A', 20, 11, 3), data(0x80, 1, 2, 70, 3, 4, 5, 6, 7), data(0x80, 8, 9, 10, 0, 0, 0, 0, 0)});
    ASSERT_TRUE(m);
    EXPECT_EQ(m->start, (moment{2011, 3, 1, 5, 6, 7}));
    EXPECT_EQ(m->end, (moment{270, 3, 4, 8, 9, 10}));  // 2*100 + 'F'
}

TEST(decisions, d8_four_sensors_fit_and_more_are_a_violation) {
    using namespace can;
    const auto six = can_message<define_function>({data(0x80, 1, 2, 'F', 'C', 'S', 0, 0, 0), data(0x80, 0, 0, 0, 0, 0, 0, 0, 0), data(0x80, 0, 0, 0, 6, 0, 1, 2, 3)});
    ASSERT_TRUE(six);
    EXPECT_EQ(six->sensor_count, 6);
    EXPECT_EQ(violations_text(*six), "sensor_count 6 1..4\n");
    const auto readings = can_message<sensor_readings>({data(0x80, 1, 2, 'R', 5, 0, 1, 2, 3), data(0x80, 4, 5, 6, 7)});
    ASSERT_TRUE(readings);
    EXPECT_EQ(violations_text(*readings), "sensor_count 5 0..4\n");
}

TEST(decisions, d9_readings_always_take_two_frames) {
    using namespace can;
    for (std::uint8_t count = 0; count <= 4; ++count) {
        std::array<frame, 3> out{};
        const auto frames = can::encode({0x81}, sensor_readings{1, 2, count, {}}, out);
        ASSERT_TRUE(frames);
        EXPECT_EQ(*frames, 2U);
        EXPECT_EQ(out[0].length, 8);
        EXPECT_EQ(out[1].length, 4);
    }
}

TEST(decisions, d10_any_state_is_allowed) {
    for (unsigned state = 0; state != 256; ++state) {
        EXPECT_TRUE(is_valid(can::actuator_state{1, 2, 3, static_cast<std::uint8_t>(state)}));
        EXPECT_TRUE(is_valid(can::set_actuator{1, 2, 3, static_cast<std::uint8_t>(state)}));
    }
}

TEST(decisions, d11_set_clock_may_have_any_node) {
    EXPECT_EQ(can::global_node, 99);
    for (unsigned node = 0; node != 256; ++node) EXPECT_TRUE(is_valid(can::set_clock{static_cast<std::uint8_t>(node), 9, 2011, 4, 1, 12, 20, 30}));
    const auto example = can_message<can::set_clock>({data(0x80, 10, 9, 'C', 20, 11, 4, 1, 12), data(0x80, 20, 30)});
    ASSERT_TRUE(example);
    EXPECT_EQ(example->node, 10);
}

TEST(decisions, d12_the_printed_example_of_m_is_an_actuator_state) {
    EXPECT_TRUE(can_message<can::actuator_state>({data(0x81, 1, 7, 'A', 0, 0)}));
    EXPECT_EQ(can_message<can::set_actuator>({data(0x81, 1, 7, 'A', 0, 0)}).code(), errc::unknown_message);
    EXPECT_TRUE(can_message<can::set_actuator>({data(0x81, 1, 7, 'M', 0, 0)}));
    EXPECT_TRUE(can::is_echo_of(can::set_actuator{1, 7, 0, 0}, can::set_actuator{1, 7, 0, 0}));
    EXPECT_FALSE(can::is_echo_of(can::set_actuator{1, 7, 0, 0}, can::set_actuator{1, 7, 0, 1}));
}

}  // namespace
}  // namespace trama::golden
