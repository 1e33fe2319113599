#include "trama/can/reassembler.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "trama/can/format.hpp"

namespace trama::can {
namespace {

using frames = std::vector<frame>;

frame make(std::uint32_t id, std::initializer_list<int> bytes, std::uint64_t time = 0) {
    frame f;
    f.id = id;
    f.time = time;
    for (const int b : bytes) f.data[f.length++] = static_cast<std::uint8_t>(b);
    return f;
}
frame reading_1(std::uint32_t id = 0x80, std::uint64_t time = 0) { return make(id, {2, 4, 'R', 4, 0, 100, 1, 240}, time); }
frame reading_2(std::uint32_t id = 0x80, std::uint64_t time = 0) { return make(id, {2, 20, 3, 55}, time); }
frame ask(std::uint32_t id = 0x80) { return make(id, {2, 4, 'R'}); }

void note(std::string& all, const event& e) {
    if (!all.empty()) all += ' ';
    all += std::string(trama::name_of(e.code)) + '@' + std::to_string(e.offset) + '+' + std::to_string(e.length) + '#' + std::to_string(e.id);
}
/// `code@first+frames#id` of everything, without an end of the input.
template <std::size_t Ids>
std::string events(basic_reassembler<Ids>& r, const frames& in) {
    std::string all;
    std::span<const frame> rest(in);
    for (event e = r.next(rest); e.code != errc::need_more; e = r.next(rest)) note(all, e);
    EXPECT_TRUE(rest.empty());
    return all;
}
std::string events(const frames& in) {
    reassembler r;
    return events(r, in);
}

TEST(can_reassembler, puts_the_frames_of_a_message_together) {
    reassembler r;
    const frames in{reading_1(), reading_2()};
    std::span<const frame> rest(in);
    const event e = r.next(rest);
    ASSERT_EQ(e.code, errc::ok);
    EXPECT_EQ(e.length, 2U);
    EXPECT_EQ(e.packet.envelope().id, 0x80U);
    const auto m = decode<sensor_readings>(e.packet);
    ASSERT_TRUE(m);
    EXPECT_EQ(m->readings[3], (reading{3, 55}));
    EXPECT_EQ(e.bytes.size(), 12U);
}

TEST(can_reassembler, identifiers_interleave_and_messages_come_as_they_complete) {
    EXPECT_EQ(events({reading_1(0x80), reading_1(0x81), ask(0x82), reading_2(0x81), reading_2(0x80)}), "ok@2+1#130 ok@1+2#129 ok@0+2#128");
}

TEST(can_reassembler, a_continuation_may_look_like_a_first_frame) {
    EXPECT_EQ(events({make(0x80, {1, 1, 'F', 'C', 'A', 0, 0, 0}), reading_1(), make(0x80, {1, 1, 'F', 'C', 'A', 0, 0, 0})}), "ok@0+3#128") << "only order and DLC count [D7]";
}

TEST(can_reassembler, a_dlc_that_is_not_the_expected_one_interrupts_and_is_examined_anew) {
    EXPECT_EQ(events({reading_1(), ask(), ask()}), "incomplete@0+1#128 ok@1+1#128 ok@2+1#128");
    EXPECT_EQ(events({reading_1(), reading_1(), reading_2()}), "incomplete@0+1#128 ok@1+2#128") << "a doubled first frame costs nothing";
    EXPECT_EQ(events({reading_2(), reading_1(), reading_2()}), "unknown_message@0+1#128 ok@1+2#128") << "a continuation without its first frame";
    EXPECT_EQ(events({reading_1(), make(0x80, {1, 2})}), "incomplete@0+1#128 bad_length@1+1#128");
}

TEST(can_reassembler, an_unknown_letter_or_an_impossible_dlc_is_one_event) {
    EXPECT_EQ(events({make(0x80, {1, 1, 'X'})}), "unknown_message@0+1#128");
    EXPECT_EQ(events({make(0x80, {1, 1, 'r'})}), "unknown_message@0+1#128");
    EXPECT_EQ(events({make(0x80, {1, 1, 0xFF, 0})}), "unknown_message@0+1#128");
    EXPECT_EQ(events({make(0x80, {})}), "bad_length@0+1#128");
    EXPECT_EQ(events({make(0x80, {1, 1})}), "bad_length@0+1#128");
    EXPECT_EQ(events({make(0x80, {1, 1, 'R', 1})}), "bad_length@0+1#128");
    EXPECT_EQ(events({make(0x80, {1, 1, 'M', 1})}), "bad_length@0+1#128");
    frame monster = reading_1();
    monster.length = 9;
    EXPECT_EQ(events({monster}), "bad_length@0+1#128") << "a DLC above 8 never leads outside the frame";
    monster.length = 255;
    EXPECT_EQ(events({reading_1(), monster}), "incomplete@0+1#128 bad_length@1+1#128");
}

TEST(can_reassembler, every_letter_and_dlc_is_a_message_or_one_of_two_errors) {
    for (unsigned letter = 0; letter != 256; ++letter)
        for (unsigned dlc = 0; dlc <= 8; ++dlc) {
            frame f;
            f.id = 0x81;
            f.length = static_cast<std::uint8_t>(dlc);
            f.data[2] = static_cast<std::uint8_t>(letter);
            const bool known_letter = letter == 'F' || letter == 'R' || letter == 'A' || letter == 'M' || letter == 'C';
            const bool single = (letter == 'R' && dlc == 3) || (letter == 'A' && (dlc == 4 || dlc == 5)) || (letter == 'M' && dlc == 5);
            const bool first = (letter == 'F' || letter == 'R' || letter == 'C') && dlc == 8;
            const std::string right = dlc < 3 ? "bad_length" : !known_letter ? "unknown_message" : single ? "ok" : first ? "" : "bad_length";
            EXPECT_EQ(events({f}), right.empty() ? "" : right + "@0+1#129") << letter << ", " << dlc;
        }
}

TEST(can_reassembler, frames_of_others_are_foreign_and_leave_a_partial_message_alone) {
    reassembler r;
    frames others{make(0x7F, {1}), make(0x83, {1}), reading_1(), reading_1(), reading_1(), reading_1()};
    others[2].extended = others[3].remote = others[4].error = others[5].fd = true;
    frames in{reading_1()};
    in.insert(in.end(), others.begin(), others.end());
    in.push_back(reading_2());
    EXPECT_EQ(events(r, in), "ok@0+2#128");
    EXPECT_EQ(r.counters().foreign, 6U);
    EXPECT_EQ(r.counters().packets, 1U);
    EXPECT_EQ(r.counters().skipped, 0U);
}

TEST(can_reassembler, follows_the_identifiers_it_is_given) {
    basic_reassembler<2> r({0x100, 0x7FF});
    EXPECT_EQ(events(r, {reading_1(0x7FF), ask(0x80), ask(0x100), reading_2(0x7FF)}), "ok@2+1#256 ok@0+2#2047");
    EXPECT_EQ(r.counters().foreign, 1U);
}

TEST(can_reassembler, a_stalled_message_times_out_with_the_next_frame_of_its_identifier) {
    reassembler r({0x80, 0x81, 0x82}, 100);
    EXPECT_EQ(events(r, {reading_1(0x80, 1000), reading_2(0x80, 1100)}), "ok@0+2#128") << "not older than the time-out";
    EXPECT_EQ(events(r, {reading_1(0x80, 2000), reading_2(0x80, 2101)}), "timed_out@2+1#128 unknown_message@3+1#128");
    EXPECT_EQ(events(r, {reading_1(0x80, 3000), ask(0x81), reading_2(0x80, 3050)}), "ok@5+1#129 ok@4+2#128");
    EXPECT_EQ(r.counters().count(errc::timed_out), 1U);
    EXPECT_EQ(r.counters().skipped, 1U);
}

TEST(can_reassembler, the_age_counts_from_the_latest_frame) {
    reassembler r({0x80, 0x81, 0x82}, 100);
    frame f = make(0x80, {1, 1, 'F', 'C', 'A', 0, 0, 0}, 1000), g = make(0x80, {0, 0, 0, 0, 0, 0, 0, 0}, 1090), h = g;
    h.time = 1180;
    EXPECT_EQ(events(r, {f, g, h}), "ok@0+3#128");
}

TEST(can_reassembler, tick_shows_what_is_overdue_the_longest_stalled_first) {
    reassembler r({0x80, 0x81, 0x82}, 100);
    EXPECT_EQ(events(r, {reading_1(0x80, 1050), reading_1(0x81, 1000), reading_1(0x82, 1200)}), "");
    r.tick(1100);
    EXPECT_EQ(events(r, {}), "");
    r.tick(1151);
    EXPECT_EQ(events(r, {}), "timed_out@1+1#129 timed_out@0+1#128");
    EXPECT_EQ(r.pending(), 1U);
    r.tick(50);
    EXPECT_EQ(events(r, {}), "") << "a clock that goes backwards makes nothing old";
    EXPECT_EQ(events(r, {reading_2(0x82, 10)}), "ok@2+2#130");
}

TEST(can_reassembler, what_a_tick_made_overdue_comes_before_the_frames_behind_it) {
    reassembler r({0x80, 0x81, 0x82}, 100);
    EXPECT_EQ(events(r, {reading_1(0x80, 1000), reading_1(0x81, 1090)}), "");
    r.tick(1150);
    EXPECT_EQ(events(r, {ask(0x82), reading_2(0x81, 1150)}), "timed_out@0+1#128 ok@2+1#130 ok@1+2#129");
}

TEST(can_reassembler, without_a_time_out_nothing_is_ever_late) {
    reassembler r;
    EXPECT_EQ(events(r, {reading_1(0x80, 0)}), "");
    r.tick(never);
    EXPECT_EQ(events(r, {reading_2(0x80, never)}), "ok@0+2#128");
}

TEST(can_reassembler, the_end_truncates_partial_messages_in_the_order_of_their_first_frames) {
    reassembler r;
    EXPECT_EQ(events(r, {reading_1(0x82), reading_1(0x80), make(0x81, {1, 1, 'F', 'C', 'A', 0, 0, 0}), reading_1(0x81)}), "");
    EXPECT_EQ(r.pending(), 4U);
    r.finish();
    EXPECT_EQ(events(r, {}), "truncated@0+1#130 truncated@1+1#128 truncated@2+2#129");
    EXPECT_EQ(r.pending(), 0U);
    EXPECT_EQ(events(r, {reading_1(), reading_2()}), "ok@4+2#128") << "it goes on after the end";
}

TEST(can_reassembler, reset_forgets_partial_messages_and_keeps_counters) {
    reassembler r;
    EXPECT_EQ(events(r, {ask(), reading_1()}), "ok@0+1#128");
    r.reset();
    EXPECT_EQ(r.pending(), 0U);
    EXPECT_EQ(events(r, {reading_2()}), "unknown_message@0+1#128");
    EXPECT_EQ(r.counters().packets, 1U);
}

TEST(can_reassembler, seek_numbers_the_next_frame) {
    reassembler r;
    r.seek(41);
    EXPECT_EQ(events(r, {ask(), reading_1()}), "ok@41+1#128");
    r.seek(100);
    EXPECT_EQ(events(r, {reading_2()}), "ok@42+2#128");
}

TEST(can_reassembler, an_unknown_message_keeps_its_bytes) {
    reassembler r;
    const frames in{make(0x82, {9, 8, 'Z', 7, 6})};
    std::span<const frame> rest(in);
    const event e = r.next(rest);
    ASSERT_EQ(e.code, errc::unknown_message);
    EXPECT_EQ(std::vector<std::uint8_t>(e.bytes.begin(), e.bytes.end()), (std::vector<std::uint8_t>{9, 8, 'Z', 7, 6}));
    EXPECT_EQ(e.packet.index(), messages::count);
    EXPECT_EQ(visit<format>(e.packet, [](const auto&) {}).code, errc::unknown_message);
    EXPECT_EQ(r.counters().skipped, 0U);
}

/// What came out of `in`: each message's identifier, kind and octets, with the number of times.
using delivered = std::map<std::vector<std::uint8_t>, int>;
delivered messages_of(const frames& in) {
    delivered all;
    reassembler r;
    read<format>(r, std::span<const frame>(in), [&](const event& e) {
        if (e.code != errc::ok) return;
        const auto body = e.packet.body();
        std::vector<std::uint8_t> octets{static_cast<std::uint8_t>(e.id), static_cast<std::uint8_t>(e.packet.index())};
        octets.insert(octets.end(), body.begin(), body.end());
        ++all[octets];
    });
    return all;
}
/// How many messages are in `a` and not in `b`.
int more_in(const delivered& a, const delivered& b) {
    int n = 0;
    for (const auto& [octets, times] : a) {
        const auto same = b.find(octets);
        n += std::max(0, times - (same == b.end() ? 0 : same->second));
    }
    return n;
}

int not_in(const delivered& a, const delivered& b) {
    return static_cast<int>(std::count_if(a.begin(), a.end(), [&](const auto& one) { return !b.contains(one.first); }));
}

/// L6, measured: what one lost, doubled or swapped frame costs, in messages lost and in messages that were never sent.
TEST(can_reassembler, a_lost_doubled_or_swapped_frame_costs_a_few_messages) {
    const auto define = [](std::uint8_t day) -> frames {
        return {make(0x81, {1, day, 'F', 'I', 'S', 20, 11, 4}), make(0x81, {day, 20, 11, 5, 15, 9, 15, 10}), make(0x81, {23, 30, 5, 2, 0, 1, 0, 0})};
    };
    frames mixed, defined;
    for (std::uint8_t i = 1; i != 21; ++i) {
        for (const frame& f : define(i)) defined.push_back(f);
        for (const frame& f : define(i)) mixed.push_back(f);
        for (const frame& f : {make(0x81, {1, i, 'R'}), make(0x81, {1, i, 'R', 4, 0, 100, 1, i}), make(0x81, {2, 20, 3, i}), make(0x81, {1, i, 'A', 0}),
                               make(0x81, {1, i, 'A', 0, 1}), make(0x81, {1, i, 'M', 0, 1}), make(0x81, {10, i, 'C', 20, 11, 4, i, 12}), make(0x81, {20, i})})
            mixed.push_back(f);
    }
    const struct { const char* name; const frames& clean; std::size_t frames_each; } streams[] = {{"all messages in turn", mixed, 11}, {"define_function alone", defined, 3}};
    const struct { const char* name; void (*apply)(frames&, std::ptrdiff_t); } faults[] = {
        {"lost", [](frames& f, std::ptrdiff_t at) { f.erase(f.begin() + at); }},
        {"doubled", [](frames& f, std::ptrdiff_t at) { f.insert(f.begin() + at, frame(f[static_cast<std::size_t>(at)])); }},
        {"swapped with the next", [](frames& f, std::ptrdiff_t at) { std::iter_swap(f.begin() + at, f.begin() + at + 1); }},
    };
    for (const auto& stream : streams) {
        const delivered sent = messages_of(stream.clean);
        for (const auto& fault : faults) {
            int lost = 0, invented = 0, most_lost = 0, most_invented = 0;
            const std::size_t count = 4 * stream.frames_each, first = 3 * stream.frames_each;
            for (std::size_t at = first; at != first + count; ++at) {
                frames faulty = stream.clean;
                fault.apply(faulty, static_cast<std::ptrdiff_t>(at));
                const delivered came = messages_of(faulty);
                lost += more_in(sent, came);
                invented += not_in(came, sent);
                most_lost = std::max(most_lost, more_in(sent, came));
                most_invented = std::max(most_invented, not_in(came, sent));
            }
            std::printf("can, %s, a frame %s, %zu faults: %d messages lost (at most %d by one), %d delivered that were never sent (at most %d)\n", stream.name, fault.name, count,
                        lost, most_lost, invented, most_invented);
            EXPECT_LE(most_lost, 2) << stream.name << ", " << fault.name;
            EXPECT_LE(most_invented, 1) << stream.name << ", " << fault.name;
        }
    }
}

}  // namespace
}  // namespace trama::can
