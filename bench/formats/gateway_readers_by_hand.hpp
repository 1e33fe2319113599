#pragma once
// Fields of the gateway's records by hand: as one writes it first, and well.
#include <charconv>
#include <cstring>
#include <stdexcept>
#include <string>

#include "trama/core/text.hpp"

namespace trama::bench::by_hand {

inline std::string trimmed(const std::string& s) {
    const auto from = s.find_first_not_of(' ');
    return from == std::string::npos ? std::string() : s.substr(from, s.find_last_not_of(' ') - from + 1);
}

/// Fields by substr, trim and stoull.
class string_reader {
public:
    explicit string_reader(const std::string& payload) : payload_(payload) {}
    bool good() const { return true; }
    void skip(std::size_t columns) { at_ += columns; }

    std::int64_t number(std::size_t columns) {
        const std::string digits = trimmed(take(columns));
        if (digits.empty()) return 0;
        std::size_t used = 0;
        const std::int64_t v = std::stoll(digits, &used);
        if (used != digits.size()) throw std::invalid_argument(digits);
        return v;
    }
    std::int64_t tenths(std::size_t columns) {
        const std::string digits = trimmed(take(columns));
        return digits.empty() ? 0 : static_cast<std::int64_t>(std::stod(digits) * 10 + 0.5);
    }
    template <std::size_t N>
    void text(trama::text<N>& t) { t = std::string_view(take(N)); }

private:
    std::string take(std::size_t n) {
        at_ += n;
        return payload_.substr(at_ - n, n);
    }
    const std::string& payload_;
    std::size_t at_ = 0;
};

/// Fields by trimming in place and from_chars.
class pointer_reader {
public:
    explicit pointer_reader(const char* p) : p_(p) {}
    bool good() const { return good_; }
    void skip(std::size_t columns) { p_ += columns; }

    std::int64_t number(std::size_t columns) {
        const char *from = p_, *to = p_ += columns;
        while (from != to && *from == ' ') ++from;
        while (from != to && to[-1] == ' ') --to;
        std::int64_t v = 0;
        if (from == to) return 0;
        const auto end = std::from_chars(from, to, v);
        good_ &= end.ec == std::errc{} && end.ptr == to;
        return v;
    }
    std::int64_t tenths(std::size_t columns) {
        const char *from = p_, *to = p_ += columns;
        while (from != to && *from == ' ') ++from;
        while (from != to && to[-1] == ' ') --to;
        std::int64_t whole = 0, tenth = 0;
        if (from == to) return 0;
        const auto end = std::from_chars(from, to, whole);
        if (end.ptr != to) {
            good_ &= *end.ptr == '.' && end.ptr + 2 == to;
            tenth = end.ptr[1] - '0';
        }
        return whole * 10 + tenth;
    }
    template <std::size_t N>
    void text(trama::text<N>& t) {
        std::memcpy(t.columns.data(), p_, N);
        p_ += N;
    }

private:
    const char* p_;
    bool good_ = true;
};

}  // namespace trama::bench::by_hand
