#include "trama/can/messages.hpp"

#include <gtest/gtest.h>

#include "trama/can/format.hpp"
#include "trama/core/print.hpp"

namespace trama::can {
namespace {

TEST(can_messages, an_echo_is_the_request_repeated) {
    const set_actuator request{1, 7, 3, 1};
    EXPECT_TRUE(is_echo_of(request, request));
    EXPECT_FALSE(is_echo_of(request, set_actuator{1, 7, 3, 0}));
    define_function f;
    f.sensors[3] = 1;
    EXPECT_FALSE(is_echo_of(f, define_function{}));
    EXPECT_TRUE(is_echo_of(set_clock{}, set_clock{}));
}

TEST(can_messages, start_and_end_are_torn_apart_on_the_wire) {
    define_function m;
    m.node = 10;
    m.message_id = 10;
    m.function = function::interval_specific;
    m.start = {2011, 3, 13, 9, 15, 10};
    m.end = {2011, 3, 15, 23, 30, 5};
    m.sensor_count = 4;
    m.sensors = {0, 1, 2, 3};
    std::array<frame, 3> out{};
    ASSERT_EQ(encode({0x81}, m, out).value_or(0), 3U);
    EXPECT_EQ(out[0].data, (std::array<std::uint8_t, 8>{10, 10, 'F', 'I', 'S', 20, 11, 3}));
    EXPECT_EQ(out[1].data, (std::array<std::uint8_t, 8>{13, 20, 11, 3, 15, 9, 15, 10}));
    EXPECT_EQ(out[2].data, (std::array<std::uint8_t, 8>{23, 30, 5, 4, 0, 1, 2, 3}));
    for (const frame& f : out) {
        EXPECT_EQ(f.id, 0x81U);
        EXPECT_EQ(f.length, 8);
    }
}

TEST(can_messages, a_year_byte_above_99_is_a_bad_number_with_its_field) {
    const auto decoded = [](std::array<std::uint8_t, 24> body) {
        define_function m;
        return load_body(std::span<const std::uint8_t>(body), m);
    };
    std::array<std::uint8_t, 24> body{1, 1, 'F', 'C', 'A'};
    EXPECT_FALSE(decoded(body));
    for (const std::size_t at : {5U, 6U}) {
        auto bad = body;
        bad[at] = 100;
        EXPECT_EQ(decoded(bad), (error{errc::bad_number, {3, field_ref::none, 0}})) << "start.year";
        bad[at] = 99;
        EXPECT_FALSE(decoded(bad));
    }
    for (const std::size_t at : {9U, 10U}) {
        auto bad = body;
        bad[at] = 100;
        EXPECT_EQ(decoded(bad), (error{errc::bad_number, {4, field_ref::none, 0}})) << "end.year";
    }
    set_clock c;
    const std::array<std::uint8_t, 10> clock{1, 1, 'C', 20, 100, 1, 1, 0, 0, 0};
    EXPECT_EQ(load_body(std::span<const std::uint8_t>(clock), c), (error{errc::bad_number, {2}}));
}

TEST(can_messages, any_state_and_any_node_are_valid_D10_D11) {
    for (unsigned v = 0; v != 256; ++v) {
        const auto byte = static_cast<std::uint8_t>(v);
        EXPECT_TRUE(is_valid(set_actuator{byte, 0, byte, byte}));
        EXPECT_TRUE(is_valid(actuator_state{byte, 0, byte, byte}));
        EXPECT_TRUE(is_valid(set_clock{byte, 200, 2011, 4, 1, 12, 20, 30}));
    }
}

TEST(can_messages, a_year_beyond_9999_cannot_be_carried) {
    set_clock m{99, 0, 10000, 1, 1, 0, 0, 0};
    std::array<frame, 3> out{};
    EXPECT_EQ(format::encode_unchecked({0x80}, m, out).error(), (error{errc::out_of_range, {2}}));
    m.year = 9999;
    EXPECT_TRUE(encode({0x80}, m, out));
}

TEST(can_messages, an_identifier_of_more_than_11_bits_is_refused_even_unchecked) {
    const read_sensors m{.node = 1, .message_id = 1};
    std::array<frame, 3> out{};
    EXPECT_EQ(encode({0x7FF}, m, out).value_or(0), 1U);
    for (const std::uint32_t id : {0x800U, 0xFFFFFFFFU}) {
        out[0] = {};
        EXPECT_EQ(encode({id}, m, out).error(), (error{errc::out_of_range, {field_ref::id}}));
        EXPECT_EQ(encode_unchecked({id}, m, out).error(), (error{errc::out_of_range, {field_ref::id}}));
        EXPECT_EQ(out[0], frame{});
        int violations = 0;
        format::for_each_violation({id}, m, [&](const violation& v) { violations += v.field.field == field_ref::id && v.value == id && v.allowed->low == 0 && v.allowed->high == 2047 ? 1 : 100; });
        EXPECT_EQ(violations, 1);
    }
    for (const std::uint32_t id : {0U, 0x7FFU}) format::for_each_violation({id}, m, [&](const violation&) { ADD_FAILURE() << id; });
    std::array<char, 16> room;
    text_sink words(room);
    print_path<read_sensors>(words, {field_ref::id});
    EXPECT_EQ(words.view(), "id");
}

TEST(can_messages, are_ordered_by_time) {
    EXPECT_LT((moment{2011, 3, 13, 9, 15, 10}), (moment{2011, 3, 15, 0, 0, 0}));
}

}  // namespace
}  // namespace trama::can
