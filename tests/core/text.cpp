#include "trama/core/text.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace trama {
namespace {

TEST(text, is_its_padded_characters) {
    const text<5> a = "A", padded = "A ", full = "A    ";
    EXPECT_EQ(a, padded);
    EXPECT_EQ(a, full);
    EXPECT_NE(a, text<5>(" A"));
    EXPECT_EQ(text<5>{}, text<5>("     "));
}

TEST(text, shows_itself_without_the_spaces_on_the_right_only) {
    const text<6> t = " a b ", blank;
    EXPECT_EQ(t.view(), " a b");
    EXPECT_EQ(blank.view(), "");
}

TEST(text, tells_whether_a_frame_can_carry_it) {
    EXPECT_TRUE(text<3>("~ !").printable());
    for (const char c : {'\0', '\x02', '\x03', '\x1F', '\x7F', '\x80', '\xFF'}) EXPECT_FALSE(text<3>(std::string_view(&c, 1)).printable());
}

TEST(text, longer_than_its_field_is_marked_and_not_cut_silently) {
    EXPECT_TRUE(text<3>("abc").printable());
    EXPECT_FALSE(text<3>("abc").too_long());
    EXPECT_FALSE(text<3>("a\x02").too_long());
    EXPECT_TRUE(text<3>("abcd").too_long());
    EXPECT_FALSE(text<3>("abcd").printable());
    EXPECT_FALSE(text<3>("abc ").printable()) << "four characters are not three, be the last one a space";
}

/// Characters of somebody else's string type.
struct label {
    constexpr operator std::string_view() const noexcept { return "abc"; }
};
TEST(text, takes_every_kind_of_string) {
    const std::string kept = "abc";
    const text<5> expected = "abc";
    EXPECT_EQ(text<5>(kept), expected);
    EXPECT_EQ(text<5>(std::string_view("abcd").substr(0, 3)), expected);
    EXPECT_EQ(text<5>(kept.c_str()), expected);
    static_assert(text<5>(label{}) == text<5>("abc"));
    text<5> assigned;
    assigned = kept;
    EXPECT_EQ(assigned, expected);
    assigned = std::string(6, 'x');
    EXPECT_TRUE(assigned.too_long());
    assigned = {};
    EXPECT_EQ(assigned, text<5>());
    static_assert(!std::is_convertible_v<int, text<5>> && !std::is_convertible_v<char, text<5>> && !std::is_convertible_v<text<4>, text<5>>);
}

TEST(text, a_view_of_bytes_compares_by_content) {
    const std::array<std::uint8_t, 3> a{1, 2, 3}, b{1, 2, 3}, c{1, 2, 4};
    EXPECT_EQ(byte_view(a), byte_view(b));
    EXPECT_FALSE(byte_view(a) == byte_view(c));
    EXPECT_FALSE(byte_view(a) == byte_view(std::span(b).first(2)));
    EXPECT_TRUE(byte_view{}.empty());
    EXPECT_EQ(byte_view(a)[2], 3);
}

TEST(text, a_bounded_list_takes_what_it_has_room_for) {
    bounded_list<std::uint16_t, 3> list{1, 2};
    EXPECT_EQ(list.size(), 2U);
    EXPECT_TRUE(list.push_back(3));
    EXPECT_FALSE(list.push_back(4));
    EXPECT_EQ(list.size(), 3U);
    EXPECT_EQ(std::vector<std::uint16_t>(list.begin(), list.end()), (std::vector<std::uint16_t>{1, 2, 3}));
    list.clear();
    EXPECT_EQ(list.size(), 0U);
    list = {1, 2, 3};
    list.count = 200;
    EXPECT_EQ(list.size(), 3U) << "a count that is wrong never leads outside";
    EXPECT_FALSE(list.push_back(4));
}

TEST(text, bounded_lists_compare_what_they_hold) {
    bounded_list<std::uint16_t, 3> list{1, 2};
    list.count = 1;
    EXPECT_EQ(list, (bounded_list<std::uint16_t, 3>{1})) << "what was there before does not count";
    EXPECT_NE(list, (bounded_list<std::uint16_t, 3>{2}));
    EXPECT_NE(list, (bounded_list<std::uint16_t, 3>{1, 0}));
    EXPECT_NE(list, (bounded_list<std::uint16_t, 3>{}));
}

}  // namespace
}  // namespace trama
