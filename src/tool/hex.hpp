#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace trama::tool {

/// 0..15, or -1 for what is no hex digit.
constexpr int hex_value(char c) noexcept {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

/// Turns a stream of hex digits in pairs into bytes, in place; white space does not count.
class hex_reader {
public:
    /// A character's place in the text, both counted from 1.
    struct place {
        std::uint64_t line = 1, column = 1;
    };

    /// Replaces the text in `bytes` by what it stands for. A run of characters that are neither digits nor space is left
    /// out, and a digit before it that has no partner; `report(place, what)` tells of both.
    std::span<unsigned char> read(std::span<unsigned char> bytes, auto&& report) {
        std::size_t size = 0;
        for (const unsigned char c : bytes) {
            const bool space = c == ' ' || (c >= '\t' && c <= '\r');
            const int value = hex_value(static_cast<char>(c));
            const bool foreign = value < 0 && !space;
            if (foreign) finish(report);
            if (foreign && !foreign_) report(at_, "no hex digit");
            foreign_ = foreign;
            if (!space && !foreign && half_ < 0) odd_ = at_;
            at_ = c == '\n' ? place{at_.line + 1, 1} : place{at_.line, at_.column + 1};
            if (space || foreign) continue;
            if (half_ < 0) { half_ = value; continue; }
            bytes[size++] = static_cast<unsigned char>(half_ << 4 | value);
            half_ = -1;
        }
        return bytes.first(size);
    }
    /// The input ended, or was interrupted: a digit that still has no partner is reported and forgotten.
    void finish(auto&& report) {
        if (half_ >= 0) report(odd_, "the hex digit has no partner");
        half_ = -1;
    }

private:
    int half_ = -1;
    bool foreign_ = false;
    place at_;   ///< Of the next character.
    place odd_;  ///< Of the first digit of the latest pair.
};

}  // namespace trama::tool
