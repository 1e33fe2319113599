#include "trama/daisy/format.hpp"

#include <gtest/gtest.h>

#include "laws/daisy_subject.hpp"
#include "trama/core/print.hpp"

namespace trama::daisy {
namespace {

using test::octets;

const envelope main_to_motor{board(0, 0), board(1, 1)};

template <class M>
error refused(const envelope& e, const M& m, bool checked = true) {
    std::array<std::uint8_t, max_packet> out{}, blank{};
    const auto size = checked ? format::encode(e, m, out) : format::encode_unchecked(e, m, out);
    EXPECT_FALSE(size);
    EXPECT_EQ(out, blank) << "a refused message writes nothing";
    return size.error();
}

TEST(daisy_format, encodes_an_example_of_the_document) {
    std::array<std::uint8_t, 16> out{};
    const auto size = encode({board(1, 1), board(0, 0)}, dc_motor::set_direction{direction::counter_clockwise}, out);
    ASSERT_EQ(size.value_or(0), 6U);
    EXPECT_EQ(octets(out.begin(), out.begin() + 6), (octets{0x05, 0x11, 0x00, 0x40, 0x01, 0x55}));
}

TEST(daisy_format, refuses_addresses_that_imply_another_family_and_names_destination) {
    const error right{errc::out_of_range, {field_ref::destination}};
    EXPECT_EQ(refused({board(2, 1), board(0, 0)}, dc_motor::get_encoder{}), right);
    EXPECT_EQ(refused({board(2, 1), board(0, 0)}, dc_motor::get_encoder{}, false), right);
    EXPECT_EQ(refused({board(7, 1), board(0, 0)}, dc_motor::get_encoder{}, false), right);
    EXPECT_EQ(refused({board(0, 0), board(2, 1)}, dc_motor::get_encoder_reply{}), right);
    EXPECT_EQ(refused(envelope{everyone, board(0, 0)}, dc_motor::get_encoder{}), right);
    std::array<std::uint8_t, 16> out{};
    EXPECT_TRUE(encode({board(0, 0), board(1, 1)}, dc_motor::motor_stress_alarm{5}, out)) << "a report to the main controller";
    EXPECT_TRUE(encode({board(0, 0), board(6, 1)}, battery_controller::battery_empty_alarm{5}, out)) << "[D2]";
}

TEST(daisy_format, every_message_is_refused_under_every_other_family) {
    std::array<std::uint8_t, max_packet> out{};
    messages::each([&]<class M>() {
        test::memory views;
        test::rng random(1);
        const M m = test::random_message<M>(random, test::manners::valid, views);
        for (unsigned destination = 0; destination != 16; ++destination)
            for (unsigned source = 0; source != 16; ++source) {
                const envelope e{board(destination, 1), board(source, 2)};
                const bool fits = family_of(e, command_of(M::key)) == family_of(M::key);
                EXPECT_EQ(bool(format::encode(e, m, out)), fits) << M::name << ", " << destination << ", " << source;
            }
    });
}

TEST(daisy_format, a_source_that_is_everyone_is_a_violation) {
    const envelope e{board(1, 1), board(0, 15)};
    EXPECT_EQ(refused(e, dc_motor::get_encoder{}), (error{errc::out_of_range, {field_ref::source}}));
    std::array<std::uint8_t, 16> out{};
    EXPECT_TRUE(format::encode_unchecked(e, dc_motor::get_encoder{}, out));
    std::size_t n = 0;
    format::for_each_violation(e, dc_motor::get_encoder{}, [&](const violation& v) {
        ++n;
        EXPECT_EQ(v.value, 0x0F);
        EXPECT_EQ(v.field.field, field_ref::source);
        EXPECT_EQ(v.allowed->words, "id 0..14");
    });
    EXPECT_EQ(n, 1U);
    format::for_each_violation(main_to_motor, dc_motor::get_encoder{}, [&](const violation&) { ++n; });
    EXPECT_EQ(n, 1U);
}

/// The fields of `validate(e, m)`, in order, and whether `encode` agrees with the first.
template <class M>
std::vector<std::string> faults(const envelope& e, const M& m) {
    std::vector<std::string> all;
    for (const violation& v : validate(e, m)) {
        std::array<char, 128> memory;
        text_sink out(memory);
        print_path<M>(out, v.field);
        out << '=' << v.value << ' ';
        out.allowed(*v.allowed);
        all.emplace_back(out.view());
    }
    std::array<std::uint8_t, max_packet> wire{};
    EXPECT_EQ(bool(encode(e, m, wire)), all.empty());
    return all;
}

TEST(daisy_format, validates_the_addresses_with_the_message) {
    using list = std::vector<std::string>;
    const std::string right = "an address of the family that defines the command";
    EXPECT_EQ(faults({board(2, 1), board(0, 0)}, servo_motor::set_position{4, 180}), list{});
    EXPECT_EQ(faults({board(2, 15), board(0, 15)}, servo_motor::set_position{5, 181}), (list{"source=15 id 0..14", "servo_id=5 0..4", "position=181 0..180"}));
    EXPECT_EQ(faults({board(1, 1), board(0, 0)}, servo_motor::set_position{}), list{"destination=17 " + right});
    EXPECT_EQ(faults({board(2, 1), board(3, 15)}, dc_motor::get_encoder{}), (list{"source=63 id 0..14", "destination=33 " + right}));
    EXPECT_EQ(faults({everyone, board(0, 0)}, common::ping{}), list{});
    EXPECT_EQ(validate(dc_motor::set_direction{static_cast<direction>(2)}).size(), 1U) << "without addresses, also from inside the namespace";
}

TEST(daisy_format, a_list_of_violations_has_room_for_the_addresses_too) {
    constexpr auto all = validate(envelope{board(1, 1), board(3, 15)}, servo_motor::set_position{5, 181});
    static_assert(all.size() == 4);
}

TEST(daisy_format, the_free_encoders_are_those_of_the_format) {
    const envelope to_servo{board(2, 1), board(0, 0)};
    const servo_motor::set_position good{4, 180}, bad{9, 181};
    std::array<std::uint8_t, max_packet> free{}, own{};
    EXPECT_EQ(encode_unchecked(to_servo, bad, free), format::encode_unchecked(to_servo, bad, own));
    EXPECT_EQ(free, own);
    EXPECT_EQ(free[5], 181);
    EXPECT_EQ(encode(to_servo, bad, free).error(), (error{errc::out_of_range, {0}}));
    EXPECT_EQ(encode(to_servo, good, free).value_or(0), encode_unchecked(to_servo, good, own).value_or(1));
    EXPECT_EQ(free, own);
}

TEST(daisy_format, refuses_violations_unless_asked_by_name) {
    const envelope to_servo{board(2, 1), board(0, 0)};
    EXPECT_EQ(refused(to_servo, servo_motor::set_position{0, 181}), (error{errc::out_of_range, {1}}));
    EXPECT_EQ(refused(to_servo, servo_motor::set_all_positions{{0, 0, 200, 0, 0}}), (error{errc::out_of_range, {0, 2}}));
    std::array<std::uint8_t, 16> out{};
    EXPECT_TRUE(format::encode_unchecked(to_servo, servo_motor::set_position{9, 181}, out));
    EXPECT_EQ(out[5], 181);
}

TEST(daisy_format, what_the_wire_cannot_carry_is_refused_even_unchecked) {
    const octets long_text(252, 'x'), rejected(250, 1);
    EXPECT_EQ(refused(main_to_motor, common::init_reply{byte_view(long_text)}, false), (error{errc::out_of_range, {0}}));
    EXPECT_EQ(refused(main_to_motor, common::error{0, byte_view(rejected), 0}, false), (error{errc::out_of_range, {1}})) << "[D5]";
    EXPECT_EQ(refused(main_to_motor, common::error{0, byte_view(std::span(rejected).first(4)), 0}, false), (error{errc::out_of_range, {1}}));
    distance_sensor::get_value_reply m;
    m.sensors = 7;
    EXPECT_EQ(refused({board(0, 0), board(3, 1)}, m, false), (error{errc::out_of_range, {1}}));
}

TEST(daisy_format, the_longest_text_and_rejected_packet_fill_the_packet) {
    std::array<std::uint8_t, max_packet> out{};
    const octets text(251, 'x'), rejected(249, 1);
    EXPECT_EQ(encode(main_to_motor, common::reset_reply{byte_view(text)}, out).value_or(0), max_packet);
    EXPECT_EQ(encode(main_to_motor, common::error{0, byte_view(rejected), 9}, out).value_or(0), max_packet);
    EXPECT_EQ(out[254], 9);
    EXPECT_EQ(out[0], 255);
}

TEST(daisy_format, what_a_message_views_may_lie_in_the_buffer_that_is_written) {
    octets text;
    for (int i = 0; i != 40; ++i) text.push_back(static_cast<std::uint8_t>('0' + i));
    const auto same = [&](std::size_t at, auto make) {
        std::array<std::uint8_t, max_packet> apart{}, own{};
        const auto size = encode_unchecked(main_to_motor, make(byte_view(text)), apart);
        ASSERT_TRUE(size);
        std::copy(text.begin(), text.end(), own.begin() + static_cast<std::ptrdiff_t>(at));
        ASSERT_EQ(encode_unchecked(main_to_motor, make(byte_view(std::span(own).subspan(at, text.size()))), own), size);
        EXPECT_TRUE(std::equal(own.begin(), own.begin() + static_cast<std::ptrdiff_t>(*size), apart.begin())) << "at " << at;
    };
    for (std::size_t at = 0; at != 60; ++at) {
        same(at, [](byte_view v) { return common::init_reply{v}; });
        same(at, [](byte_view v) { return common::error{0, v, 0x55}; });
    }
}

TEST(daisy_format, what_the_caller_throws_passes_through_visit) {
    const octets packet = test::sealed(0x11, 0x00, 0x43, {});
    const auto hear = [&] {
        decoder d;
        read<format>(d, packet, [](const event& e) { (void)visit<format>(e.packet, [](const auto&) { throw 7; }); });
    };
    EXPECT_THROW(hear(), int);
}

TEST(daisy_format, names_and_keys_of_the_messages_are_unique) {
    std::vector<key> keys;
    std::vector<std::string> names;
    messages::each([&]<class M>() {
        keys.push_back(M::key);
        names.push_back(std::string(M::name) + ((command_of(M::key) & response_bit) != 0 ? " response" : " request"));
        EXPECT_FALSE(M::section.empty());
    });
    EXPECT_EQ(messages::count, 93U);
    std::sort(keys.begin(), keys.end());
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::unique(keys.begin(), keys.end()), keys.end());
    EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
}

}  // namespace
}  // namespace trama::daisy
