#include "trama/core/validate.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "laws/random_message.hpp"
#include "trama/trama.hpp"

namespace trama {
namespace {

/// `field=value allowed` of every violation, in order.
template <class M>
std::vector<std::string> complaints(const M& m) {
    std::vector<std::string> all;
    for (const violation& v : validate(m)) {
        std::array<char, 256> buffer;
        text_sink out(buffer);
        print_path<M>(out, v.field);
        out << '=' << v.value << ' ';
        out.allowed(*v.allowed);
        all.emplace_back(out.view());
    }
    EXPECT_EQ(all.empty(), is_valid(m));
    return all;
}
using list = std::vector<std::string>;

TEST(validate, a_default_message_of_plain_numbers_is_valid) {
    EXPECT_EQ(complaints(daisy::servo_motor::set_position{}), list{});
    EXPECT_EQ(complaints(gateway::cart_state{}), list{});
}

TEST(validate, names_every_violation_in_field_order) {
    EXPECT_EQ(complaints(daisy::servo_motor::set_position{5, 181}), (list{"servo_id=5 0..4", "position=181 0..180"}));
    EXPECT_EQ(complaints(daisy::dc_motor::set_direction{static_cast<daisy::direction>(2)}), list{"direction=2 clockwise|counter_clockwise"});
    EXPECT_EQ(complaints(daisy::servo_motor::set_all_positions{{0, 181, 180, 255, 1}}), (list{"positions[1]=181 0..180", "positions[3]=255 0..180"}));
}

TEST(validate, readings_are_judged_by_the_sensor_they_belong_to) {
    daisy::distance_sensor::get_value_reply m;
    m.sensors = 0x3F;
    m.readings = {1023, 1024, 0, 0, 65535, 30100};
    EXPECT_EQ(complaints(m), (list{"readings[1]=1024 0..1023", "readings[4]=65535 0..1023"}));
    m.readings[5] = 30101;
    m.readings[1] = m.readings[4] = 0;
    EXPECT_EQ(complaints(m), list{"readings[5]=30101 0..30100|65535"});
    m.readings[5] = 65535;
    EXPECT_EQ(complaints(m), list{});
    m.sensors = 0xE0;
    m.readings = {65535, 0, 5};
    EXPECT_EQ(complaints(m), (list{"sensors=224 0..63", "readings[1]=0 no such sensor", "readings[2]=5 no such sensor"}));
}

TEST(validate, a_list_has_the_length_that_the_message_announces) {
    daisy::distance_sensor::get_one_value_reply m;
    m.sensors = 3;
    m.readings = {1};
    EXPECT_EQ(complaints(m).size(), 1U);
    EXPECT_FALSE(fits_wire(m));
    EXPECT_EQ(unfit(m).field.field, 1);
    m.readings = {1, 2};
    EXPECT_TRUE(is_valid(m));
}

TEST(validate, a_field_that_does_not_exist_must_be_empty) {
    const std::array<std::uint8_t, 5> rejected{4, 0x11, 0, 0x43, 0x57};
    EXPECT_TRUE(is_valid(daisy::common::error{0, byte_view(rejected), 1}));
    EXPECT_EQ(complaints(daisy::common::error{0, byte_view(std::span(rejected).first(4)), 1}), list{"rejected=4 5..249 bytes"});
    EXPECT_FALSE(is_valid(daisy::common::error{1, byte_view(rejected), 0}));
    EXPECT_FALSE(is_valid(daisy::common::error{1, {}, 9}));
    EXPECT_TRUE(is_valid(daisy::common::error{1, {}, 0}));
}

TEST(validate, a_rejected_packet_of_more_than_249_bytes_does_not_fit_D5) {
    const test::octets big(250, 1);
    const daisy::common::error m{0, byte_view(big), 1};
    EXPECT_EQ(complaints(m), list{"rejected=250 5..249 bytes"});
    EXPECT_FALSE(fits_wire(m));
    const daisy::common::error fits{0, byte_view(std::span(big).first(249)), 1};
    EXPECT_TRUE(is_valid(fits));
    EXPECT_EQ(daisy::format::encoded_size(fits), 256U);
}

TEST(validate, the_function_decides_about_start_end_and_sensors) {
    can::define_function m;
    EXPECT_EQ(complaints(m), list{"function=0 continuous_all|continuous_specific|sleep|interval_all|interval_specific"});
    m.function = can::function::sleep;
    m.start.year = 2011;
    m.sensor_count = 1;
    m.sensors[0] = 5;
    EXPECT_EQ(complaints(m), (list{"start.year=2011 0", "sensor_count=1 0"}));
    m = {};
    m.function = can::function::interval_specific;
    EXPECT_EQ(complaints(m), (list{"start.month=0 1..12", "start.day=0 1..31", "end.month=0 1..12", "end.day=0 1..31", "sensor_count=0 1..4"}));
    m.start = m.end = {2011, 12, 31, 23, 59, 59};
    m.sensor_count = 4;
    EXPECT_EQ(complaints(m), list{});
    m.end = {2011, 13, 32, 24, 60, 60};
    m.sensor_count = 5;
    m.sensors[3] = 1;
    EXPECT_EQ(complaints(m), (list{"end.month=13 1..12", "end.day=32 1..31", "end.hour=24 0..23", "end.minute=60 0..59", "end.second=60 0..59", "sensor_count=5 1..4"}));
    m = {};
    m.function = static_cast<can::function>(0x5858);
    m.sensor_count = 5;
    m.end.second = 1;
    EXPECT_EQ(complaints(m)[1], "end.second=1 0");
    EXPECT_EQ(complaints(m)[2], "sensor_count=5 0..4");
}

TEST(validate, slots_past_the_count_must_be_zero) {
    can::sensor_readings m;
    m.sensor_count = 1;
    m.readings = {{{1, 2}, {0, 3}, {4, 0}, {0, 0}}};
    EXPECT_EQ(complaints(m), (list{"readings[1].value=3 0", "readings[2].sensor=4 0"}));
    m.message_id = 201;
    m.sensor_count = 9;
    EXPECT_EQ(complaints(m), (list{"message_id=201 0..200", "sensor_count=9 0..4"}));
}

TEST(validate, order_types_are_those_that_fit_the_place) {
    gateway::ack m;
    const std::string clients = "load|transit|unload|go_parking|go_node|cancel_transits|send_command|send_inputs|send_cargo_id|cross_granted|idle_processing";
    EXPECT_EQ(complaints(m), list{"src_type=0 " + clients});
    m.src_type = gateway::order_type::ack;
    EXPECT_EQ(complaints(m), list{"src_type=101 " + clients});
    m.src_type = gateway::order_type::idle_processing;
    EXPECT_EQ(complaints(m), list{});
    gateway::cart_state s;
    s.orders[1].type = gateway::order_type::cancel_transits;
    s.orders[0].level = 16;
    s.rel_position = 101;
    s.cross_confirmation_needed = 2;
    s.cart_status = static_cast<gateway::cart_status>(0x1000);
    EXPECT_EQ(complaints(s), (list{"rel_position=101 0..100", "cross_confirmation_needed=2 0..1", "orders[0].level=16 0..15", "orders[1].type=20 none|load|transit|unload|go_parking|go_node"}));
}

TEST(validate, what_the_columns_cannot_carry_is_a_violation_too) {
    gateway::idle_processing m{100000};
    EXPECT_EQ(complaints(m), list{"msg_id=100000 0..99999"});
    EXPECT_FALSE(fits_wire(m));
    gateway::cart_state s;
    s.speed_mms = -10000;
    EXPECT_EQ(complaints(s), list{"speed_mms=-10000 -9999..99999"});
    EXPECT_EQ(unfit(s).field.field, 8);
    s = {};
    s.orders[1].cargo_id = std::string_view("a\x03" "b");
    EXPECT_EQ(complaints(s), list{"orders[1].cargo_id=3 printable ASCII"});
    EXPECT_EQ(refusal(s).field, (field_ref{10, 1, 8}));
    s.orders[1].cargo_id = std::string("eleven long");
    EXPECT_EQ(complaints(s), list{"orders[1].cargo_id=0 a text that fits the field; 0 stands for one that does not"});
}

TEST(validate, says_what_the_document_allows_where_the_wire_cannot_carry_the_value_either) {
    gateway::ack m;
    m.src_type = static_cast<gateway::order_type>(1000);
    EXPECT_EQ(complaints(m)[0].substr(0, 32), "src_type=1000 load|transit|unloa");
    gateway::circuit_state c;
    c.mode = static_cast<gateway::circuit_mode>(10);
    EXPECT_EQ(complaints(c)[0].substr(0, 33), "mode=10 no_power_freezing|no_powe");
    gateway::cart_state s;
    s.orders[0].level = 100;
    EXPECT_EQ(complaints(s), list{"orders[0].level=100 0..15"});
    s = {};
    s.cart_status = static_cast<gateway::cart_status>(10000);
    EXPECT_EQ(complaints(s), list{"cart_status=10000 0..9999"}) << "of flags the document allows all";
}

TEST(validate, a_list_of_violations_has_room_for_all_of_them) {
    const auto worst = [] {
        can::define_function m;
        m.message_id = 255;
        m.start = m.end = {1, 99, 99, 99, 99, 99};
        m.sensor_count = 0;
        m.sensors = {1, 1, 1, 1};
        return m;
    }();
    std::size_t n = 0;
    for_each_violation(worst, [&](const violation&) { ++n; });
    EXPECT_EQ(validate(worst).size(), n);
    EXPECT_EQ(n, 18U);
}

template <class Format>
void expect_agreement() {
    test::memory views;
    Format::messages::each([&]<class M>() {
        for (std::uint64_t seed = 1; seed != 31; ++seed) {
            test::rng random(seed);
            const M m = test::random_message<M>(random, seed % 2 == 0 ? test::manners::valid : test::manners::wild, views);
            const auto all = validate(m);
            EXPECT_EQ(all.empty(), is_valid(m));
            EXPECT_EQ(bool(refusal(m)), !all.empty());
            if (!all.empty()) { EXPECT_EQ(refusal(m).field, all[0].field); }
            EXPECT_EQ(fits_wire(m), !unfit(m));
            for (std::size_t i = 1; i < all.size(); ++i) EXPECT_NE(all[i].field, all[i - 1].field) << M::name << ", seed " << seed;
        }
    });
}
TEST(validate, agrees_with_is_valid_and_refusal) {
    expect_agreement<daisy::format>();
    expect_agreement<can::format>();
    expect_agreement<gateway::format>();
}

}  // namespace
}  // namespace trama
