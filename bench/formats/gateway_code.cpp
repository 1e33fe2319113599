// The hand-written code that gateway is compared with.
#include "gateway.hpp"
#include "gateway_readers_by_hand.hpp"
#include "gateway_words_by_hand.hpp"
#include "limits.hpp"

namespace trama::bench {

namespace {

using bytes_in = unit_span<gateway::format>;

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

/// What a record of kind `M` with `n` characters adds to the account of `T`; false if it is none.
template <task T, bool Ordered, class M>
bool add(account<Ordered>& a, auto& reader, std::size_t n) {
    if (n != payload_of<M>) return false;
    if constexpr (T == task::framing) return a.packet(n + 2), true;
    M m;
    if constexpr (T == task::selected) {
        // The columns of the two fields; there are no others before them in a cart_state.
        ++a.messages;
        if constexpr (std::is_same_v<M, gateway::cart_state>) {
            reader.skip(5);
            const std::int64_t cart = reader.number(5);
            reader.skip(4 + 1 + 5 + 3 + 5);
            const std::int64_t next = reader.number(5);
            a.words([&](auto&& f) { f(static_cast<std::uint64_t>(cart)); f(static_cast<std::uint64_t>(next)); });
        }
    } else {
        by_hand::read(reader, m);
        if (!reader.good()) return false;
        ++a.messages;
        a.words([&](auto&& f) {
            f(static_cast<std::uint64_t>(M::key));
            by_hand::words_of<Ordered>(m, f);
        });
        if constexpr (T == task::validated) a.judge(by_hand::valid(m));
    }
    return true;
}
/// A record of any kind.
template <task T, bool Ordered>
void add_any(account<Ordered>& a, auto& reader, std::size_t n) {
    const auto type = static_cast<std::uint64_t>(reader.number(3));
    if (!by_hand::each_type(type, [&]<class M>() { return add<T, Ordered, M>(a, reader, n); })) ++a.errors;
}

struct strings {
    template <task T, bool Ordered>
    static tally run(bytes_in in) {
        account<Ordered> a;
        each_string(in, [&](const std::string& record) {
            by_hand::string_reader r(record);
            add_any<T>(a, r, record.size());
        });
        return a.result();
    }
};
struct pointers {
    template <task T, bool Ordered>
    static tally run(bytes_in in) {
        account<Ordered> a;
        each_record(in, [&](const char* p, std::size_t n) {
            by_hand::pointer_reader r(p);
            add_any<T>(a, r, n);
        });
        return a.result();
    }
};

}  // namespace

void traits<gateway::format>::add_limits(race& r, const shared_stream<gateway::format>& s, task, bool clean) {
    r.contenders.push_back({"validity pass", "whole", role::limit, s->data.size(), s->made_of.messages, [s] { return check_printable(s->data); }});
    if (!clean) return;
    r.answers.push_back({"all bytes allowed", "validity pass", "whole", [s] { return check_printable(s->data); }});
    r.answers.push_back({"all bytes allowed", "generator", {}, [] { return tally{0, 1, 0}; }});
}

std::span<const by_hand_code<gateway::format>> traits<gateway::format>::by_hand() {
    static constexpr by_hand_code<gateway::format> all[] = {code_of<gateway::format, strings>("substr and stoull"), code_of<gateway::format, pointers>("trim and from_chars")};
    return all;
}

}  // namespace trama::bench
