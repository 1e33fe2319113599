// Traffic whose shifted phases are intact packets too, if not documented ones. No decoder may stay in such a phase.
#include <gtest/gtest.h>

#include <vector>

#include "trama/daisy/format.hpp"

namespace {

using namespace trama;
using bytes = std::vector<std::uint8_t>;

bytes operator*(const bytes& one, std::size_t times) {
    bytes all;
    for (std::size_t i = 0; i != times; ++i) all.insert(all.end(), one.begin(), one.end());
    return all;
}
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

}  // namespace
