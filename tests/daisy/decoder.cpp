#include "trama/daisy/decoder.hpp"

#include <gtest/gtest.h>

#include <string>

#include "laws/listener.hpp"
#include "laws/daisy_subject.hpp"

namespace trama::daisy {
namespace {

using test::append;
using test::octets;
using test::sealed;

/// `code offset+length` of everything that the decoder says of `stream`, whatever the cut.
std::string events(const octets& stream, std::vector<std::size_t> idle_at = {}, bool finish = true) {
    std::string first;
    for (const test::cut how : test::all_cuts) {
        std::string all;
        decoder d;
        const auto note = [&](const event& e) { all += std::string(trama::name_of(e.code)) + ' ' + std::to_string(e.offset) + '+' + std::to_string(e.length) + ' '; };
        std::size_t at = 0;
        const std::size_t step = how == test::cut::whole ? stream.size() : how == test::cut::large ? 7 : 1;
        for (auto stops = idle_at; at != stream.size();) {
            const std::size_t stop = stops.empty() ? stream.size() : stops.front();
            const std::size_t n = std::min(step, stop - at);
            read<format>(d, std::span(stream).subspan(at, n), note);
            at += n;
            if (at == stop && !stops.empty()) {
                d.idle();
                read<format>(d, {}, note);
                stops.erase(stops.begin());
            }
        }
        if (finish) {
            d.finish();
            read<format>(d, {}, note);
        }
        if (!all.empty()) all.pop_back();
        if (first.empty()) first = all;
        EXPECT_EQ(all, first) << "cut " << name_of(how);
    }
    return first;
}
octets joined(std::initializer_list<octets> parts) {
    octets all;
    for (const octets& p : parts) append(all, p);
    return all;
}

const octets ping{0x04, 0x11, 0x00, 0x03, 0x16};
const octets poll = sealed(0x11, 0x00, 0x43, {});
const octets answer = sealed(0x00, 0x11, 0xC3, {1, 2, 3, 4});
const octets strange = sealed(0x11, 0x00, 0x5A, {1, 2});

TEST(daisy_decoder, delivers_packet_after_packet) {
    EXPECT_EQ(events(joined({ping, poll, answer})), "ok 0+5 ok 5+5 ok 10+9");
    EXPECT_EQ(events({}), "");
}

TEST(daisy_decoder, skips_noise_at_the_start_as_one_event) {
    EXPECT_EQ(events(joined({{0xAA, 0x55, 0x00}, ping})), "noise 0+3 ok 3+5");
    EXPECT_EQ(events(octets(300, 0xAA)), "noise 0+300");
    EXPECT_EQ(events(joined({octets(700, 0xAA), ping})), "noise 0+700 ok 700+5");
}

TEST(daisy_decoder, an_undocumented_packet_is_delivered_only_in_step) {
    EXPECT_EQ(events(joined({strange, ping})), "noise 0+7 ok 7+5");
    EXPECT_EQ(events(joined({ping, strange, ping})), "ok 0+5 unknown_message 5+7 ok 12+5");
    const octets group_9 = sealed(0x91, 0x00, 0x43, {});
    EXPECT_EQ(events(joined({ping, group_9, ping})), "ok 0+5 unknown_message 5+5 ok 10+5");
    const octets group_F = sealed(0xF1, 0x00, 0x03, {}), everyone_asked = sealed(0xFF, 0x00, 0x43, {});
    EXPECT_EQ(events(joined({ping, group_F})), "ok 0+5 ok 5+5") << "a common command under any address has a meaning";
    EXPECT_EQ(events(joined({ping, everyone_asked})), "ok 0+5 unknown_message 5+5");
    EXPECT_EQ(events(joined({ping, sealed(0x11, 0x00, 0x84, {0})})), "ok 0+5 unknown_message 5+6") << "ERROR has no response";
}

TEST(daisy_decoder, an_unknown_message_is_delivered_raw_and_can_be_passed_on_unchanged) {
    decoder d;
    const octets stream = joined({ping, strange});
    std::span<const std::uint8_t> in(stream);
    (void)d.next(in);
    const event e = d.next(in);
    ASSERT_EQ(e.code, errc::unknown_message);
    EXPECT_TRUE(std::equal(e.packet.bytes().begin(), e.packet.bytes().end(), strange.begin(), strange.end()));
    EXPECT_EQ(e.packet.command(), 0x5A);
    EXPECT_EQ(e.packet.body().size(), 2U);
    EXPECT_EQ(visit<format>(e.packet, [](const auto&) {}).code, errc::unknown_message);
    EXPECT_EQ(d.counters().packets, 1U);
    EXPECT_EQ(d.counters().count(errc::unknown_message), 1U);
    EXPECT_EQ(d.counters().skipped, 0U);
}

TEST(daisy_decoder, tells_rejected_packet_and_both_checksums_of_a_bad_one) {
    octets bad = answer;
    bad[5] ^= 0x10;
    const octets stream = joined({ping, bad, ping});
    for (std::size_t chunk = 1; chunk <= stream.size(); ++chunk) {
        decoder d;
        bool seen = false;
        for (std::size_t at = 0; at < stream.size(); at += chunk)
            read<format>(d, std::span(stream).subspan(at, std::min(chunk, stream.size() - at)), [&](const event& e) {
                if (e.code == errc::ok) return;
                seen = true;
                EXPECT_EQ(e.code, errc::bad_checksum);
                EXPECT_EQ(e.offset, 5U);
                EXPECT_EQ(e.length, 9U);
                EXPECT_EQ(octets(e.rejected.begin(), e.rejected.end()), bad);
                EXPECT_EQ(e.received, bad.back());
                EXPECT_EQ(e.expected, bad.back() ^ 0x10);
                EXPECT_EQ(octets(e.bytes.begin(), e.bytes.end()), bad);
            });
        EXPECT_TRUE(seen) << "chunks of " << chunk;
    }
}

TEST(daisy_decoder, the_rejected_packet_may_be_longer_than_what_is_skipped) {
    octets bad = sealed(0x11, 0x00, 0x5A, octets(40, 0x77));
    std::copy(ping.begin(), ping.end(), bad.begin() + 20);  // intact packets inside
    bad.back() ^= 1;
    const octets stream = joined({ping, bad, ping});
    decoder d;
    std::span<const std::uint8_t> in(stream);
    (void)d.next(in);
    const event e = d.next(in);
    ASSERT_EQ(e.code, errc::bad_checksum);
    EXPECT_EQ(e.length, 20U);
    EXPECT_EQ(e.bytes.size(), 20U);
    EXPECT_EQ(octets(e.rejected.begin(), e.rejected.end()), bad);
    EXPECT_EQ(d.next(in).code, errc::ok);
}

TEST(daisy_decoder, a_length_that_is_impossible_is_refused_at_the_header) {
    EXPECT_EQ(events(joined({ping, {3}, ping})), "ok 0+5 bad_length 5+1 ok 6+5");
    decoder d;
    const octets stream = joined({ping, {200, 0x11, 0x00, 0x43}, ping});
    std::span<const std::uint8_t> in(stream);
    (void)d.next(in);
    const event e = d.next(in);  // a GET ENCODER of 201 bytes: its rest is not waited for
    EXPECT_EQ(e.code, errc::bad_length);
    EXPECT_EQ(e.length, 4U);
    EXPECT_EQ(d.next(in).code, errc::ok);
}

TEST(daisy_decoder, readings_and_errors_are_refused_at_their_first_data_byte) {
    EXPECT_EQ(events(joined({ping, {7, 0x00, 0x31, 0xC4, 0x03}, ping})), "ok 0+5 bad_length 5+5 ok 10+5");
    EXPECT_EQ(events(joined({ping, sealed(0x00, 0x11, 0x04, {1, 2}), ping})), "ok 0+5 bad_length 5+7 ok 12+5");
    EXPECT_EQ(events(joined({ping, sealed(0x00, 0x11, 0x04, {0, 4, 1, 2, 3, 9}), ping})), "ok 0+5 bad_length 5+11 ok 16+5") << "code 0 with 5 bytes behind it";
}

TEST(daisy_decoder, waits_for_the_rest_of_a_packet_without_losing_it) {
    EXPECT_EQ(events(joined({ping, octets(answer.begin(), answer.begin() + 6)}), {}, false), "ok 0+5");
    EXPECT_EQ(events(joined({ping, octets(answer.begin(), answer.begin() + 6)})), "ok 0+5 truncated 5+6");
}

TEST(daisy_decoder, the_longest_packet_goes_through_in_any_cut) {
    const octets longest = sealed(0x00, 0x11, 0x81, octets(251, 'x'));
    ASSERT_EQ(longest.size(), max_packet);
    EXPECT_EQ(events(joined({longest, longest, ping})), "ok 0+256 ok 256+256 ok 512+5");
}

TEST(daisy_decoder, idle_ends_a_partial_packet_and_makes_the_next_byte_a_first_one) {
    EXPECT_EQ(events(joined({ping, {0x09, 0x00}, answer}), {7}), "ok 0+5 truncated 5+2 ok 7+9");
    EXPECT_EQ(events(joined({ping, answer}), {5}), "ok 0+5 ok 5+9") << "silence between packets is no event";
    EXPECT_EQ(events(joined({{0xAA, 0xBB}, strange}), {2}), "noise 0+2 unknown_message 2+7") << "after silence a packet is in step";
    EXPECT_EQ(events(joined({ping, answer}), {2}), "truncated 0+2 bad_length 2+3 ok 5+9");
}

TEST(daisy_decoder, finish_finds_the_packets_inside_a_cut_one) {
    octets cut = sealed(0x11, 0x00, 0x5A, octets(100, 0x77));
    cut.resize(30);
    std::copy(poll.begin(), poll.end(), cut.begin() + 20);
    EXPECT_EQ(events(joined({ping, cut})), "ok 0+5 truncated 5+20 ok 25+5 truncated 30+5");
}

TEST(daisy_decoder, reset_forgets_everything_but_the_counters) {
    decoder d;
    octets stream = joined({ping, {0x09, 0x00}});
    read<format>(d, stream, [](const event&) {});
    EXPECT_EQ(d.pending(), 2U);
    EXPECT_EQ(d.offset(), 5U);
    d.reset();
    EXPECT_EQ(d.pending(), 0U);
    EXPECT_EQ(d.offset(), 0U);
    EXPECT_EQ(d.counters().packets, 1U);
    std::span<const std::uint8_t> in(strange);
    EXPECT_EQ(d.next(in).code, errc::need_more) << "it hunts again";
    d.finish();
    EXPECT_EQ(d.next(in).code, errc::noise);
    EXPECT_EQ(d.counters().skipped, strange.size());
}

TEST(daisy_decoder, a_packet_whole_in_the_chunk_is_viewed_in_place) {
    decoder d;
    const octets stream = joined({ping, answer, strange, sealed(0x00, 0x11, 0x81, octets(60, 'x'))});
    std::span<const std::uint8_t> in(stream);
    std::size_t at = 0, n = 0;
    for (event e = d.next(in); e.code != errc::need_more; e = d.next(in)) {
        EXPECT_EQ(e.packet.bytes().data(), stream.data() + at);
        at += e.length;
        ++n;
    }
    EXPECT_EQ(n, 4U);
}

TEST(daisy_decoder, the_view_of_a_packet_that_straddles_chunks_lives_until_the_next_call) {
    decoder d;
    const octets stream = joined({answer, ping});
    octets front(stream.begin(), stream.begin() + 4), back(stream.begin() + 4, stream.end());
    std::span<const std::uint8_t> in(front);
    EXPECT_EQ(d.next(in).code, errc::need_more);
    in = back;
    const event e = d.next(in);
    ASSERT_EQ(e.code, errc::ok);
    std::fill(front.begin(), front.end(), std::uint8_t{0});
    EXPECT_EQ(octets(e.packet.bytes().begin(), e.packet.bytes().end()), answer);
    EXPECT_EQ(d.pending(), 0U);
    const event second = d.next(in);
    EXPECT_EQ(second.packet.bytes().data(), back.data() + 5) << "what follows is viewed in place again";
}

TEST(daisy_decoder, a_false_packet_made_of_whole_poll_cycles_is_not_taken) {
    octets stream;
    for (int i = 0; i != 40; ++i) append(stream, joined({poll, answer}));
    const auto at = static_cast<std::ptrdiff_t>(std::find(stream.begin(), stream.end(), 0xC3) - stream.begin());
    stream.erase(stream.begin(), stream.begin() + at);
    ASSERT_EQ(checksum(std::span(stream).first(0xC4)), 0) << "196 bytes, 14 cycles: the CRC is good";
    EXPECT_EQ(events(stream).substr(0, 21), "noise 0+6 ok 6+5 ok 1");
}

TEST(daisy_decoder, a_text_full_of_packets_does_not_win_while_hunting) {
    const octets wrapped = sealed(0x00, 0x11, 0x81, joined({ping, answer}));
    EXPECT_EQ(events(joined({wrapped, ping})), "noise 0+4 ok 4+5 ok 9+9 truncated 18+1 ok 19+5");  // its CRC 82 looks like a LEN
    EXPECT_EQ(events(joined({ping, wrapped, ping})).substr(0, 6), "ok 0+5");
}

TEST(daisy_decoder, a_report_that_agrees_with_itself_is_waited_for_though_a_packet_lies_inside) {
    const octets rejected = sealed(0x00, 0x31, 0xC4, {0x3F, 0xC8, 0, 0x2C, 1, 0, 0, 0xFF, 3, 0x0A, 0, 0x94, 0x75});  // intact itself
    octets data{0};
    append(data, rejected);
    data.push_back(rejected.back());
    const octets report = sealed(0x31, 0x00, 0x04, data);
    EXPECT_EQ(events(joined({report, ping})), "ok 0+25 ok 25+5") << "the same in any cut";
    data.back() ^= 1;
    EXPECT_EQ(events(joined({sealed(0x31, 0x00, 0x04, data), ping})).substr(0, 15), "noise 0+5 ok 5+") << "one that does not agree is given up";
}

TEST(daisy_decoder, a_long_false_start_is_given_up_as_soon_as_a_packet_lies_inside) {
    const octets text_of_201_bytes{0xC8, 0x00, 0x11, 0x81, 'x'}, damaged{0x04, 0x11, 0x00, 0x03, 0x17};
    for (const octets& before : {octets{}, joined({ping, damaged}), joined({ping, damaged, octets(40, 0)})}) {
        const octets stream = joined({before, text_of_201_bytes, ping});
        for (const std::size_t chunk : {std::size_t{1}, stream.size()}) {
            decoder d;
            std::uint64_t latest = 0;
            for (std::size_t i = 0; i != stream.size(); i += chunk)
                read<format>(d, std::span(stream).subspan(i, chunk), [&](const event& e) { if (e) latest = e.offset; });
            EXPECT_EQ(latest, stream.size() - ping.size()) << "behind " << before.size() << " bytes, in chunks of " << chunk;
        }
    }
}

TEST(daisy_decoder, seek_numbers_the_next_byte_whatever_is_pending) {
    decoder d;
    std::uint64_t at = 0;
    const auto note = [&](const event& e) { if (e) at = e.offset; };
    read<format>(d, std::span(answer).first(3), note);
    d.seek(1000);
    EXPECT_EQ(d.offset(), 997U);
    read<format>(d, std::span(answer).subspan(3), note);
    EXPECT_EQ(at, 997U);
    EXPECT_EQ(d.offset(), 1006U);
}

TEST(daisy_decoder, delivers_before_it_needs_the_next_byte) {
    decoder d;
    const octets stream = joined({ping, answer, strange});
    std::size_t delivered = 0;
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i != stream.size(); ++i)
        read<format>(d, std::span(stream).subspan(i, 1), [&](const event&) { ++delivered; at.push_back(i + 1); });
    EXPECT_EQ(at, (std::vector<std::size_t>{5, 14, 21}));
    EXPECT_EQ(delivered, 3U);
}

}  // namespace
}  // namespace trama::daisy
