// The vector code against the scalar reference, exhaustively where the space is small.
#include <gtest/gtest.h>

#include "laws/rng.hpp"
#include "trama/core/ascii.hpp"
#include "trama/core/column_map.hpp"

namespace {

using namespace trama;

constexpr std::string_view kinds = "0123456789 -A";  // digits, space, two that are neither

template <std::size_t Columns>
void compare_all() {
    std::size_t all = 1;
    for (std::size_t i = 0; i != Columns; ++i) all *= kinds.size();
    for (std::size_t n = 0; n != all; ++n) {
        std::array<std::uint8_t, 16> field{};
        field.fill('7');  // what follows the field must not matter
        for (std::size_t i = 0, rest = n; i != Columns; ++i, rest /= kinds.size()) field[i] = static_cast<std::uint8_t>(kinds[rest % kinds.size()]);
        std::uint32_t expected = 0, mapped = 0, one = 0;
        const bool bad = read_columns<Columns>(field.data(), expected) != 0;
        const column_map map = map_columns<16, 0xFFFF>(field.data());
        const std::uint64_t others = map.others & ((1U << Columns) - 1);
        const bool mapped_bad = (read_mapped<Columns, 16>(field.data(), map.digits, mapped) & 1) != 0 || others != 0;
        ASSERT_EQ(mapped_bad, bad) << n;
        ASSERT_EQ(read_one<Columns>(field.data(), one) != 0, bad) << n;
        if (bad) continue;
        ASSERT_EQ(mapped, expected) << n;
        ASSERT_EQ(one, expected) << n;
    }
}

TEST(column_map, reads_every_field_of_up_to_five_columns_as_the_reference_does) {
    compare_all<1>();
    compare_all<2>();
    compare_all<3>();
    compare_all<4>();
    compare_all<5>();
}

TEST(column_map, classifies_every_character_at_every_place_as_the_reference_does) {
    for (unsigned c = 0; c != 256; ++c)
        for (std::size_t at = 0; at != 16; ++at) {
            std::array<std::uint8_t, 16> columns{};
            columns.fill(' ');
            columns[at] = static_cast<std::uint8_t>(c);
            ASSERT_EQ(map_columns_vector(columns.data()), map_columns_scalar(columns.data())) << c << " at " << at;
        }
}

TEST(column_map, classifies_columns_of_many_kinds_as_the_reference_does) {
    test::rng random(1);
    for (int n = 0; n != 200000; ++n) {
        std::array<std::uint8_t, 16> columns{};
        for (auto& c : columns) c = static_cast<std::uint8_t>(random.below(4) == 0 ? random.below(256) : static_cast<unsigned>(kinds[random.below(kinds.size())]));
        ASSERT_EQ(map_columns_vector(columns.data()), map_columns_scalar(columns.data())) << n;
    }
}

template <std::size_t Count>
void compare_few() {
    test::rng random(Count);
    for (int n = 0; n != 20000; ++n) {
        std::array<std::uint8_t, Count> bytes{};
        for (auto& b : bytes) b = static_cast<std::uint8_t>(random.within(0x20, 0x7E));
        for (auto strays = random.below(3); strays != 0; --strays) bytes[random.below(Count)] = static_cast<std::uint8_t>(random.below(256));
        ASSERT_EQ(few_printable_vector<Count>(bytes.data()), all_printable_scalar(bytes.data(), Count)) << n;
    }
}

TEST(ascii, tells_of_eight_to_sixteen_characters_whether_all_are_printable) {
    compare_few<8>();
    compare_few<9>();
    compare_few<10>();
    compare_few<11>();
    compare_few<12>();
    compare_few<13>();
    compare_few<14>();
    compare_few<15>();
    compare_few<16>();
}

TEST(ascii, finds_one_stray_character_wherever_it_stands) {
    for (std::size_t size = 0; size != 80; ++size)
        for (std::size_t at = 0; at <= size; ++at)
            for (const unsigned c : {0x00U, 0x1FU, 0x20U, 0x7EU, 0x7FU, 0xFFU}) {
                std::array<std::uint8_t, 80> bytes{};
                bytes.fill('x');
                if (at != size) bytes[at] = static_cast<std::uint8_t>(c);
                ASSERT_EQ(all_printable_vector(bytes.data(), size), all_printable_scalar(bytes.data(), size));
                ASSERT_EQ(printable_run_vector(bytes.data(), size), printable_run_scalar(bytes.data(), size));
            }
}

TEST(decimal, writes_every_number_as_the_loop_does) {
    for (std::uint32_t v = 0; v != 100000; ++v) {
        std::array<std::uint8_t, 5> quick{}, slow{};
        write_few_columns<5>(quick.data(), v);
        write_columns(slow.data(), 5, v);
        ASSERT_EQ(quick, slow) << v;
    }
    for (std::uint32_t v = 0; v != 10000; ++v) {
        std::array<std::uint8_t, 4> quick{}, slow{};
        write_few_columns<4>(quick.data(), v);
        write_columns(slow.data(), 4, v);
        ASSERT_EQ(quick, slow) << v;
    }
    for (std::uint32_t v = 0; v < 10000000; v += 997) {
        std::array<std::uint8_t, 7> quick{}, slow{};
        write_few_columns<7>(quick.data(), v);
        write_columns(slow.data(), 7, v);
        ASSERT_EQ(quick, slow) << v;
    }
}

}  // namespace
