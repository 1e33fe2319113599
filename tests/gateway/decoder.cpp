#include "trama/gateway/decoder.hpp"

#include <gtest/gtest.h>

#include <string>

#include "laws/gateway_subject.hpp"
#include "laws/listener.hpp"

namespace trama::gateway {
namespace {

using test::octets;

/// STX and ETX stand as `<` and `>`.
octets wire(std::string_view text) {
    octets all;
    for (const char c : text) all.push_back(c == '<' ? stx : c == '>' ? etx : static_cast<std::uint8_t>(c));
    return all;
}
/// `code offset+length` of everything, the same in any cut.
std::string events(const octets& stream, bool finish = true) {
    std::string first;
    for (const std::size_t step : {stream.size() + 1, std::size_t{1}, std::size_t{2}, std::size_t{7}}) {
        std::string all;
        decoder d;
        const auto note = [&](const event& e) { all += std::string(trama::name_of(e.code)) + ' ' + std::to_string(e.offset) + '+' + std::to_string(e.length) + ' '; };
        for (std::size_t at = 0; at < stream.size(); at += step) read<format>(d, std::span(stream).subspan(at, std::min(step, stream.size() - at)), note);
        if (finish) {
            d.finish();
            read<format>(d, {}, note);
        }
        if (!all.empty()) all.pop_back();
        if (first.empty()) first = all;
        EXPECT_EQ(all, first) << "chunks of " << step;
    }
    return first;
}
std::string events(std::string_view text) { return events(wire(text)); }
const std::string idle = "< 50    1>";

TEST(gateway_decoder, seek_numbers_the_next_byte_whatever_is_pending) {
    decoder d;
    std::uint64_t at = 0;
    const octets record = wire(idle);
    const auto note = [&](const event& e) { if (e) at = e.offset; };
    read<format>(d, std::span(record).first(5), note);
    d.seek(1000);
    EXPECT_EQ(d.offset(), 995U);
    read<format>(d, std::span(record).subspan(5), note);
    EXPECT_EQ(at, 995U);
    EXPECT_EQ(d.offset(), 995U + record.size());
}

TEST(gateway_decoder, delivers_record_after_record) {
    EXPECT_EQ(events(idle + idle), "ok 0+10 ok 10+10");
    EXPECT_EQ(events(""), "");
}

TEST(gateway_decoder, a_run_of_bytes_outside_records_is_one_noise) {
    EXPECT_EQ(events("abc" + idle + "x>y"), "noise 0+3 ok 3+10 noise 13+3");
    EXPECT_EQ(events(">" + idle), "noise 0+1 ok 1+10");
    EXPECT_EQ(events(std::string(1000, 'x') + idle), "noise 0+1000 ok 1000+10");
}

TEST(gateway_decoder, an_stx_inside_a_record_truncates_it_whatever_its_length) {
    EXPECT_EQ(events("<" + idle), "truncated 0+1 ok 1+10");
    EXPECT_EQ(events("< 50  " + idle), "truncated 0+6 ok 6+10");
    EXPECT_EQ(events("<<<" + idle), "truncated 0+1 truncated 1+1 truncated 2+1 ok 3+10");
    EXPECT_EQ(events("<" + std::string(206, 'x') + idle), "truncated 0+207 ok 207+10");
}

TEST(gateway_decoder, the_end_of_the_input_truncates_too) {
    EXPECT_EQ(events("< 50    1"), "truncated 0+9");
    EXPECT_EQ(events("<"), "truncated 0+1");
    EXPECT_EQ(events("abc"), "noise 0+3");
}

TEST(gateway_decoder, a_record_of_the_wrong_length_is_bad_length) {
    EXPECT_EQ(events("<>"), "bad_length 0+2");
    EXPECT_EQ(events("<50>"), "bad_length 0+4") << "fewer characters than a type has";
    EXPECT_EQ(events("< 50>"), "bad_length 0+5");
    EXPECT_EQ(events("< 50    1 >"), "bad_length 0+11");
    EXPECT_EQ(events("< 15    1>"), "bad_length 0+10") << "a go_node has 18 characters";
}

TEST(gateway_decoder, a_type_that_is_no_number_is_a_bad_number_and_an_undocumented_one_unknown) {
    EXPECT_EQ(events("<   12345>"), "bad_number 0+10");
    EXPECT_EQ(events("<5 012345>"), "bad_number 0+10");
    EXPECT_EQ(events("<-50    1>"), "bad_number 0+10");
    EXPECT_EQ(events("<x50>"), "bad_number 0+5");
    EXPECT_EQ(events("<999>"), "unknown_message 0+5");
    EXPECT_EQ(events("<  0    1>"), "unknown_message 0+10");
    EXPECT_EQ(events("<306whatever>"), "unknown_message 0+13") << "306 is 50 + 256";
    EXPECT_EQ(events("<50     1><050    1><50 00001>"), "ok 0+10 ok 10+10 ok 20+10") << "justified and filled as one likes";
}

TEST(gateway_decoder, every_type_is_told_by_its_three_characters) {
    for (unsigned type = 0; type != 1000; ++type) {
        std::array<char, 8> digits{};
        std::snprintf(digits.data(), digits.size(), "%03u", type);
        const std::size_t index = index_of(type);
        const std::size_t size = index == unknown ? 20 : known.payload[index];
        const octets stream = wire("<" + std::string(digits.data()) + std::string(size - 3, ' ') + ">");
        decoder d;
        std::span<const std::uint8_t> in(stream);
        const event e = d.next(in);
        EXPECT_EQ(e.code, index == unknown ? errc::unknown_message : errc::ok) << type;
        EXPECT_EQ(e.packet.type(), type);
        EXPECT_EQ(e.packet.index(), index);
    }
}

TEST(gateway_decoder, a_character_that_is_not_allowed_reaches_to_the_next_delimiter) {
    EXPECT_EQ(events("< 50\x01   1>" + idle), "bad_character 0+10 ok 10+10");
    EXPECT_EQ(events("< 50\x7F   1" + idle), "bad_character 0+9 ok 9+10") << "the STX is the next record's";
    EXPECT_EQ(events("< 50\x80   1"), "bad_character 0+9") << "it wins over truncated";
    for (unsigned c = 0; c != 256; ++c) {
        octets stream = wire(idle);
        stream[5] = static_cast<std::uint8_t>(c);
        const bool printable = c >= 0x20 && c <= 0x7E;
        const std::string right = c == stx ? "truncated 0+5 bad_length 5+5" : c == etx ? "bad_length 0+6 noise 6+4" : printable ? "ok 0+10" : "bad_character 0+10";
        EXPECT_EQ(events(stream), right) << c;
    }
}

TEST(gateway_decoder, an_overlong_record_stays_bad_length_whatever_ends_it) {
    const std::string longest = "<" + std::string(206, '9'), overlong = longest + "9";
    EXPECT_EQ(events(longest + ">" + idle), "unknown_message 0+208 ok 208+10");
    EXPECT_EQ(events(overlong + ">" + idle), "bad_length 0+209 ok 209+10");
    EXPECT_EQ(events(overlong + idle), "bad_length 0+208 ok 208+10");
    EXPECT_EQ(events(overlong), "bad_length 0+208");
    EXPECT_EQ(events(longest), "truncated 0+207");
    EXPECT_EQ(events(overlong + std::string(5000, 'x') + ">" + idle), "bad_length 0+5209 ok 5209+10");
}

TEST(gateway_decoder, bad_character_wins_over_the_others) {
    const std::string overlong = "<" + std::string(300, '9');
    EXPECT_EQ(events(overlong + "\x01>" + idle), "bad_character 0+303 ok 303+10");
    EXPECT_EQ(events("<\x01" + overlong.substr(1) + ">"), "bad_character 0+303");
    EXPECT_EQ(events(overlong + "\x01"), "bad_character 0+302");
    EXPECT_EQ(events("<\x01>"), "bad_character 0+3");
}

/// Recovery law: no fault may cost an intact record. Every byte changed to every value, lost, doubled.
TEST(gateway_decoder, no_single_byte_fault_costs_an_intact_record) {
    const std::string records = idle + "< 15    1    2    3>" + idle;
    const octets clean = wire(records);
    for (std::size_t at = 10; at != 30; ++at)
        for (unsigned value = 0; value != 258; ++value) {
            octets broken = clean;
            const auto place = broken.begin() + static_cast<std::ptrdiff_t>(at);
            if (value == 256) broken.erase(place);
            else if (value == 257) broken.insert(place, clean[at]);
            else *place = static_cast<std::uint8_t>(value);
            const std::string said = events(broken);
            const auto end = broken.size() - 10;
            ASSERT_EQ(said.substr(0, 7), "ok 0+10") << at << ", " << value;
            // A lost ETX is the one fault after which the STX that follows still begins an intact record.
            ASSERT_NE(said.find("ok " + std::to_string(end) + "+10"), std::string::npos) << at << ", " << value << ": " << said;
        }
}

TEST(gateway_decoder, an_unknown_record_is_delivered_raw_and_can_be_passed_on_unchanged) {
    const octets stream = wire("<777 any payload>");
    for (const std::size_t step : {stream.size(), std::size_t{3}}) {
        decoder d;
        octets passed;
        for (std::size_t at = 0; at < stream.size(); at += step)
            read<format>(d, std::span(stream).subspan(at, std::min(step, stream.size() - at)), [&](const event& e) {
                ASSERT_EQ(e.code, errc::unknown_message);
                passed.assign(e.packet.bytes().begin(), e.packet.bytes().end());
                EXPECT_EQ(e.packet.type(), 777);
                EXPECT_EQ(e.packet.payload().size(), 15U);
                EXPECT_EQ(e.packet.body().size(), 12U);
                EXPECT_EQ(visit<format>(e.packet, [](const auto&) {}).code, errc::unknown_message);
            });
        EXPECT_EQ(passed, stream);
        EXPECT_EQ(d.counters().skipped, 0U);
        EXPECT_EQ(d.counters().count(errc::unknown_message), 1U);
    }
}

TEST(gateway_decoder, the_bytes_of_an_error_are_its_first_256) {
    octets stream = wire("<" + std::string(400, '9') + ">");
    for (const std::size_t step : {stream.size(), std::size_t{1}, std::size_t{255}, std::size_t{256}, std::size_t{257}}) {
        decoder d;
        bool seen = false;
        for (std::size_t at = 0; at < stream.size(); at += step)
            read<format>(d, std::span(stream).subspan(at, std::min(step, stream.size() - at)), [&](const event& e) {
                seen = true;
                EXPECT_EQ(octets(e.bytes.begin(), e.bytes.end()), octets(stream.begin(), stream.begin() + 256)) << step;
                EXPECT_EQ(e.length, 402U);
            });
        EXPECT_TRUE(seen);
    }
}

TEST(gateway_decoder, pending_counts_what_has_not_been_reported) {
    decoder d;
    const octets stream = wire(idle + "< 50");
    read<format>(d, stream, [](const event&) {});
    EXPECT_EQ(d.pending(), 4U);
    EXPECT_EQ(d.offset(), 10U);
    d.reset();
    EXPECT_EQ(d.pending(), 0U);
    EXPECT_EQ(d.offset(), 0U);
    EXPECT_EQ(d.counters().packets, 1U);
    d.finish();
    std::span<const std::uint8_t> none;
    EXPECT_EQ(d.next(none).code, errc::need_more) << "nothing is left to end";
}

TEST(gateway_decoder, goes_on_after_the_end) {
    decoder d;
    octets stream = wire("< 50");
    read<format>(d, stream, [](const event&) {});
    d.finish();
    stream = wire(idle);
    std::span<const std::uint8_t> in(stream);
    EXPECT_EQ(d.next(in).code, errc::truncated);
    const event e = d.next(in);
    EXPECT_EQ(e.code, errc::ok);
    EXPECT_EQ(e.offset, 4U);
}

TEST(gateway_decoder, a_record_whole_in_the_chunk_is_viewed_in_place) {
    decoder d;
    const octets stream = wire(idle + "<777>" + idle);
    std::span<const std::uint8_t> in(stream);
    std::size_t at = 0;
    for (event e = d.next(in); e.code != errc::need_more; e = d.next(in)) {
        EXPECT_EQ(e.packet.bytes().data(), stream.data() + at);
        at += e.length;
    }
    EXPECT_EQ(at, stream.size());
}

}  // namespace
}  // namespace trama::gateway
