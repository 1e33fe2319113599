// Every content of numbers of gateway records over an alphabet, against the slow reader. [gateway; D15, D16]
#include <gtest/gtest.h>

#include "golden/slow_numbers.hpp"
#include "trama/trama.hpp"

namespace trama::golden {
namespace {

using namespace gateway;

/// Calls `f` with all strings of `width` characters of `alphabet`.
void each_string(std::size_t width, std::string_view alphabet, auto&& f) {
    std::string s(width, alphabet[0]);
    std::vector<std::size_t> digit(width, 0);
    for (;;) {
        f(std::as_const(s));
        std::size_t i = 0;
        while (i != width && ++digit[i] == alphabet.size()) {
            digit[i] = 0;
            s[i] = alphabet[0];
            ++i;
        }
        if (i == width) return;
        s[i] = alphabet[digit[i]];
    }
}
std::vector<std::uint8_t> record_of(std::string_view payload) {
    std::vector<std::uint8_t> all(payload.size() + 2, 0x02);
    std::copy(payload.begin(), payload.end(), all.begin() + 1);
    all.back() = 0x03;
    return all;
}
/// `columns` in place of the characters at `at` of a record; what `field` of the message M reads as, or nothing with bad_number.
template <class M, auto Member>
std::optional<std::int64_t> read_in(std::vector<std::uint8_t>& wire, std::size_t at, std::string_view columns, bool& sound) {
    std::copy(columns.begin(), columns.end(), wire.begin() + 1 + static_cast<std::ptrdiff_t>(at));
    decoder d;
    std::span<const std::uint8_t> in = wire;
    const auto event = d.next(in);
    const auto m = decode<M>(event.packet);
    const auto v = view_as<M>(event.packet);
    sound = event.code == errc::ok && in.empty() && v.has_value();
    if (!sound) return std::nullopt;
    const auto one = v->template get<Member>();
    const error expected{errc::bad_number, {static_cast<std::uint8_t>(index_of<M, Member>())}};
    sound = m ? (one && *one == (*m).*Member) : (m.error() == expected && one.error() == expected);
    if (!m) return std::nullopt;
    return static_cast<std::int64_t>((*m).*Member);
}

constexpr std::string_view digits_and_space = "0123456789 ";

template <class M, auto Member>
void compare(std::string_view payload, std::size_t at, std::size_t width, std::string_view alphabet, auto&& slow) {
    auto wire = record_of(payload);
    std::size_t wrong = 0;
    std::string first_wrong;
    each_string(width, alphabet, [&](const std::string& s) {
        bool sound = false;
        const auto got = read_in<M, Member>(wire, at, s, sound);
        if (sound && got == slow(s)) return;
        if (wrong++ == 0) first_wrong = '"' + s + '"';
    });
    EXPECT_EQ(wrong, 0U) << "first: " << first_wrong << " alphabet \"" << alphabet << '"';
}

TEST(numbers, five_columns_of_digits_spaces_and_a_foreign_character) {
    for (const char foreign : {'x', '-', '.', '/', ':'}) compare<idle_processing, &idle_processing::msg_id>(" 50    0", 3, 5, std::string(digits_and_space) + foreign, slow_number);
}
TEST(numbers, every_printable_character_in_every_column) {
    for (std::size_t at = 0; at != 5; ++at)
        for (char c = 0x20; c != 0x7F; ++c)
            for (std::string s : {"     ", "00000", "12345", "  7  ", "9    ", "    8"}) {
                s[at] = c;
                auto wire = record_of(" 50    0");
                bool sound = false;
                const auto got = read_in<idle_processing, &idle_processing::msg_id>(wire, 3, s, sound);
                ASSERT_TRUE(sound) << '"' << s << '"';
                ASSERT_EQ(got, slow_number(s)) << '"' << s << '"';
            }
}
TEST(numbers, three_two_and_one_column) {
    compare<ack, &ack::src_type>("101    1    2 50    3", 13, 3, "0123456789 x-", slow_number);
    const std::string load_55 = "  1    1    2    3    4 5" + std::string(30, ' ');
    compare<load, &load::level>(load_55, 23, 2, "0123456789 x-", slow_number);
    const std::string circuit = "201    8 48.2 12.5    7      054";
    compare<circuit_state, &circuit_state::target_mode>(circuit, 30, 1, "0123456789 x-.", slow_number);
    compare<circuit_state, &circuit_state::mode>(circuit, 31, 1, "0123456789 x-.", slow_number);
}
TEST(numbers, seven_columns) {
    compare<circuit_state, &circuit_state::check>("201    8 48.2 12.5    7      054", 23, 7, "0159 x", slow_number);
}
std::string cart_payload() {
    std::string p = "200   31   12 7043  101 45  102  103 12501";
    const std::string order = "2  2    0   17    3 4" + std::string(30, ' ') + "1" + std::string(30, ' ');
    return p + order + order;
}
TEST(numbers, speed_alone_may_be_negative) {
    compare<cart_state, &cart_state::speed_mms>(cart_payload(), 36, 5, "01279 -x", slow_signed);
    compare<cart_state, &cart_state::speed_mms>(cart_payload(), 36, 5, "0123456789 -", slow_signed);
    compare<cart_state, &cart_state::cart_status>(cart_payload(), 13, 4, "0123456789 -", slow_number);
    compare<cart_state, &cart_state::rel_position>(cart_payload(), 23, 3, "0123456789 -", slow_number);
}
TEST(numbers, decimals) {
    compare<circuit_state, &circuit_state::circuit_voltage>("201    8 48.2 12.5    7      054", 8, 5, "0123456789 .", slow_tenths);
    compare<circuit_state, &circuit_state::circuit_current>("201    8 48.2 12.5    7      054", 13, 5, "0159 .-,", slow_tenths);
}
/// The record's own type: blank is no number, any other number without a message is unknown.
TEST(numbers, the_type_of_a_record) {
    constexpr int types[] = {1, 2, 3, 10, 15, 20, 21, 22, 23, 30, 50, 100, 101, 102, 200, 201};
    each_string(3, "0123456789 x-", [&](const std::string& s) {
        const auto wire = record_of(s + "    0");  // the length of idle_processing
        decoder d;
        std::span<const std::uint8_t> in = wire;
        const auto event = d.next(in);
        const auto type = slow_number(s);
        errc expected = errc::unknown_message;
        if (!type || s == "   ") expected = errc::bad_number;
        else if (*type == 50) expected = errc::ok;
        else if (std::find(std::begin(types), std::end(types), *type) != std::end(types)) expected = errc::bad_length;
        ASSERT_EQ(event.code, expected) << '"' << s << '"';
        ASSERT_EQ(event.length, wire.size());
        if (expected == errc::unknown_message) {
            ASSERT_EQ(event.packet.type(), *type);
        }
    });
}
/// All values that the columns hold, written and read back, on either side.
TEST(numbers, every_value_of_five_columns_is_written_as_it_is_read) {
    for (std::uint32_t v = 0; v <= 99999; ++v) {
        const std::string plain = std::to_string(v), blank(5 - plain.size(), ' ');
        for (const justify side : {justify::right, justify::left}) {
            std::array<std::uint8_t, 10> out{};
            const auto size = encode(idle_processing{v}, out, side);
            ASSERT_TRUE(size);
            const std::string expected = side == justify::right ? "\x02 50" + blank + plain + "\x03" : "\x02" "50 " + plain + blank + "\x03";
            ASSERT_EQ(std::string(out.begin(), out.end()), expected);
        }
    }
}

}  // namespace
}  // namespace trama::golden
