#pragma once
// Valid messages drawn from the schema.
#include <array>

#include "dice.hpp"
#include "trama/core/validate.hpp"

namespace trama::bench {

/// Where the views in a random message point to; lives as long as the message is used.
using arena = std::array<std::uint8_t, 512>;

/// A number that `r` and the wire allow; small ones as often as large ones, so that every width occurs.
inline std::int64_t allowed_number(const rule& r, std::int64_t low, std::int64_t high, dice& d) {
    if (r.set != 0)
        for (;;)
            if (const std::uint64_t v = d.below(64); (r.set >> v & 1) != 0) return static_cast<std::int64_t>(v);
    low = std::max(low, r.low);
    high = std::min(high, r.high);
    if (low >= high) return low;
    const std::uint64_t span = static_cast<std::uint64_t>(high - low) + 1;
    std::uint64_t v = d.next() % span;
    if (low == 0)
        for (std::uint64_t cut = d.below(4); cut != 0; --cut) v /= 6;
    return low + static_cast<std::int64_t>(v);
}

template <class W, class V>
void randomize_value(V& v, const rule& own, dice& d, arena& memory) {
    if constexpr (requires { v.columns; }) {
        const std::size_t length = d.below(v.columns.size() + 1);
        for (std::size_t i = 0; i != v.columns.size(); ++i) v.columns[i] = i < length ? static_cast<char>('!' + d.below(90)) : ' ';
    } else if constexpr (requires { v.bytes(); }) {
        const std::size_t length = W::min + d.below(40);
        for (std::size_t i = 0; i != length; ++i) memory[i] = static_cast<std::uint8_t>(' ' + d.below(95));
        if (W::printed == wire::print::hex) memory[0] = static_cast<std::uint8_t>(length - 1);
        v = byte_view(std::span<const std::uint8_t>(memory).first(length));
    } else if constexpr (enumerated<V> && !flag_set<V>) {
        constexpr auto table = names(V{});
        v = own.any() ? table[d.below(table.size())].value : static_cast<V>(allowed_number(own, W::low, W::high, d));
    } else if constexpr (flag_set<V>) {
        v = static_cast<V>(d.below(4096));
    } else {
        v = static_cast<V>(allowed_number(own, W::low, W::high, d));
    }
}

/// Gives lists the length that the message announces.
template <has_layout M>
void mend_shape(M& m, dice& d) {
    if constexpr (requires { m.expected_count(); m.readings; }) {
        m.readings = {};
        for (std::size_t i = 0; i != m.expected_count(); ++i) (void)m.readings.push_back(static_cast<std::uint16_t>(d.below(1024)));
    }
    if constexpr (requires { m.rejected; }) {
        if (m.rejected.empty()) m.code = 1;
        if (!m.is_bad_crc()) { m.rejected = {}; m.expected_crc = 0; }
        else m.expected_crc = xor_of(m.rejected.bytes().first(m.rejected.size() - 1));
    }
}

/// A message without a violation.
template <has_layout M>
M random_message(dice& d, arena& memory) {
    M m{};
    each_leaf(m, [&]<class W>(field_ref, auto& v, const rule& own) { randomize_value<W>(v, own, d, memory); });
    if constexpr (requires { m.rejected; }) m.code = static_cast<std::uint8_t>(d.below(2));
    mend_shape(m, d);
    for (int turn = 0; turn != 3 && !is_valid(m); ++turn)  // rules that depend on other fields
        each_leaf(m, [&]<class W>(field_ref at, auto& v, const rule& own) {
            const rule& r = rule_in_context(m, at, own);
            if constexpr (requires { W::low; })
                if (broken_rule<W>(v, r) != nullptr) v = static_cast<std::remove_cvref_t<decltype(v)>>(allowed_number(r, W::low, W::high, d));
        });
    return m;
}

}  // namespace trama::bench
