// daisy::node alone: what each kind of packet makes it send. Packets are written out by hand.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "trama/daisy/node.hpp"

namespace daisy = trama::daisy;
using daisy::node_news;
using octets = std::vector<std::uint8_t>;

namespace {

struct motor {
    int executed = 0;
    std::int32_t count = 0x00123456;

    daisy::answer operator()(const daisy::dc_motor::get_encoder&, daisy::dc_motor::get_encoder_reply& reply) {
        ++executed;
        reply.count = count;
        return daisy::answer::done;
    }
    daisy::answer operator()(const daisy::dc_motor::set_direction&, daisy::dc_motor::set_direction_reply&) {
        ++executed;
        return daisy::answer::done;
    }
    daisy::answer operator()(const daisy::dc_motor::motor_consumption&, daisy::dc_motor::motor_consumption_reply& reply) {
        ++executed;
        reply.consumption = 300;
        return daisy::answer::done;
    }
    daisy::answer operator()(const daisy::dc_motor::dont_stop&, daisy::dc_motor::dont_stop_reply&) { return static_cast<daisy::answer>(9); }
};
using board = daisy::node<2, 8>;

octets with_crc(octets b) {
    b.push_back(daisy::checksum(b));
    return b;
}
struct heard {
    daisy::node_event event;
    octets sent;
};
heard tell(board& n, motor& m, std::span<const std::uint8_t> in, std::uint64_t now = 0) {
    octets out(board::max_output);
    const auto e = n.next(in, now, out, m);
    EXPECT_TRUE(in.empty());
    out.resize(e.written);
    return {e, out};
}
/// Board 1:2 received `rejected` with a wrong CRC.
octets error_about(const octets& rejected) {
    octets error{static_cast<std::uint8_t>(6 + rejected.size()), 0x11, 0x12, 0x04, 0x00};
    error.insert(error.end(), rejected.begin(), rejected.end());
    error.push_back(daisy::checksum(std::span(rejected).first(rejected.size() - 1)));
    return with_crc(error);
}
const octets get_encoder = with_crc({4, 0x11, 0x00, 0x43});
const octets encoder_reply = with_crc({8, 0x00, 0x11, 0xC3, 0x56, 0x34, 0x12, 0x00});

class daisy_node : public testing::Test {
protected:
    board n{daisy::board(1, 1), "motor"};
    motor m;

    void settle() { tell(n, m, get_encoder); }  // a landmark puts the decoder in step
};

}  // namespace

TEST(daisy_route, sends_every_packet_the_documented_way) {
    using daisy::route;
    constexpr daisy::address self = daisy::board(1, 2);
    const auto way = [&](unsigned destination, unsigned source) {
        return daisy::route_of({{static_cast<std::uint8_t>(destination)}, {static_cast<std::uint8_t>(source)}}, self);
    };
    for (unsigned destination = 0; destination != 256; ++destination) {
        for (unsigned source = 0; source != 256; ++source) {
            const bool unremovable = (source & 15) == 15;
            route expected = route::pass_on;
            if (destination == 0xFF || destination == 0x1F) expected = route::consume_and_pass_on;
            if (destination == 0x12) expected = route::consume;
            if (source == 0x12 || unremovable) expected = route::remove;
            ASSERT_EQ(way(destination, source), expected) << destination << " " << source;
        }
    }
}

TEST_F(daisy_node, carries_out_a_request_and_answers_its_source) {
    const auto [event, sent] = tell(n, m, get_encoder);
    EXPECT_EQ(event.news, node_news::executed);
    EXPECT_EQ(sent, encoder_reply);
    EXPECT_EQ(m.executed, 1);
}

TEST_F(daisy_node, answers_a_broadcast_first_and_passes_it_on_then) {
    const octets call = with_crc({4, 0xFF, 0x00, 0x01});
    octets expected = with_crc({9, 0x00, 0x11, 0x81, 'm', 'o', 't', 'o', 'r'});
    expected.insert(expected.end(), call.begin(), call.end());
    EXPECT_EQ(tell(n, m, call).sent, expected);

    const octets group = with_crc({5, 0x1F, 0x00, 0x40, 0x01});
    octets both = with_crc({4, 0x00, 0x11, 0xC0});
    both.insert(both.end(), group.begin(), group.end());
    EXPECT_EQ(tell(n, m, group).sent, both);
    EXPECT_EQ(m.executed, 1);
    const octets other_group = with_crc({4, 0x2F, 0x00, 0x49});
    const auto [event, sent] = tell(n, m, other_group);
    EXPECT_EQ(event.news, node_news::passed_on);
    EXPECT_EQ(sent, other_group);
}

TEST_F(daisy_node, passes_on_unchanged_what_is_for_others_even_when_it_knows_nothing_about_it) {
    settle();
    for (const octets& p : {with_crc({4, 0x12, 0x00, 0x43}), with_crc({8, 0x00, 0x12, 0xC3, 1, 2, 3, 4}), with_crc({6, 0x13, 0x00, 0x7E, 1, 2})}) {
        const auto [event, sent] = tell(n, m, p);
        EXPECT_EQ(event.news, node_news::passed_on);
        EXPECT_EQ(sent, p);
    }
}

TEST_F(daisy_node, removes_what_has_come_full_circle_and_what_nobody_could_remove) {
    const octets own = encoder_reply;
    EXPECT_EQ(tell(n, m, own).event.news, node_news::removed);
    const octets unremovable = with_crc({4, 0xFF, 0x2F, 0x03});
    const auto [event, sent] = tell(n, m, unremovable);
    EXPECT_EQ(event.news, node_news::removed);
    EXPECT_TRUE(sent.empty());
}

TEST_F(daisy_node, answers_an_unknown_command_by_error_1) {
    settle();
    const octets complaint = with_crc({5, 0x00, 0x11, 0x04, 0x01});
    EXPECT_EQ(tell(n, m, with_crc({4, 0x11, 0x00, 0x7E})).sent, complaint) << "no table has it";
    EXPECT_EQ(tell(n, m, with_crc({4, 0x11, 0x00, 0x44})).sent, complaint) << "the board has no handler for it";
    EXPECT_EQ(tell(n, m, with_crc({6, 0x11, 0x00, 0x49, 1, 0})).sent, complaint) << "an alarm";
}

TEST_F(daisy_node, answers_by_other_errors_what_it_cannot_do) {
    settle();
    EXPECT_EQ(tell(n, m, with_crc({5, 0x11, 0x00, 0x40, 7})).sent, with_crc({5, 0x00, 0x11, 0x04, 0x02})) << "no such direction";
    EXPECT_EQ(m.executed, 1) << "the handler saw a value out of range";
    const auto [event, sent] = tell(n, m, with_crc({4, 0x11, 0x00, 0x47}));
    EXPECT_EQ(sent, with_crc({5, 0x00, 0x11, 0x04, 0x09})) << "the handler's own code";
    EXPECT_EQ(event.news, node_news::refused);
    EXPECT_EQ(static_cast<int>(event.verdict), 9);
}

TEST_F(daisy_node, answers_a_bad_crc_by_error_0_with_the_packet_as_received_and_the_crc_expected) {
    settle();
    octets damaged = with_crc({5, 0x12, 0x00, 0x40, 0x01});
    const std::uint8_t right = damaged.back();
    damaged.back() = 0x00;
    octets in = damaged;
    in.insert(in.end(), get_encoder.begin(), get_encoder.end());
    std::span<const std::uint8_t> rest(in);
    octets out(board::max_output);
    const auto fault = n.next(rest, 0, out, m);
    EXPECT_EQ(fault.news, node_news::fault);
    EXPECT_EQ(fault.code, trama::errc::bad_checksum);
    out.resize(fault.written);
    octets data{12, 0x00, 0x11, 0x04, 0x00};
    data.insert(data.end(), damaged.begin(), damaged.end());
    data.push_back(right);
    EXPECT_EQ(out, with_crc(data));
    EXPECT_EQ(tell(n, m, rest).sent, encoder_reply) << "the packet behind the damage";
}

TEST_F(daisy_node, keeps_quiet_about_damaged_errors_and_impossible_sources) {
    const auto complaint_about = [&](octets damaged) {
        settle();
        damaged.push_back(static_cast<std::uint8_t>(daisy::checksum(damaged) ^ 1));
        damaged.insert(damaged.end(), get_encoder.begin(), get_encoder.end());
        std::span<const std::uint8_t> in(damaged);
        octets out(board::max_output);
        const auto e = n.next(in, 0, out, m);
        EXPECT_EQ(e.news, node_news::fault);
        return e.written;
    };
    EXPECT_EQ(complaint_about({5, 0x12, 0x00, 0x04, 0x01}), 0U) << "an error about an error";
    EXPECT_EQ(complaint_about({5, 0x12, 0x0F, 0x40, 0x01}), 0U) << "to a broadcast address";
    EXPECT_EQ(complaint_about({5, 0x12, 0x90, 0x40, 0x01}), 0U) << "to a group that does not exist";
    EXPECT_EQ(complaint_about({5, 0x12, 0x11, 0x40, 0x01}), 0U) << "to itself";
    EXPECT_NE(complaint_about({5, 0x12, 0x00, 0x40, 0x01}), 0U);
    octets longest{249, 0x12, 0x00, 0x01};  // a packet of 250 bytes does not fit into an error [D5]
    longest.resize(249);
    EXPECT_EQ(complaint_about(longest), 0U);
}

TEST_F(daisy_node, sends_its_last_reply_again_when_that_was_damaged) {
    settle();
    octets rejected = encoder_reply;
    rejected[5] ^= 0x10;
    const octets error = error_about(rejected);
    for (int i = 1; i != 4; ++i) {
        const auto [event, sent] = tell(n, m, error);
        EXPECT_EQ(event.news, node_news::sent_again);
        EXPECT_EQ(sent, encoder_reply);
    }
    EXPECT_TRUE(tell(n, m, error).sent.empty()) << "more often than the attempts allow";
    EXPECT_EQ(m.executed, 1) << "carried out once";
    EXPECT_EQ(n.quality().rejections, 4U);
    EXPECT_EQ(n.quality().retries, 3U);
}

TEST_F(daisy_node, sends_again_whichever_is_closer_to_what_was_damaged_its_reply_or_its_alarm) {
    octets alarm(board::max_output);
    alarm.resize(n.send(daisy::board(0, 0), daisy::dc_motor::motor_stress_alarm{300}, 0, alarm).value_or(0));
    const octets reply = tell(n, m, with_crc({4, 0x11, 0x00, 0x48})).sent;
    ASSERT_EQ(alarm, with_crc({6, 0x00, 0x11, 0x49, 0x2C, 0x01}));
    ASSERT_EQ(reply, with_crc({6, 0x00, 0x11, 0xC8, 0x2C, 0x01}));
    octets damaged_reply = reply, damaged_alarm = alarm;
    damaged_reply[5] ^= 0x80;
    damaged_alarm[5] ^= 0x80;
    EXPECT_EQ(tell(n, m, error_about(damaged_reply)).sent, reply);
    EXPECT_EQ(tell(n, m, error_about(damaged_alarm)).sent, alarm);
    for (int i = 3; i <= 4; ++i) EXPECT_EQ(tell(n, m, error_about(damaged_reply)).sent, reply);
    EXPECT_TRUE(tell(n, m, error_about(damaged_reply)).sent.empty()) << "the alarm was not damaged";
    EXPECT_EQ(m.executed, 1);
}

TEST_F(daisy_node, repeats_an_alarm_until_it_is_confirmed_or_the_attempts_are_used_up) {
    octets out(board::max_output);
    const auto size = n.send(daisy::board(0, 0), daisy::dc_motor::motor_stress_alarm{0x3FF}, 1000, out);
    ASSERT_TRUE(size);
    out.resize(*size);
    const octets alarm = with_crc({6, 0x00, 0x11, 0x49, 0xFF, 0x03});
    EXPECT_EQ(out, alarm);
    octets more(board::max_output);
    EXPECT_EQ(n.send(daisy::board(0, 0), daisy::dc_motor::motor_stress_alarm{1}, 1000, more).code(), trama::errc::buffer_too_small);
    EXPECT_EQ(tell(n, m, {}, 1200).event.news, node_news::need_more);
    EXPECT_EQ(tell(n, m, {}, 1201).sent, alarm);
    EXPECT_EQ(tell(n, m, with_crc({4, 0x11, 0x00, 0xC9}), 1210).event.news, node_news::confirmed);
    EXPECT_EQ(n.quality().round_trip.last, 9U) << "of the attempt that was answered";
    EXPECT_EQ(tell(n, m, with_crc({4, 0x11, 0x00, 0xC9}), 1211).event.news, node_news::told) << "confirmed twice";
    EXPECT_EQ(tell(n, m, {}, 5000).event.news, node_news::need_more);

    ASSERT_TRUE(n.send(daisy::board(0, 0), daisy::dc_motor::motor_stress_alarm{1}, 10000, more));
    int sent = 1;
    std::uint64_t now = 10000;
    for (; n.in_flight() != 0 && now != 20000; ++now) sent += tell(n, m, {}, now).event.written != 0 ? 1 : 0;
    EXPECT_EQ(sent, 4);
    EXPECT_EQ(now, 10805U);
    EXPECT_EQ(n.quality().failures, 1U);
}

TEST(daisy_node_alarms, are_not_confirmed_by_a_late_reply_to_the_one_before) {
    daisy::timing once;
    once.attempts = 1;
    board n(daisy::board(1, 1), "motor", once);
    motor m;
    octets out(board::max_output);
    const octets reply = with_crc({4, 0x11, 0x00, 0xC9});
    ASSERT_TRUE(n.send(daisy::board(0, 0), daisy::dc_motor::motor_stress_alarm{1}, 0, out));
    EXPECT_EQ(tell(n, m, {}, 201).event.news, node_news::lost);
    EXPECT_FALSE(n.send(daisy::board(0, 0), daisy::dc_motor::motor_stress_alarm{2}, 202, out));
    EXPECT_EQ(tell(n, m, reply, 203).event.news, node_news::told);
    ASSERT_TRUE(n.send(daisy::board(0, 0), daisy::dc_motor::motor_stress_alarm{2}, 402, out));
    EXPECT_EQ(tell(n, m, reply, 403).event.news, node_news::confirmed);
}

TEST_F(daisy_node, takes_silence_for_the_end_of_a_packet) {
    settle();
    const octets half(get_encoder.begin(), get_encoder.begin() + 3);
    EXPECT_EQ(tell(n, m, half, 10).event.news, node_news::need_more);
    EXPECT_EQ(tell(n, m, {}, 60).event.news, node_news::need_more);
    const auto [event, sent] = tell(n, m, {}, 61);
    EXPECT_EQ(event.news, node_news::fault);
    EXPECT_EQ(event.code, trama::errc::truncated);
    EXPECT_EQ(tell(n, m, get_encoder, 62).sent, encoder_reply);
}

/// The decoder has nothing to give back then, and is told all the same where the next packet begins.
TEST_F(daisy_node, takes_silence_for_the_end_of_whatever_it_did_not_hear) {
    const octets undefined = with_crc({4, 0x11, 0x00, 0x55});
    EXPECT_EQ(tell(n, m, undefined, 10).sent, octets{}) << "it may be the rest of a packet";
    board fresh(daisy::board(1, 1), "motor");
    tell(fresh, m, {}, 1'000'000);
    EXPECT_EQ(tell(fresh, m, {}, 1'000'051).event.news, node_news::need_more);
    EXPECT_EQ(tell(fresh, m, undefined, 1'000'070).sent, with_crc({5, 0x00, 0x11, 0x04, 0x01}));
}

/// What the clock says at the first call tells nothing about the line.
TEST_F(daisy_node, takes_the_time_before_it_listened_for_no_silence) {
    octets joined{0x43, 0x56};  // the end of something, which would be the head of a packet of 68 bytes
    joined.insert(joined.end(), get_encoder.begin(), get_encoder.end());
    joined.insert(joined.end(), get_encoder.begin(), get_encoder.end());
    octets sent;
    std::span<const std::uint8_t> in(joined);
    for (;;) {
        octets out(board::max_output);
        const auto e = n.next(in, 1'000'000, out, m);
        sent.insert(sent.end(), out.begin(), out.begin() + static_cast<std::ptrdiff_t>(e.written));
        if (e.news == node_news::need_more) break;
    }
    octets twice = encoder_reply;
    twice.insert(twice.end(), encoder_reply.begin(), encoder_reply.end());
    EXPECT_EQ(sent, twice);
}

TEST_F(daisy_node, counts_both_packets_that_it_sends_for_a_call) {
    tell(n, m, with_crc({4, 0xFF, 0x00, 0x01}));
    EXPECT_EQ(n.quality().packets_sent, 2U);
    EXPECT_EQ(n.quality().bytes_sent, 10U + 5U);
}

/// The last byte of one and the head of the other read as a ping; the pause tells that they are none.
TEST_F(daisy_node, takes_silence_for_the_end_of_what_two_undocumented_packets_seem_to_be_together) {
    settle();
    const octets first = with_crc({6, 0x77, 0x70, 0x55, 0x01, 0x51}), second = with_crc({16, 0x00, 0x03, 0x17, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
    ASSERT_EQ(first.back(), 0x04);
    ASSERT_EQ(0x04 ^ second[0] ^ second[1] ^ second[2] ^ second[3], 0);
    EXPECT_EQ(tell(n, m, first, 10).sent, first);
    EXPECT_EQ(tell(n, m, second, 70).sent, second);
}

TEST(daisy_node_guard, removes_what_comes_by_twice_when_told_to) {
    daisy::timing t;
    t.orphan = 100;
    board n(daisy::board(1, 1), "motor", t);
    motor m;
    const octets orphan = with_crc({4, 0x12, 0x33, 0x43});
    EXPECT_EQ(tell(n, m, orphan, 0).sent, orphan);
    EXPECT_EQ(tell(n, m, orphan, 100).event.news, node_news::removed);
    EXPECT_EQ(tell(n, m, orphan, 201).sent, orphan) << "a new packet of the same bytes";
    EXPECT_EQ(tell(n, m, get_encoder, 210).sent, encoder_reply) << "its own requests are no orphans";
    EXPECT_EQ(tell(n, m, get_encoder, 211).sent, encoder_reply);
}

TEST(daisy_node_guard, tells_packets_apart_that_differ_in_one_bit) {
    const octets one = with_crc({8, 0x12, 0x33, 0x45, 0x00, 0x00, 0x00, 0x00});
    for (std::size_t at = 3; at != one.size(); ++at)
        for (unsigned bit = 0; bit != 8; ++bit) {
            octets other = one;
            other[at] = static_cast<std::uint8_t>(other[at] ^ 1U << bit);
            daisy::orphan_filter<2> filter(100);
            using verdict = decltype(filter)::verdict;
            EXPECT_EQ(filter.judge(other, 0), verdict::fresh);
            EXPECT_EQ(filter.judge(one, 0), verdict::fresh) << "byte " << at << " bit " << bit;
            EXPECT_EQ(filter.judge(other, 0), verdict::repeated);
        }
}

TEST_F(daisy_node, counts_undocumented_packets_as_intact_ones) {
    settle();
    const octets odd = with_crc({6, 0x12, 0x00, 0x5A, 1, 2});
    EXPECT_EQ(tell(n, m, odd).sent, odd) << "passed on";
    EXPECT_EQ(n.quality().packets_received, 2U);
    EXPECT_EQ(n.quality().bytes_received, get_encoder.size() + odd.size());
    EXPECT_EQ(n.quality().resynchronisations, 0U);
}

TEST(daisy_node_limits, consumes_nothing_without_room_for_what_it_may_have_to_send) {
    board n(daisy::board(1, 1), "a description that is cut to eight");
    motor m;
    std::span<const std::uint8_t> in(get_encoder);
    octets small(board::max_output - 1);
    EXPECT_EQ(n.next(in, 0, small, m).news, node_news::no_room);
    EXPECT_EQ(in.size(), get_encoder.size());
    EXPECT_EQ(tell(n, m, with_crc({4, 0x11, 0x00, 0x02})).sent, with_crc({12, 0x00, 0x11, 0x82, 'a', ' ', 'd', 'e', 's', 'c', 'r', 'i'}));
    EXPECT_EQ(tell(n, m, with_crc({4, 0x11, 0x00, 0x03})).sent, with_crc({4, 0x00, 0x11, 0x83}));
}

TEST(daisy_node_limits, answers_by_the_longest_description_that_a_packet_holds) {
    const std::string text(300, 'x');
    daisy::node<2, 251> n(daisy::board(1, 1), text);
    motor m;
    const octets call = with_crc({4, 0x11, 0x00, 0x01});
    std::span<const std::uint8_t> in(call);
    octets out(n.max_output);
    const auto e = n.next(in, 0, out, m);
    EXPECT_EQ(e.news, node_news::executed);
    EXPECT_EQ(e.written, daisy::max_packet);
}

TEST(daisy_replies, are_found_for_every_request_of_the_document) {
    int requests = 0;
    daisy::messages::each([&]<class M>() {
        if constexpr (daisy::request_message<M>) {
            ++requests;
            static_assert(daisy::command_of(daisy::reply_of<M>::key) == (daisy::command_of(M::key) | 0x80));
            static_assert(daisy::family_of(daisy::reply_of<M>::key) == daisy::family_of(M::key));
            static_assert(daisy::min_packet + M::layout.max_size <= daisy::max_request);
        }
    });
    EXPECT_EQ(requests, 46);  // 3 common, 12 dc_motor, 13 servo_motor, 8 distance_sensor, 7 battery_controller, 3 trash_bin
    static_assert(!daisy::request_message<daisy::common::error> && !daisy::request_message<daisy::common::ping_reply>);
}
