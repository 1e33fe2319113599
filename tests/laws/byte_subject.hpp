#pragma once
// What daisy and gateway have in common as subjects of the laws: their unit is a byte.

#include <gtest/gtest.h>

#include "laws/subject.hpp"

namespace trama::test {

struct byte_subject {
    /// Events tile the stream.
    static void check_place(const auto& e, std::uint64_t& place, std::vector<bool>&) {
        EXPECT_EQ(e.offset, place) << "a gap or an overlap between two events";
        place = e.offset + e.length;
    }
    static std::string show(std::span<const std::uint8_t> units) {
        std::string text;
        for (const std::uint8_t b : units) {
            constexpr std::string_view digits = "0123456789abcdef";
            text += digits[b >> 4];
            text += digits[b & 15];
        }
        return text;
    }
    static void change(rng& random, std::uint8_t& b) {
        b = random.one_in(2) ? static_cast<std::uint8_t>(b ^ 1U << random.below(8)) : random.byte();
    }
};

inline void append(octets& to, const octets& more) { to.insert(to.end(), more.begin(), more.end()); }

}  // namespace trama::test
