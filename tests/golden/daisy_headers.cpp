// Every header of daisy: the document's tables written out once more as plain rows, and all lengths, groups and commands
// judged by them. Group 6 is a second battery group [D2]; who defines a command is [D3].
#include <gtest/gtest.h>

#include <bit>
#include <vector>

#include "properties.hpp"
#include "trama/trama.hpp"

namespace trama::golden {
namespace {

/// Data sizes of a request and of its response; `none`: there is no such message.
constexpr int none = -1, text = -2, readings = -3, board_error = -4;
struct command_row {
    int family;  ///< Group, or -1 for the commands of all boards.
    int command;
    int request;
    int response;
};
constexpr command_row table[] = {
    {-1, 0x01, 0, text}, {-1, 0x02, 0, text}, {-1, 0x03, 0, 0}, {-1, 0x04, board_error, none},
    {1, 0x40, 1, 0}, {1, 0x41, 3, 0}, {1, 0x42, 4, 0}, {1, 0x43, 0, 4}, {1, 0x44, 0, 0}, {1, 0x45, 2, 0}, {1, 0x46, 0, 2},
    {1, 0x47, 0, 0}, {1, 0x48, 0, 2}, {1, 0x49, 2, 0}, {1, 0x4A, 2, 0}, {1, 0x4B, 0, 3},
    {2, 0x40, 2, 0}, {2, 0x41, 5, 0}, {2, 0x42, 1, 2}, {2, 0x43, 0, 5}, {2, 0x44, 2, 0}, {2, 0x45, 5, 0}, {2, 0x46, 1, 2},
    {2, 0x47, 0, 5}, {2, 0x48, 1, 0}, {2, 0x49, 0, 0}, {2, 0x4A, 0, 1}, {2, 0x4B, 2, 0}, {2, 0x4C, 3, 0},
    {3, 0x40, 1, 0}, {3, 0x41, 1, 0}, {3, 0x42, 1, 0}, {3, 0x43, 0, 1}, {3, 0x44, 1, readings}, {3, 0x45, 1, readings}, {3, 0x46, 1, 0}, {3, 0x47, 2, 0},
    {4, 0x40, 0, 0}, {4, 0x41, 0, 0}, {4, 0x42, 0, 2}, {4, 0x43, 0, 0}, {4, 0x44, 2, 0}, {4, 0x45, 2, 0}, {4, 0x46, 2, 0},
    {5, 0x40, 0, 2}, {5, 0x41, 0, 0}, {5, 0x42, 2, 0},
};

/// The data that the tables give a command between two groups, or `none`.
int data_of(unsigned to, unsigned from, unsigned command) {
    const bool response = command >= 0x80;
    const unsigned code = command & 0x7F;
    unsigned group = response ? from : to;
    if (group == 0) group = response ? to : from;
    if (group == 6) group = 4;
    for (const command_row& r : table) {
        if (static_cast<unsigned>(r.command) != code) continue;
        if (r.family == -1 || (code >= 0x40 && static_cast<unsigned>(r.family) == group)) return response ? r.response : r.request;
    }
    return none;
}
enum class size_fits { no, yes, unknown };
/// Whether `size` bytes can be such data; `first` is the first of them, -1 while it has not come.
size_fits fits(int data, int size, int first) {
    if (data >= 0) return size == data ? size_fits::yes : size_fits::no;
    if (data == text) return size <= 251 ? size_fits::yes : size_fits::no;
    if (data == readings) {
        if (size % 2 == 0 || size > 17) return size_fits::no;
        if (first < 0) return size_fits::unknown;
        return size == 1 + 2 * std::popcount(static_cast<unsigned>(first)) ? size_fits::yes : size_fits::no;
    }
    if (size != 1 && size < 7) return size_fits::no;
    if (first < 0) return size_fits::unknown;
    return (first == 0 ? size >= 7 : size == 1) ? size_fits::yes : size_fits::no;
}
bool documented_groups(unsigned to, unsigned from, unsigned command) {
    return from <= 0x6F && (to <= 0x6F || (to == 0xFF && (command & 0x7F) < 0x40));
}

TEST(daisy_headers, the_tables_hold_93_messages) {
    int messages = 0;
    for (const command_row& r : table) messages += (r.request != none) + (r.response != none);
    EXPECT_EQ(messages, 93);
    EXPECT_EQ(daisy::messages::count, 93U);
}

/// The judgement that recovery rests on, for all lengths, both groups and all commands, with and without a first data byte.
TEST(daisy_headers, every_length_group_and_command_is_judged_by_the_tables) {
    constexpr int firsts[] = {-1, 0x00, 0x01, 0x03, 0x0E, 0x33, 0x1F, 0x3F, 0xFE, 0xFF};
    std::size_t wrong = 0, documented = 0;
    for (unsigned to_group = 0; to_group != 16; ++to_group)
        for (unsigned from_group = 0; from_group != 16; ++from_group)
            for (unsigned command = 0; command != 256; ++command) {
                const unsigned to = to_group << 4 | (to_group == 15 ? 15U : 1U), from = from_group << 4 | 2;
                const int data = data_of(to_group, from_group, command);
                const bool judged_by_first = data == readings || data == board_error;
                for (int len = 0; len != 256; ++len)
                    for (const int first : firsts) {
                        if (!judged_by_first && first > 0) break;
                        const std::array<std::uint8_t, 5> bytes{static_cast<std::uint8_t>(len), static_cast<std::uint8_t>(to), static_cast<std::uint8_t>(from),
                                                                static_cast<std::uint8_t>(command), static_cast<std::uint8_t>(first < 0 ? 0x5A : first)};
                        const auto judged = daisy::judge_header(bytes, 0, first < 0 ? 4 : 5);
                        auto expected = daisy::header::open;
                        if (len < 4) expected = daisy::header::impossible;
                        else if (data != none && fits(data, len - 4, first) == size_fits::no) expected = daisy::header::impossible;
                        else if (data != none && documented_groups(to, from, command)) expected = daisy::header::documented;
                        documented += expected == daisy::header::documented;
                        wrong += judged != expected;
                    }
            }
    EXPECT_EQ(wrong, 0U);
    EXPECT_GT(documented, 2U * 252 * 7 * 7);  // both texts alone: every LEN from 4 between 7 by 7 groups
}

/// A whole packet with these header bytes and a good CRC.
std::vector<std::uint8_t> packet_of(unsigned len, unsigned to, unsigned from, unsigned command, unsigned first) {
    std::vector<std::uint8_t> p(len + 1, 0x41);
    const std::uint8_t head[] = {static_cast<std::uint8_t>(len), static_cast<std::uint8_t>(to), static_cast<std::uint8_t>(from), static_cast<std::uint8_t>(command), static_cast<std::uint8_t>(first)};
    for (std::size_t i = 0; i != 5 && i < p.size() - (len >= 4 ? 1U : 0U); ++i) p[i] = head[i];
    if (len < 4) return p;
    p.back() = 0;
    for (std::size_t i = 0; i + 1 < p.size(); ++i) p.back() = static_cast<std::uint8_t>(p.back() ^ p[i]);
    return p;
}
/// What a decoder in step makes of `p`: the code and length of its first event behind a ping.
std::pair<errc, std::uint64_t> in_step(const std::vector<std::uint8_t>& p, std::size_t chunk) {
    constexpr std::array<std::uint8_t, 5> ping{0x04, 0x11, 0x00, 0x03, 0x16};
    std::vector<std::uint8_t> stream(ping.begin(), ping.end());
    stream.insert(stream.end(), p.begin(), p.end());
    daisy::decoder d;
    std::pair<errc, std::uint64_t> found{errc::need_more, 0};
    std::size_t seen = 0;
    const bool conserved = properties::feed<daisy::format>(d, stream, [=](std::size_t) { return chunk; }, [&](const daisy::event& e) {
        if (seen++ == 1) found = {e.code, e.offset == 5 ? e.length : 0};
    });
    return conserved ? found : std::pair{errc::ok, std::uint64_t{0}};
}

/// The stream decoder itself, in step, for every length and command between every pair of families.
TEST(daisy_headers, a_decoder_in_step_takes_what_the_tables_define) {
    constexpr std::pair<unsigned, unsigned> addresses[] = {
        {0x00, 0x00}, {0x11, 0x00}, {0x2F, 0x00}, {0x32, 0x00}, {0x4E, 0x00}, {0x51, 0x00}, {0x62, 0x00}, {0x72, 0x00}, {0xFF, 0x00}, {0xF1, 0x00},
        {0x00, 0x11}, {0x00, 0x22}, {0x00, 0x33}, {0x00, 0x44}, {0x00, 0x55}, {0x00, 0x66}, {0x00, 0x77}, {0x12, 0x21}, {0x35, 0x53}, {0xFF, 0x31},
    };
    for (const auto& [to, from] : addresses)
        for (unsigned command = 0; command != 256; ++command) {
            const int data = data_of(to >> 4, from >> 4, command);
            for (unsigned len = 0; len <= 255; len += len < 24 ? 1U : 33U) {
                for (const unsigned first : {0x00U, 0x01U, 0x3FU, 0xFFU}) {
                    if (first != 0 && data != readings && data != board_error) break;
                    const std::uint8_t shown = static_cast<std::uint8_t>(data == text ? 0x41 : first);
                    const auto p = packet_of(len, to, from, command, shown);
                    const bool possible = len >= 4 && (data == none || fits(data, static_cast<int>(len) - 4, static_cast<int>(shown)) == size_fits::yes);
                    const errc expected = !possible ? errc::bad_length : data == none ? errc::unknown_message : errc::ok;
                    for (const std::size_t chunk : {p.size() + 5, std::size_t{1}}) {
                        const auto [code, length] = in_step(p, chunk);
                        ASSERT_EQ(code, expected) << "len " << len << " to " << to << " from " << from << " command " << command << " first " << first << " chunk " << chunk;
                        if (possible) {
                            ASSERT_EQ(length, p.size());
                        }
                    }
                }
            }
        }
}

/// An impossible length is a fault as soon as the header shows it, not when the rest has come.
TEST(daisy_headers, an_impossible_length_is_refused_without_waiting_for_the_rest) {
    const auto events_after = [](std::vector<std::uint8_t> bad) {
        constexpr std::array<std::uint8_t, 5> ping{0x04, 0x11, 0x00, 0x03, 0x16};
        std::vector<std::uint8_t> stream(ping.begin(), ping.end());
        stream.insert(stream.end(), bad.begin(), bad.end());
        stream.insert(stream.end(), ping.begin(), ping.end());
        daisy::decoder d;
        std::span<const std::uint8_t> in = stream;
        std::string codes;
        for (;;) {
            const auto e = d.next(in);
            codes += std::string(name_of(e.code)) + ' ';
            if (e.code == errc::need_more) return codes;
        }
    };
    EXPECT_EQ(events_after({0xFA, 0x11, 0x00, 0x40}), "ok bad_length ok need_more ");        // set_direction has LEN 5
    EXPECT_EQ(events_after({0x15, 0x00, 0x31, 0xC4, 0x01}), "ok bad_length ok need_more ");  // one sensor: LEN 7
    EXPECT_EQ(events_after({0x08, 0x00, 0x31, 0xC4}), "ok bad_length ok need_more ");        // readings: never an even LEN
    EXPECT_EQ(events_after({0x20, 0x00, 0x11, 0x04, 0x01}), "ok bad_length ok need_more ");  // code 1 stands alone
    EXPECT_EQ(events_after({0x07, 0x00, 0x11, 0x04}), "ok bad_length ok need_more ");        // error: LEN 5 or 11 and more
    EXPECT_EQ(events_after({0x03}), "ok bad_length ok need_more ");
}

}  // namespace
}  // namespace trama::golden
