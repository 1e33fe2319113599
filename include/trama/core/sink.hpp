#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <string_view>

#include "trama/core/rule.hpp"
#include "trama/core/text.hpp"

namespace trama {

/// Appends text to a buffer that the caller owns. What does not fit is dropped and `full()` says so.
class text_sink {
public:
    explicit text_sink(std::span<char> out) noexcept : out_(out) {}

    text_sink& operator<<(std::string_view s) noexcept;
    text_sink& operator<<(char c) noexcept { return *this << std::string_view{&c, 1}; }
    /// A whole number in decimal.
    text_sink& number(std::int64_t v) noexcept;
    text_sink& unsigned_number(std::uint64_t v) noexcept;
    text_sink& operator<<(std::integral auto v) noexcept {
        if constexpr (std::is_unsigned_v<decltype(v)>) return unsigned_number(v);
        else return number(v);
    }
    /// A number held in tenths, always with one decimal: 482 prints as 48.2. Not below 0.
    text_sink& tenths(std::int64_t v) noexcept;
    /// Bytes as lower-case pairs of hex digits, `gap` between them.
    text_sink& hex(std::span<const std::uint8_t> bytes, std::string_view gap = {}) noexcept;
    /// Characters as a JSON string with its quotes; controls and bytes from 0x7F on as \u00xx.
    text_sink& quoted(std::span<const std::uint8_t> chars) noexcept;
    text_sink& quoted(std::string_view chars) noexcept;
    /// `low..high`, `a|b|c` or a few words.
    text_sink& allowed(const rule& r) noexcept;

    /// What has been written; lives as long as the buffer.
    std::string_view view() const noexcept { return {out_.data(), size_}; }
    std::size_t size() const noexcept { return size_; }
    bool full() const noexcept { return full_; }
    void clear() noexcept { size_ = 0; full_ = false; }

private:
    std::span<char> out_;
    std::size_t size_ = 0;
    bool full_ = false;
};

}  // namespace trama
