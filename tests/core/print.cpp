#include "trama/core/print.hpp"

#include <gtest/gtest.h>

#include <string>

#include "trama/trama.hpp"

namespace trama {
namespace {

template <class M>
std::string json(const M& m) {
    std::array<char, 8192> out;
    const auto size = to_json(m, out);
    return size ? std::string(out.data(), *size) : "does not fit";
}
template <class M>
std::string plain(const M& m) {
    std::array<char, 8192> out;
    const auto size = to_text(m, out);
    return size ? std::string(out.data(), *size) : "does not fit";
}
template <class M>
std::string path(field_ref at) {
    std::array<char, 64> out;
    text_sink sink(out);
    print_path<M>(sink, at);
    return std::string(sink.view());
}

TEST(print, a_message_without_fields_is_an_empty_object) {
    EXPECT_EQ(json(daisy::common::ping{}), "{}");
    EXPECT_EQ(plain(daisy::common::ping{}), "");
}

TEST(print, numbers_and_names_go_by_their_kind) {
    daisy::dc_motor::set_dc_speed m;
    m.direction = daisy::direction::counter_clockwise;
    m.speed = -300;
    EXPECT_EQ(json(m), R"({"direction":"counter_clockwise","speed":-300})");
    EXPECT_EQ(plain(m), "direction=counter_clockwise speed=-300");
    m.direction = static_cast<daisy::direction>(7);
    EXPECT_EQ(json(m), R"({"direction":7,"speed":-300})");
}

TEST(print, lists_have_as_many_values_as_there_are) {
    daisy::distance_sensor::get_value_reply m;
    EXPECT_EQ(json(m), R"({"sensors":0,"readings":[]})");
    m.sensors = 3;
    m.readings = {200, 300};
    EXPECT_EQ(json(m), R"({"sensors":3,"readings":[200,300]})");
}

TEST(print, fields_that_do_not_exist_are_left_out) {
    daisy::common::error m;
    m.code = 1;
    EXPECT_EQ(json(m), R"({"code":1})");
    const std::array<std::uint8_t, 5> rejected{4, 0x11, 0, 0x43, 0x57};
    m = {0, byte_view(rejected), 0x56};
    EXPECT_EQ(json(m), R"({"code":0,"rejected":"0411004357","expected_crc":86})");
}

TEST(print, flags_are_a_list_of_names_and_of_unnamed_bits) {
    gateway::circuit_state m;
    m.check = static_cast<gateway::circuit_check>(1 | 0x800 | 0x400000);
    m.circuit_voltage = 480;
    EXPECT_NE(json(m).find(R"("circuit_voltage":48.0,)"), std::string::npos);
    EXPECT_NE(json(m).find(R"("check":["cart_lost","door_open",4194304])"), std::string::npos);
    EXPECT_NE(plain(m).find("check=[cart_lost,door_open,4194304]"), std::string::npos);
    m.check = {};
    EXPECT_NE(json(m).find(R"("check":[])"), std::string::npos);
}

TEST(print, nested_structures_are_objects) {
    can::sensor_readings m;
    m.readings[1] = {7, 9};
    EXPECT_EQ(json(m), R"({"node":0,"message_id":0,"sensor_count":0,"readings":[{"sensor":0,"value":0},{"sensor":7,"value":9},{"sensor":0,"value":0},{"sensor":0,"value":0}]})");
    EXPECT_NE(plain(m).find("{sensor=7 value=9}"), std::string::npos);
}

TEST(print, text_loses_the_spaces_on_its_right) {
    gateway::send_command m;
    m.command = " a\"b";
    EXPECT_NE(json(m).find(R"("command":" a\"b")"), std::string::npos);
}

TEST(print, paths_name_fields_elements_and_members) {
    EXPECT_EQ(path<gateway::cart_state>({10, 1, 5}), "orders[1].level");
    EXPECT_EQ(path<gateway::cart_state>({2}), "cart_status");
    EXPECT_EQ(path<can::define_function>({3, field_ref::none, 1}), "start.month");
    EXPECT_EQ(path<can::define_function>({6, 2}), "sensors[2]");
    EXPECT_EQ(path<can::sensor_readings>({3, 3, 1}), "readings[3].value");
    EXPECT_EQ(path<can::set_clock>({}), "");
    EXPECT_EQ(path<daisy::common::ping>({field_ref::source}), "source");
    EXPECT_EQ(path<daisy::dc_motor::set_dc_speed>({field_ref::destination}), "destination");
}

TEST(print, a_buffer_too_small_by_one_is_told) {
    const daisy::dc_motor::set_encoder m{1193046};
    std::array<char, 64> out;
    const auto size = to_json(m, out);
    ASSERT_TRUE(size);
    EXPECT_EQ(to_json(m, std::span(out).first(*size)).value_or(0), *size);
    EXPECT_EQ(to_json(m, std::span(out).first(*size - 1)).code(), errc::buffer_too_small);
    EXPECT_EQ(to_text(m, std::span(out).first(0)).code(), errc::buffer_too_small);
}

}  // namespace
}  // namespace trama
