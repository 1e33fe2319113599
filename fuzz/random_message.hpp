#pragma once
// Messages drawn from the schema: legal ones, and ones with a value just outside what is allowed.
#include <array>
#include <optional>

#include "support.hpp"
#include "trama/core/validate.hpp"

namespace trama::fuzz {

/// Where the views in a random message point to; lives as long as the message is used.
struct arena {
    std::array<std::uint8_t, 512> bytes{};
    std::size_t used = 0;

    std::span<std::uint8_t> take(std::size_t n) {
        const auto part = std::span(bytes).subspan(used, n);
        used += n;
        return part;
    }
};

/// A number that `r` allows and lies in `low..high`, corners more often than the rest.
inline std::int64_t allowed_number(const rule& r, std::int64_t low, std::int64_t high, dice& d) {
    if (r.set != 0) {
        for (std::size_t bit = d.below(64);; bit = (bit + 1) % 64)
            if ((r.set >> bit & 1) != 0) return static_cast<std::int64_t>(bit);
    }
    if (r.also != r.low && d.one_in(4) && r.allows(r.also)) return r.also;
    low = std::max(low, r.low);
    high = std::min(high, r.high);
    if (low >= high) return low;
    switch (d.below(4)) {
        case 0: return low;
        case 1: return high;
        default: return low + static_cast<std::int64_t>(std::uint64_t{d.next()} % (static_cast<std::uint64_t>(high - low) + 1));
    }
}

/// A number that the wire can carry, just past one end of what `r` allows, or anything.
inline std::int64_t strange_number(const rule& r, std::int64_t low, std::int64_t high, dice& d) {
    const std::int64_t near[] = {r.low > low ? r.low - 1 : low, r.high < high ? r.high + 1 : high, high, low + static_cast<std::int64_t>(d.next() % 70000U)};
    return std::min(std::max(near[d.below(4)], low), high);
}

/// A value of type `V` that wire type `W` cannot carry; nothing where the wire carries all there is.
template <class W, class V>
std::optional<V> unfit_number() {
    if constexpr (std::is_enum_v<V>) {
        const auto n = unfit_number<W, std::underlying_type_t<V>>();
        return n ? std::optional(static_cast<V>(*n)) : std::nullopt;
    } else {
        if (std::in_range<V>(W::high + 1)) return static_cast<V>(W::high + 1);
        if (std::in_range<V>(W::low - 1)) return static_cast<V>(W::low - 1);
        return std::nullopt;
    }
}

/// Text that no frame may carry: too long, or with a character that is not printable, delimiters among them.
template <std::size_t Columns>
text<Columns> unfit_text(const text<Columns>& from, dice& d) {
    if (d.one_in(4)) {
        std::array<char, Columns + 1> longer{};
        longer.fill('x');
        return text<Columns>(std::string_view(longer.data(), longer.size()));
    }
    constexpr std::uint8_t foreign[] = {0x02, 0x03, 0x00, 0x1F, 0x7F, 0x80, 0xFF, '\n'};
    text<Columns> t = from;
    t.columns[d.below(Columns)] = static_cast<char>(foreign[d.below(std::size(foreign))]);
    return t;
}

inline std::uint8_t random_character(dice& d) { return static_cast<std::uint8_t>(' ' + d.below(95)); }

/// Gives one value something new, allowed or `strange`: what the document does not allow, and now and then what not even the wire can carry.
template <class W, class V>
void randomize_value(V& v, const rule& own, bool strange, dice& d, arena& memory) {
    if constexpr (requires { W::low; }) {
        if (const auto unfit = unfit_number<W, V>(); strange && unfit && d.one_in(4)) {
            v = *unfit;
            return;
        }
    }
    if constexpr (requires { v.columns; }) {
        const std::size_t length = d.below(v.columns.size() + 1);
        for (std::size_t i = 0; i != v.columns.size(); ++i) v.columns[i] = static_cast<char>(i < length ? random_character(d) : ' ');
        if (strange) v = unfit_text(v, d);
    } else if constexpr (requires { v.bytes(); }) {
        const std::size_t room = memory.bytes.size() - memory.used;
        std::size_t length = W::min + (d.one_in(8) ? d.below(W::max_size - W::min + 1) : d.below(std::min<std::size_t>(12, W::max_size - W::min + 1)));
        if (strange && d.one_in(8)) length = W::min != 0 && d.one_in(2) ? W::min - 1 : W::max_size + 1;
        length = std::min(room, length);
        const auto bytes = memory.take(length);
        for (auto& b : bytes) b = W::printed == wire::print::text && !strange ? random_character(d) : static_cast<std::uint8_t>(d.next());
        v = byte_view(bytes);
    } else if constexpr (flag_set<V>) {
        v = static_cast<V>(static_cast<std::uint64_t>(d.next()) % static_cast<std::uint64_t>(strange ? W::high + 1 : 4096));
    } else if constexpr (enumerated<V>) {
        constexpr auto table = names(V{});
        if (strange) v = static_cast<V>(strange_number({0, table.size() - 1, 0, 0, {}, {}}, W::low, W::high, d));
        else if (!own.any()) v = static_cast<V>(allowed_number(own, W::low, W::high, d));
        else v = table[d.below(table.size())].value;
    } else {
        v = static_cast<V>(strange ? strange_number(own, W::low, W::high, d) : allowed_number(own, W::low, W::high, d));
    }
}

/// Lists get the length that the message announces; fields that do not exist are emptied.
template <has_layout M>
void mend_shape(M& m, dice& d) {
    if constexpr (!M::layout.fixed)
        each_index<M>([&]<std::size_t I>() {
            constexpr auto& one = field_of<M, I>;
            using wire_type = typename std::remove_cvref_t<decltype(one)>::wire_type;
            auto& v = m.*one.member;
            if (!one.exists(m)) v = {};
            else if constexpr (requires { typename wire_type::element; }) {
                auto longer = v;
                longer = {};
                for (std::size_t i = 0; i != announced_count(m); ++i)
                    (void)longer.push_back(i < v.size() ? v[i] : static_cast<std::remove_cvref_t<decltype(v[0])>>(d.below(1024)));
                v = longer;
            }
        });
}

/// A list gets one value more or less than the message announces, or a field that does not exist something to hold; where the message has such.
template <has_layout M>
void break_shape(M& m, dice& d) {
    if constexpr (!M::layout.fixed)
        each_index<M>([&]<std::size_t I>() {
            constexpr auto& one = field_of<M, I>;
            auto& v = m.*one.member;
            if (d.one_in(2)) return;
            if constexpr (requires { v.push_back(v[0]); }) {
                auto shorter = v;
                shorter = {};
                for (std::size_t i = 0; i + 1 < v.size(); ++i) (void)shorter.push_back(v[i]);
                if (v.size() == 0 || d.one_in(2)) (void)v.push_back(1);
                else v = shorter;
            } else if constexpr (std::is_integral_v<std::remove_cvref_t<decltype(v)>>) {
                if (!one.exists(m)) v = 1;
            }
        });
}
/// The message as it comes back from the wire: fields that do not exist are empty.
template <has_layout M>
M without_absent(M m) {
    each_index<M>([&]<std::size_t I>() {
        constexpr auto& one = field_of<M, I>;
        if (!one.exists(m)) m.*one.member = {};
    });
    return m;
}

/// Where one field decides what another may hold, rules change with the values: gives way until nothing is violated.
template <has_layout M>
void mend_values(M& m, dice& d, arena& memory) {
    for (int round = 0; round != 4 && !is_valid(m); ++round) {
        each_leaf(m, [&]<class W>(field_ref at, auto& v, const rule& own) {
            const rule& r = rule_in_context(m, at, own);
            if (broken_rule<W>(v, r) == nullptr) return;
            if constexpr (requires { W::low; }) v = static_cast<std::remove_cvref_t<decltype(v)>>(allowed_number(enumerated<std::remove_cvref_t<decltype(v)>> && r.any() ? rule{0, 0, 0, 0, {}, {}} : r, W::low, W::high, d));
            else randomize_value<W>(v, r, false, d, memory);
        });
        mend_shape(m, d);
    }
}

/// A message without a violation.
template <has_layout M>
M random_message(dice& d, arena& memory) {
    M m{};
    for (int turn = 0; turn != 2; ++turn) {  // again for the fields that the first turn brought into being
        memory.used = 0;
        each_leaf(m, [&]<class W>(field_ref, auto& v, const rule& own) { randomize_value<W>(v, own, false, d, memory); });
        mend_shape(m, d);
    }
    mend_values(m, d, memory);
    return m;
}

/// Changes one value of `m`, half of the time to one that the document does not allow; the rest stays as it is.
template <has_layout M>
void change_one_value(M& m, dice& d, arena& memory) {
    std::size_t places = 0;
    each_leaf(m, [&]<class W>(field_ref, auto&, const rule&) { ++places; });
    std::size_t turn = d.below(places);
    const bool strange = d.one_in(2);
    each_leaf(m, [&]<class W>(field_ref at, auto& v, const rule& own) {
        if (turn-- != 0) return;
        const rule r = rule_in_context(m, at, own);
        randomize_value<W>(v, r, strange, d, memory);
    });
    mend_shape(m, d);
}

}  // namespace trama::fuzz
