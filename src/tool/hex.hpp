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
    /// Replaces the text in `bytes` by what it stands for; what is read after a foreign character is left out.
    std::span<unsigned char> read(std::span<unsigned char> bytes) noexcept {
        std::size_t size = 0;
        for (const unsigned char c : bytes) {
            if (foreign_) break;
            const bool space = c == ' ' || (c >= '\t' && c <= '\r');
            const int value = hex_value(static_cast<char>(c));
            foreign_ = value < 0 && !space;
            if (foreign_ || (!space && half_ < 0)) place_ = at_;
            if (foreign_) break;
            at_ = c == '\n' ? place{at_.line + 1, 1} : place{at_.line, at_.column + 1};
            if (space) continue;
            if (half_ < 0) { half_ = value; continue; }
            bytes[size++] = static_cast<unsigned char>(half_ << 4 | value);
            half_ = -1;
        }
        return bytes.first(size);
    }
    /// True once a character was no hex digit.
    bool foreign() const noexcept { return foreign_; }
    /// True when a digit has no partner yet.
    bool odd() const noexcept { return half_ >= 0; }
    /// Where that character or digit stands, both counted from 1.
    std::uint64_t line() const noexcept { return place_.line; }
    std::uint64_t column() const noexcept { return place_.column; }

private:
    struct place {
        std::uint64_t line = 1, column = 1;
    };
    int half_ = -1;
    bool foreign_ = false;
    place at_;     ///< Of the next character.
    place place_;  ///< Of the foreign character, or of the first digit of the latest pair.
};

}  // namespace trama::tool
