#include "trama/core/sink.hpp"

#include <algorithm>
#include <charconv>

namespace trama {

text_sink& text_sink::operator<<(std::string_view s) noexcept {
    const std::size_t n = std::min(s.size(), out_.size() - size_);
    full_ = full_ || n != s.size();
    std::copy_n(s.data(), n, out_.data() + size_);
    size_ += n;
    return *this;
}

text_sink& text_sink::number(std::int64_t v) noexcept {
    char digits[24];
    return *this << std::string_view(digits, static_cast<std::size_t>(std::to_chars(digits, digits + sizeof digits, v).ptr - digits));
}

text_sink& text_sink::unsigned_number(std::uint64_t v) noexcept {
    char digits[24];
    return *this << std::string_view(digits, static_cast<std::size_t>(std::to_chars(digits, digits + sizeof digits, v).ptr - digits));
}

text_sink& text_sink::tenths(std::int64_t v) noexcept {
    return number(v / 10) << '.' << static_cast<char>('0' + v % 10);
}

namespace {
constexpr std::string_view digits = "0123456789abcdef";
}

text_sink& text_sink::hex(std::span<const std::uint8_t> bytes, std::string_view gap) noexcept {
    std::string_view before;
    for (const std::uint8_t b : bytes) {
        const char pair[] = {digits[b >> 4], digits[b & 15]};
        *this << before << std::string_view(pair, 2);
        before = gap;
    }
    return *this;
}

text_sink& text_sink::quoted(std::span<const std::uint8_t> chars) noexcept {
    *this << '"';
    for (const std::uint8_t c : chars) {
        if (c == '"' || c == '\\') *this << '\\' << static_cast<char>(c);
        else if (c >= 0x20 && c < 0x7F) *this << static_cast<char>(c);
        else *this << "\\u00" << digits[c >> 4] << digits[c & 15];
    }
    return *this << '"';
}

text_sink& text_sink::quoted(std::string_view chars) noexcept {
    *this << '"';
    for (const char one : chars) {
        const auto c = static_cast<unsigned char>(one);
        if (c == '"' || c == '\\') *this << '\\' << one;
        else if (c >= 0x20 && c < 0x7F) *this << one;
        else *this << "\\u00" << digits[c >> 4] << digits[c & 15];
    }
    return *this << '"';
}

text_sink& text_sink::allowed(const rule& r) noexcept {
    if (!r.words.empty()) return *this << r.words;
    std::string_view gap;
    for (const std::string_view name : r.names) {
        *this << gap << name;
        gap = "|";
    }
    if (!r.names.empty()) return *this;
    number(r.low);
    if (r.high != r.low) *this << ".." << r.high;
    return *this;
}

}  // namespace trama
