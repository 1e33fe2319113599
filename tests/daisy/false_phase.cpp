// Traffic whose shifted phases are intact packets too, if not documented ones. No decoder may stay in such a phase.
#include <gtest/gtest.h>

#include <vector>

#include "daisy/two_phases.hpp"
#include "trama/daisy/format.hpp"

namespace {

using namespace trama;
using bytes = std::vector<std::uint8_t>;

bytes operator*(const bytes& one, std::size_t times) { return test::repeated(one, times); }
bytes operator+(bytes a, const bytes& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}
bytes from(const bytes& all, std::size_t begin) { return {all.begin() + static_cast<std::ptrdiff_t>(begin), all.end()}; }

/// Offsets of the packets of `size` bytes and known message that the decoder delivers.
std::vector<std::uint64_t> delivered(const bytes& stream, std::size_t size) {
    std::vector<std::uint64_t> offsets;
    daisy::decoder decoder;
    const auto note = [&](const daisy::event& e) { if (e && e.length == size) offsets.push_back(e.offset); };
    read<daisy::format>(decoder, stream, note);
    decoder.finish();
    read<daisy::format>(decoder, {}, note);
    return offsets;
}

TEST(daisy_false_phase, texts_that_could_be_anything_are_found_again_after_lost_bytes) {
    const bytes text{0x0f, 0x00, 0x10, 0x81, 0x80, 0x0f, 0x90, 0x00, 0x7f, 0x61, 0x62, 0x63, 0x64, 0x65, 0x66, 0xf9};
    const bytes stream = text * 20 + from(text, 5) + text * 1000;
    EXPECT_GE(delivered(stream, text.size()).size(), 20U + 1000U - 2U);
}

TEST(daisy_false_phase, an_unseen_loss_costs_no_more_than_the_bound) {
    bytes text{127, 0x00, 0x11, 0x81};  // a plain INIT reply whose own text reads as an undocumented packet
    const bytes begin{'~', 'p', 'p', 'p', 'p'};
    text = text + begin;
    while (text.size() != 127) text.push_back('x');
    text.push_back(xor_of(text));
    const bytes stream = text * 40 + from(text, 4) + text * 40;
    const auto found = delivered(stream, text.size());
    const std::uint64_t fault = 40 * text.size();
    std::size_t late = 0;
    for (const std::uint64_t offset : found) late += offset >= fault + 256 ? 1 : 0;
    EXPECT_GE(late, 38U) << "all that begin 256 bytes or more after the fault";
}

TEST(daisy_false_phase, a_text_does_not_swallow_the_packets_that_it_seems_to_hold) {
    const bytes odd{0x09, 0x20, 0x20, 0x7e, 0x20, 0xf9, 0x00, 0x10, 0x81, 0x3f};
    const bytes servo{0x09, 0x20, 0x09, 0x41, 0x09, 0x09, 0x09, 0x09, 0x21, 0x40};
    ASSERT_EQ(xor_of(servo), 0);
    const bytes stream = from((odd + servo * 24) * 200, 5);
    EXPECT_GE(delivered(stream, servo.size()).size(), 200U * 24U - 26U);
}

TEST(daisy_false_phase, undocumented_packets_between_documented_ones_hold_no_phase_after_lost_bytes) {
    const bytes poll{0x04, 0x11, 0x00, 0x43, 0x56}, answer{0x08, 0x00, 0x11, 0xc3, 0x01, 0x02, 0x03, 0x04, 0xde};
    bytes reply{0x08, 0x00, 0x11, 0xc3, 0x8f, 0x71, 0xb2, 0x16}, odd{134, 0x11, 0x00, 0x60};
    reply.push_back(xor_of(reply));
    odd.resize(134);
    odd.push_back(xor_of(odd));
    const bytes stream = poll + answer + from(reply, 4) + odd + (reply + odd) * 50;
    const std::uint64_t fault = poll.size() + answer.size();
    std::size_t late = 0;
    for (const std::uint64_t offset : delivered(stream, reply.size())) late += offset >= fault + 256 ? 1 : 0;
    EXPECT_GE(late, 49U);
}

/// What a decoder says to `stream`, as codes.
std::vector<errc> codes_of(const bytes& stream) {
    daisy::decoder decoder;
    std::vector<errc> codes;
    read<daisy::format>(decoder, stream, [&](const daisy::event& e) { codes.push_back(e.code); });
    return codes;
}
const bytes ping{0x04, 0x11, 0x00, 0x03, 0x16};

TEST(daisy_false_phase, a_text_that_holds_packets_is_believed_behind_a_landmark) {
    bytes text{15, 0x00, 0x11, 0x81, 0x80};
    text = text + ping * 2;
    text.push_back(xor_of(text));
    const auto codes = codes_of((ping + text) * 10);
    EXPECT_EQ(codes, std::vector<errc>(20, errc::ok));
}

TEST(daisy_false_phase, an_undocumented_packet_that_holds_a_documented_one_is_not_believed) {
    bytes tunnel{10, 0x11, 0x00, 0x7a, 1};
    tunnel = tunnel + ping;
    tunnel.push_back(xor_of(tunnel));
    const std::vector<errc> expected{errc::ok, errc::noise, errc::ok};
    EXPECT_EQ(codes_of(ping + tunnel), expected);
}

/// A long documented header that straddles the packets' bounds must not keep the shadow from what lies inside it.
TEST(daisy_false_phase, what_a_refused_packet_holds_is_not_held_against_its_follower) {
    const bytes tunnel{0x0a, 0x11, 0x00, 0x33, 0x81, 0x04, 0x10, 0x00, 0x03, 0x17, 0xa9};
    const bytes latin_1{0x0d, 0x00, 0x11, 0x81, 0x44, 0x69, 0x72, 0x65, 0x63, 0x63, 0x69, 0xf3, 0x6e, 0x53};
    std::vector<errc> expected(5 + 60, errc::ok);
    expected[1] = errc::noise;         // the tunnel, up to the ping in it
    expected[3] = errc::bad_checksum;  // its CRC, which may be a LEN
    EXPECT_EQ(codes_of(ping + tunnel + latin_1 + ping * 60), expected);
}

/// While the shadow waits for a long packet that never comes whole, a text is accepted; then the shadow comes to the text.
TEST(daisy_false_phase, a_packet_that_was_accepted_is_not_held_against_its_follower) {
    bytes odd{9, 0x11, 0x00, 0x7a, 0x60, 0x00, 0x11, 0x81, 0x41};  // its data promise a text of 97 bytes
    odd.push_back(xor_of(odd));
    bytes text{44, 0x00, 0x11, 0x81};
    while (text.size() != 44) text.push_back('x');
    text.push_back(xor_of(text));
    bytes longer{60, 0x11, 0x00, 0x7a};
    while (longer.size() != 60) longer.push_back('U');
    longer.push_back(xor_of(longer));
    const std::vector<errc> expected{errc::ok, errc::unknown_message, errc::ok, errc::unknown_message, errc::ok};
    EXPECT_EQ(codes_of(ping + odd + text + longer + ping), expected);
}

/// Offsets of the first packets from `from` on, with a known message or none.
std::vector<std::uint64_t> starts(const bytes& stream, std::uint64_t from, std::size_t many) {
    std::vector<std::uint64_t> offsets;
    daisy::decoder decoder;
    read<daisy::format>(decoder, stream, [&](const daisy::event& e) { if (e && e.offset >= from && offsets.size() != many) offsets.push_back(e.offset); });
    return offsets;
}
/// One packet after the other from `first` on.
std::vector<std::uint64_t> every(std::uint64_t size, std::uint64_t first, std::size_t many) {
    std::vector<std::uint64_t> offsets;
    for (std::size_t i = 0; i != many; ++i) offsets.push_back(first + i * size);
    return offsets;
}

/// Readings of a board at rest. From byte 13 on they read as a servo command and an undocumented packet in turns, and of no reading
/// does an end lie in an undocumented packet.
TEST(daisy_false_phase, does_not_last_where_undocumented_and_documented_packets_alternate) {
    const bytes readings{0x11, 0x00, 0x30, 0xC4, 0x3F, 0x07, 0x00, 0x77, 0x00, 0x64, 0x00, 0x14, 0x00, 0x09, 0x00, 0x20, 0x41, 0xB2};
    ASSERT_EQ(xor_of(readings), 0);
    const bytes cut = readings * 3 + from(readings, 5) + readings * 40;
    EXPECT_EQ(starts(cut, 54 + 13 + 256, 20), every(18, 54 + 13 + 18 * 15, 20));
    for (std::size_t join = 1; join != 18; ++join) {
        const std::uint64_t past = (256 + join + 17) / 18 * 18 - join;
        EXPECT_EQ(starts(from(readings * 60, join), past, 20), every(18, past, 20)) << "joined at " << join;
    }
}

/// The same with texts that are no landmarks: 10 undocumented bytes and 50 of another text.
TEST(daisy_false_phase, of_undocumented_packets_and_texts_does_not_last) {
    bytes text{0x3B, 0x00, 0x10, 0x81};
    text = text + bytes(16, 0xEE) + bytes{0x09, 0x77, 0x77, 0x77} + bytes(5, 0xEE);
    text.push_back(xor_of(from(text, 20)));
    text = text + bytes{0x31, 0x00, 0x10, 0x81} + bytes(25, 0xEE);
    text.push_back(xor_of(text));
    ASSERT_EQ(text.size(), 60U);
    ASSERT_EQ(xor_of(from(text, 30)) ^ xor_of(std::span(text).first(20)), 0);
    for (const std::size_t join : {10U, 20U, 30U, 50U}) {
        const std::uint64_t past = 180 + 60 - join + 240;
        EXPECT_EQ(starts(text * 3 + from(text, join) + text * 20, past, 10), every(60, past, 10)) << "joined at " << join;
    }
}

/// The ping inside is what the other phase takes; the shadow must not give the readings up for it.
TEST(daisy_false_phase, of_a_ping_inside_and_an_undocumented_packet_across_does_not_last) {
    const bytes readings{0x11, 0x00, 0x30, 0xC4, 0x3F, 0x04, 0x00, 0x30, 0x03, 0x37, 0x0C, 0x77, 0x77, 0x77, 0x01, 0x01, 0x01, 0xA0};
    ASSERT_EQ(xor_of(readings), 0);
    const bytes cut = readings * 3 + from(readings, 5) + readings * 40;
    EXPECT_EQ(starts(cut, 54 + 13 + 252, 20), every(18, 54 + 13 + 252, 20));
    EXPECT_EQ(starts(from(readings * 60, 3), 15 + 252, 20), every(18, 15 + 252, 20));
}

/// A false LEN makes a text of what follows, believed behind the ping although it holds a ping itself; what comes behind such a
/// text is not believed as well if it is undocumented.
TEST(daisy_false_phase, a_text_that_is_doubted_vouches_for_nothing) {
    bytes text{14, 0x00, 0x10, 0x81}, first{125, 0x77, 0x77, 0x00}, second{128, 0x77, 0x77, 0x00}, reply{59, 0x00, 0x10, 0x81};
    const auto fill = [](bytes& b, std::size_t size, std::uint8_t with) { b.resize(size, with); };
    const auto seal = [](bytes& b) { b.push_back(xor_of(b)); };
    fill(text, 14, 'd');
    seal(text);
    fill(first, 75, 0xEE);
    first = first + bytes{0xFF, 0x00, 0x10, 0x81};  // the head of a text that never comes whole
    fill(first, 125, 0xEE);
    seal(first);
    fill(second, 54, 0xEE);
    second = second + bytes{95, 0x77, 0x77, 0x00};
    fill(second, 128, 0xEE);
    fill(reply, 20, 'a');
    reply.push_back(0x63);
    fill(reply, 59, 't');
    seal(reply);
    bytes stream = ping + text + ping + first;
    stream[5] = 199;  // the damaged byte: the text's LEN was 14
    second[9] = static_cast<std::uint8_t>(second[9] ^ xor_of(from(stream, 5)) ^ xor_of(std::span(second).first(54)));
    seal(second);
    stream = stream + second;
    const std::uint64_t at = stream.size();
    stream = stream + reply;
    ASSERT_EQ(at, 280U);
    ASSERT_EQ(xor_of(std::span(stream).subspan(5, 200)), 0);
    stream[300] = static_cast<std::uint8_t>(stream[300] ^ xor_of(std::span(stream).subspan(205, 96)));
    stream[301] = static_cast<std::uint8_t>(stream[301] ^ xor_of(reply) ^ xor_of(std::span(stream).subspan(280, 60)));
    ASSERT_EQ(xor_of(std::span(stream).subspan(205, 96)), 0);
    EXPECT_EQ(starts(stream + ping * 10, at, 3), (std::vector<std::uint64_t>{at, at + 60, at + 65}));
}

/// Any number of such streams, joined at every packet of the false phase, and with a loss up to there while in step.
TEST(daisy_false_phase, is_left_unless_it_is_documented_all_through) {
    test::rng d(20261126);
    std::size_t drawn = 0, latest = 0;
    while (drawn != 1000) {
        const auto t = test::draw_two_phases(d);
        if (!t) continue;
        ++drawn;
        const std::size_t period = t->period.size(), times = 3000 / period + 3;
        for (const auto& into : t->lie) {
            const bytes join = from(t->period * times, into.at), cut = t->period * 3 + join;
            for (const bytes& stream : {join, cut}) {
                const std::size_t fault = stream.size() - join.size();
                std::vector<bool> found(stream.size());
                daisy::decoder decoder;
                read<daisy::format>(decoder, stream, [&](const daisy::event& e) { if (e) found[static_cast<std::size_t>(e.offset)] = true; });
                for (std::size_t i = 0; i != times; ++i)
                    for (const auto& p : t->truth) {
                        const std::size_t at = i * period + p.at;
                        if (at < into.at || at - into.at + test::max_packet > join.size()) continue;
                        if (!found[fault + at - into.at]) latest = std::max(latest, at - into.at);
                    }
            }
        }
        ASSERT_LT(latest, 512U) << "of stream " << drawn;
    }
    std::printf("%zu streams with two phases: the last packet missed began %zu bytes behind the fault\n", drawn, latest);
}

}  // namespace
