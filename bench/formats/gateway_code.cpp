// The hand-written code that gateway is compared with.
#include <charconv>
#include <stdexcept>

#include "gateway.hpp"
#include "gateway_by_hand.hpp"

namespace trama::bench::gateway_code {

namespace {

std::string trimmed(const std::string& s) {
    const auto from = s.find_first_not_of(' ');
    return from == std::string::npos ? std::string() : s.substr(from, s.find_last_not_of(' ') - from + 1);
}

/// Fields by substr, trim and stoull.
class string_reader {
public:
    explicit string_reader(const std::string& payload) : payload_(payload) {}

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

template <class M>
constexpr std::size_t payload_of = 3 + M::layout.size;

/// Calls `f(record)` for each record between STX and ETX, byte by byte.
template <class F>
void each_string(bytes_in in, F&& f) {
    std::string record;
    bool inside = false;
    for (const std::uint8_t b : in) {
        if (b == 0x02) {
            record.clear();
            inside = true;
        } else if (b == 0x03) {
            if (inside) f(record);
            inside = false;
        } else if (b < 0x20 || b > 0x7E) {
            inside = false;
        } else if (inside) {
            record += static_cast<char>(b);
        }
    }
}

/// Calls `f(payload, length)` for each record, memchr to memchr.
template <class F>
void each_record(bytes_in in, F&& f) {
    const std::uint8_t *p = in.data(), *const end = p + in.size();
    while (p != end) {
        const auto* stx = static_cast<const std::uint8_t*>(std::memchr(p, 0x02, static_cast<std::size_t>(end - p)));
        if (stx == nullptr) return;
        const auto* etx = static_cast<const std::uint8_t*>(std::memchr(stx, 0x03, static_cast<std::size_t>(end - stx)));
        if (etx == nullptr) return;
        p = stx + 1;
        bool good = true;
        for (const std::uint8_t* c = p; c != etx; ++c) good &= *c >= 0x20 && *c <= 0x7E;
        if (good) f(reinterpret_cast<const char*>(p), static_cast<std::size_t>(etx - p));
        p = good ? etx + 1 : p;
    }
}

template <bool Validate, class M>
void count(tally& t, const M& m) {
    if constexpr (Validate) t.errors += by_hand::valid(m) ? 0 : 1;
    t.sum += by_hand::word(m) + static_cast<std::uint64_t>(M::key);
    ++t.messages;
}

}  // namespace

tally framing_strings(bytes_in in) {
    tally t;
    each_string(in, [&](const std::string& record) {
        const auto type = std::stoul(record.substr(0, 3));
        if (!by_hand::each_type(type, [&]<class M>() { return record.size() == payload_of<M>; })) { ++t.errors; return; }
        ++t.messages;
        t.sum += record.size() + 2;
    });
    return t;
}
tally framing_pointers(bytes_in in) {
    tally t;
    each_record(in, [&](const char* p, std::size_t n) {
        const auto type = static_cast<std::uint64_t>(pointer_reader(p).number(3));
        if (!by_hand::each_type(type, [&]<class M>() { return n == payload_of<M>; })) { ++t.errors; return; }
        ++t.messages;
        t.sum += n + 2;
    });
    return t;
}

template <bool Validate>
tally typed_strings(bytes_in in) {
    tally t;
    each_string(in, [&](const std::string& record) {
        string_reader r(record);
        const auto type = static_cast<std::uint64_t>(r.number(3));
        const bool known = by_hand::each_type(type, [&]<class M>() {
            if (record.size() != payload_of<M>) return false;
            M m;
            by_hand::read(r, m);
            count<Validate>(t, m);
            return true;
        });
        t.errors += known ? 0 : 1;
    });
    return t;
}
template <bool Validate>
tally typed_pointers(bytes_in in) {
    tally t;
    each_record(in, [&](const char* p, std::size_t n) {
        pointer_reader r(p);
        const auto type = static_cast<std::uint64_t>(r.number(3));
        const bool known = by_hand::each_type(type, [&]<class M>() {
            if (n != payload_of<M>) return false;
            M m;
            by_hand::read(r, m);
            if (!r.good()) return false;
            count<Validate>(t, m);
            return true;
        });
        t.errors += known ? 0 : 1;
    });
    return t;
}

template tally typed_strings<false>(bytes_in);
template tally typed_strings<true>(bytes_in);
template tally typed_pointers<false>(bytes_in);
template tally typed_pointers<true>(bytes_in);

}  // namespace trama::bench::gateway_code
