#pragma once

#include "trama/core/body.hpp"

namespace trama {

/// The values that wire type `W` can carry, as a rule.
template <class W>
inline constexpr rule wire_rule = between(W::low, W::high);
template <enumerated E>
inline constexpr rule names_rule = {0, 0, 0, 0, name_list<E>, {}};
inline constexpr rule printable_rule{0, 0, 0, 0, {}, "printable ASCII"};
inline constexpr rule fitting_rule{0, 0, 0, 0, {}, "a text that fits the field; 0 stands for one that does not"};
inline constexpr rule absent_rule{0, 0, 0, 0, {}, "nothing, the field does not exist in this message"};
inline constexpr rule count_rule{0, 0, 0, 0, {}, "as many values as the message announces"};

/// A leaf's value as violations report it: a number; of bytes their count, of a text its first bad character (0 if it is too long).
template <class V>
constexpr std::int64_t as_number(const V& v) noexcept {
    if constexpr (std::is_enum_v<V> || std::integral<V>) {
        return static_cast<std::int64_t>(v);
    } else if constexpr (requires { v.columns; }) {
        for (const char c : v.columns)
            if (c < 0x20 || c > 0x7E) return static_cast<unsigned char>(c);
        return 0;
    } else {
        return static_cast<std::int64_t>(v.size());
    }
}

/// True when the wire can carry `v`, whatever the document says about it.
template <class W, class V>
[[gnu::always_inline]] constexpr bool wire_carries(const V& v) noexcept {
    if constexpr (std::is_enum_v<V> || std::integral<V>) return W::carries(static_cast<std::int64_t>(v));
    else return W::carries(v);
}

/// The rule that `v` breaks, or null. `own` is the field's rule, or the one its context puts in that place.
template <class W, class V>
[[gnu::always_inline]] constexpr const rule* broken_rule(const V& v, const rule& own) noexcept {
    if constexpr (requires { v.columns; }) {
        return v.printable() ? nullptr : v.too_long() ? &fitting_rule : &printable_rule;
    } else if constexpr (enumerated<V>) {
        if (!own.any() && !own.allows(as_number(v))) return &own;
        if (own.any() && !is_listed(v)) return &names_rule<V>;
        return wire_carries<W>(v) ? nullptr : &wire_rule<W>;
    } else {
        if (!own.allows(as_number(v))) return &own;
        if constexpr (requires { W::low; }) return wire_carries<W>(v) ? nullptr : &wire_rule<W>;
        else return nullptr;
    }
}

/// Calls `f.operator()<W>(ref, value, rule)` for every leaf of one field's value. `rule` is the document's for it.
template <class W, class V>
[[gnu::always_inline]] constexpr void each_leaf_of(V& v, const rule& own, field_ref at, auto& f) {
    using value = std::remove_const_t<V>;
    if constexpr (requires { typename W::element; }) {
        for (std::size_t i = 0; i != v.size(); ++i) {
            at.index = static_cast<std::uint8_t>(i);
            each_leaf_of<typename W::element>(v[i], own, at, f);
        }
    } else if constexpr (has_layout<value>) {
        each_index_inline<value>([&]<std::size_t I>() __attribute__((always_inline)) {
            constexpr auto& one = field_of<value, I>;
            at.sub = static_cast<std::uint8_t>(I);
            f.template operator()<typename std::remove_cvref_t<decltype(one)>::wire_type>(at, v.*one.member, one.allowed);
        });
    } else {
        f.template operator()<W>(at, v, own);
    }
}

/// Calls `f.operator()<W>(ref, value, rule)` for every value of `m` that exists, nested ones included, in wire order.
/// Of a message that is not const, `f` may change the values.
template <class M>
    requires has_layout<std::remove_const_t<M>>
[[gnu::always_inline]] constexpr void each_leaf(M& m, auto&& f) {
    using message = std::remove_const_t<M>;
    each_index_inline<message>([&]<std::size_t I>() __attribute__((always_inline)) {
        constexpr auto& one = field_of<message, I>;
        if (!one.exists(m)) return;
        each_leaf_of<typename std::remove_cvref_t<decltype(one)>::wire_type>(m.*one.member, one.allowed, field_ref{static_cast<std::uint8_t>(I)}, f);
    });
}

/// The rule for one leaf: the message's `rule_for` decides where other fields change what is allowed.
template <class M>
[[gnu::always_inline]] constexpr const rule& rule_in_context([[maybe_unused]] const M& m, [[maybe_unused]] field_ref at, const rule& own) noexcept {
    if constexpr (requires { m.rule_for(at); }) {
        const rule* changed = m.rule_for(at);
        return changed != nullptr ? *changed : own;
    } else {
        return own;
    }
}

/// How many values a list of `m` must have, where the message says so.
template <has_layout M>
constexpr std::size_t announced_count([[maybe_unused]] const M& m) noexcept {
    if constexpr (requires { m.expected_count(); }) return m.expected_count();
    else return 0;
}

/// True when the fields that do not exist are empty and each list has the length that the message announces.
/// Reports what is not by `f(field, size, rule)`.
template <has_layout M>
constexpr void each_shape_fault(const M& m, auto&& f) {
    if constexpr (!M::layout.fixed)
        each_index<M>([&]<std::size_t I>() {
            constexpr auto& one = field_of<M, I>;
            using wire_type = typename std::remove_cvref_t<decltype(one)>::wire_type;
            const auto& v = m.*one.member;
            const field_ref at{static_cast<std::uint8_t>(I)};
            if (!one.exists(m)) {
                if (!(v == std::remove_cvref_t<decltype(v)>{})) f(at, as_number(v), absent_rule);
            } else if constexpr (requires { typename wire_type::element; }) {
                if (v.size() != announced_count(m)) f(at, as_number(v), count_rule);
            }
        });
}

/// Calls `f(const violation&)` for every value of `m` that the document or the wire does not allow: first lists of the wrong length and fields that
/// should not be there, then the values in field order.
template <has_layout M>
constexpr void for_each_violation(const M& m, auto&& f) {
    each_shape_fault(m, [&](field_ref at, std::int64_t value, const rule& r) { f(violation{at, value, &r}); });
    each_leaf(m, [&]<class W>(field_ref at, const auto& v, const rule& own) {
        if (const rule* broken = broken_rule<W>(v, rule_in_context(m, at, own))) f(violation{at, as_number(v), broken});
    });
}

/// True when there is no violation. Needs no list and no branch on each field.
template <has_layout M>
constexpr bool is_valid(const M& m) noexcept {
    bool good = true;
    each_shape_fault(m, [&](field_ref, std::int64_t, const rule&) { good = false; });
    each_leaf(m, [&]<class W>(field_ref at, const auto& v, const rule& own) __attribute__((always_inline)) {
        good &= broken_rule<W>(v, rule_in_context(m, at, own)) == nullptr;
    });
    return good;
}

/// True when the wire can carry every value of `m`; what the unchecked encoders ask for.
template <has_layout M>
constexpr bool fits_wire(const M& m) noexcept {
    bool good = true;
    each_shape_fault(m, [&](field_ref, std::int64_t, const rule& r) { good = good && &r == &absent_rule; });
    each_leaf(m, [&]<class W>(field_ref, const auto& v, const rule&) { good &= wire_carries<W>(v); });
    return good;
}

/// Why an encoder refuses `m`: `out_of_range` with the field of the first violation.
template <has_layout M>
constexpr error refusal(const M& m) noexcept {
    error e{};
    for_each_violation(m, [&](const violation& v) { if (!e) e = {errc::out_of_range, v.field}; });
    return e;
}
/// Why an unchecked encoder refuses `m`: `out_of_range` with the first field that the wire cannot carry.
template <has_layout M>
constexpr error unfit(const M& m) noexcept {
    error e{};
    const auto note = [&](field_ref at) { if (!e) e = {errc::out_of_range, at}; };
    each_shape_fault(m, [&](field_ref at, std::int64_t, const rule& r) { if (&r != &absent_rule) note(at); });
    each_leaf(m, [&]<class W>(field_ref at, const auto& v, const rule&) { if (!wire_carries<W>(v)) note(at); });
    return e;
}

/// The most violations that a message can have.
template <has_layout M>
inline constexpr std::size_t leaf_count = [] {
    std::size_t n = 0;
    each_index<M>([&]<std::size_t I>() {
        using one = std::remove_cvref_t<decltype(field_of<M, I>)>;
        using wire_type = typename one::wire_type;
        std::size_t each = 1;
        if constexpr (requires { typename wire_type::element; }) {
            each = wire_type::max_count;
            if constexpr (requires { wire_type::element::value::layout; }) each *= wire_type::element::value::layout.count;
        } else if constexpr (has_layout<typename one::value>) {
            each = one::value::layout.count;
        }
        n += each + (one::optional || wire::variable<wire_type> ? 1 : 0);
    });
    return n;
}();

/// Every violation of `m`. Decoding does not do this; encoders do.
template <has_layout M>
constexpr auto validate(const M& m) noexcept {
    violation_list<leaf_count<M>> all;
    for_each_violation(m, [&](const violation& v) { all.push_back(v); });
    return all;
}

}  // namespace trama
