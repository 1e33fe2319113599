#pragma once
// Messages drawn from the schema: valid ones, and ones with anything that the wire can carry.

#include <algorithm>
#include <deque>
#include <string_view>

#include "laws/rng.hpp"
#include "trama/core/validate.hpp"

namespace trama::test {

/// The bytes that the views of random messages point into.
using memory = std::deque<octets>;

/// `valid`: no violation. `wild`: each value now and then any that the wire can carry.
enum class manners { valid, wild };

/// A number of `low..high` that `r` allows, the ends more often than the rest.
inline std::int64_t draw_number(rng& random, const rule& r, std::int64_t low, std::int64_t high) {
    if (r.set != 0) {
        std::int64_t v = 0;
        do v = static_cast<std::int64_t>(random.below(64)); while (!r.allows(v));
        return v;
    }
    if (r.low <= r.high) {  // else nothing is allowed, and anything will do
        if (r.also != r.low && random.one_in(4)) return r.also;
        low = std::max(low, r.low);
        high = std::min(high, r.high);
    }
    switch (random.below(6)) {
        case 0: return low;
        case 1: return high;
        case 2: if (low <= 0 && high >= 0) return 0; [[fallthrough]];
        default: return low + static_cast<std::int64_t>(random.next() % (static_cast<std::uint64_t>(high - low) + 1));
    }
}

class message_maker {
public:
    message_maker(rng& random, manners how, memory& views) : random_(random), how_(how), views_(views) {}

    /// In wire order, so that the fields which decide what others may be come first.
    template <has_layout M>
    M make() {
        M m{};
        each_index<M>([&]<std::size_t I>() {
            constexpr auto& one = field_of<M, I>;
            using wire_type = typename std::remove_cvref_t<decltype(one)>::wire_type;
            if (one.exists(m)) draw<wire_type>(m, m.*one.member, one.allowed, {static_cast<std::uint8_t>(I)});
        });
        return m;
    }

private:
    template <class W, class M, class V>
    void draw(const M& m, V& v, const rule& own, field_ref at) {
        if constexpr (requires { typename W::element; }) {
            if constexpr (wire::variable<W>)
                while (v.size() < m.expected_count()) (void)v.push_back(0);
            for (std::size_t i = 0; i != v.size(); ++i) {
                at.index = static_cast<std::uint8_t>(i);
                draw<typename W::element>(m, v[i], own, at);
            }
        } else if constexpr (has_layout<V>) {
            each_index<V>([&]<std::size_t I>() {
                constexpr auto& one = field_of<V, I>;
                at.sub = static_cast<std::uint8_t>(I);
                draw<typename std::remove_cvref_t<decltype(one)>::wire_type>(m, v.*one.member, one.allowed, at);
            });
        } else {
            leaf<W>(v, rule_in_context(m, at, own));
        }
    }
    template <class W, class V>
    void leaf(V& v, const rule& r) {
        const bool wild = how_ == manners::wild && random_.one_in(4);
        if constexpr (requires { v.columns; }) {
            const std::size_t used = random_.below(v.columns.size() + 1);
            for (std::size_t i = 0; i != used; ++i) v.columns[i] = static_cast<char>(random_.within(0x20, 0x7E));
        } else if constexpr (requires { v.bytes(); }) {
            v = view<W>(wild);
        } else if constexpr (enumerated<V> && !flag_set<V>) {
            constexpr auto table = names(V{});
            if (wild) v = static_cast<V>(draw_number(random_, {}, W::low, W::high));
            else if (!r.any()) v = static_cast<V>(draw_number(random_, r, W::low, W::high));
            else v = table[random_.below(table.size())].value;
        } else {
            v = static_cast<V>(draw_number(random_, wild ? rule{} : r, W::low, W::high));
        }
    }
    template <class W>
    byte_view view(bool wild) {
        const std::size_t size = random_.one_in(6) ? random_.within(W::min, W::max_size) : W::min + random_.below(12);
        octets& bytes = views_.emplace_back(random_.bytes(size));
        constexpr std::string_view text = "Placa de motores, v1.2\r\n";
        if (W::printed == wire::print::text && !wild)
            for (std::size_t i = 0; i != size; ++i) bytes[i] = static_cast<std::uint8_t>(text[i % text.size()]);
        return byte_view(bytes);
    }

    rng& random_;
    manners how_;
    memory& views_;
};

/// A random message; its views live as long as `views`.
template <has_layout M>
M random_message(rng& random, manners how, memory& views) {
    return message_maker(random, how, views).template make<M>();
}

}  // namespace trama::test
