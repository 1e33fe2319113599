#pragma once
// Streams that are the same for every format: random mixes, damage, garbage.
#include "random_message.hpp"
#include "tasks.hpp"

namespace trama::bench {

/// Appends `m` to the stream as the format encodes it, and notes what it is.
template <class F, class M>
void append(stream<F>& s, const typename F::envelope& e, const M& m) {
    std::array<typename F::unit, F::max_units> out;
    const auto size = F::encode(e, m, out);
    if (!size) return;
    s.data.insert(s.data.end(), out.begin(), out.begin() + static_cast<std::ptrdiff_t>(*size));
    ++s.made_of.messages;
    s.made_of.lengths.add(*size);
    each_message_word<F>(e, m, [&](std::uint64_t word) { s.made_of.fields.add(word); });
    each_chosen_word<F>(m, [&](std::uint64_t word) { s.made_of.chosen.add(word); });
}

/// Appends a random message of the kind at `index`.
template <class F>
void append_random(stream<F>& s, std::size_t index, dice& d) {
    F::messages::at(index, [&]<class M>() {
        arena memory;
        const M m = random_message<M>(d, memory);
        append(s, traits<F>::template addresses<M>(d), m);
    });
}

/// A stream of about `bytes`: `add(stream, dice)` appends some messages each time.
template <class F>
stream<F> make_stream(std::size_t bytes, std::uint64_t seed, auto&& add) {
    const std::size_t size = sizeof(typename F::unit);
    stream<F> s;
    s.data.reserve(bytes / size + 64 * F::max_units);
    dice d(seed);
    while ((s.data.size() + F::max_units) * size < bytes) add(s, d);
    return s;
}

/// Gives one number of `m` any value that its wire type carries.
template <has_layout M>
void spoil(M& m, dice& d) {
    std::size_t leaves = 0;
    each_leaf(m, [&]<class W>(field_ref, auto&, const rule&) { ++leaves; });
    std::size_t left = d.below(leaves);
    each_leaf(m, [&]<class W>(field_ref, auto& v, const rule&) {
        using value = std::remove_cvref_t<decltype(v)>;
        if (left-- != 0) return;
        if constexpr (std::is_enum_v<value> || std::integral<value>)
            v = static_cast<value>(W::low + static_cast<std::int64_t>(d.below(static_cast<std::uint64_t>(W::high - W::low) + 1)));
    });
}

/// Messages of all kinds, every other one with a value that the document may not allow. What it is made of is not noted.
template <class F>
stream<F> out_of_range(std::size_t units) {
    stream<F> s;
    dice d(41);
    while (s.data.size() < units)
        F::messages::at(d.below(F::messages::count), [&]<class M>() {
            arena memory;
            M m = random_message<M>(d, memory);
            if (M::layout.count != 0 && d.one_in(2)) spoil(m, d);
            std::array<typename F::unit, F::max_units> out;
            const auto size = F::encode_unchecked(traits<F>::template addresses<M>(d), m, out);
            if (size) s.data.insert(s.data.end(), out.begin(), out.begin() + static_cast<std::ptrdiff_t>(*size));
        });
    return s;
}

/// Faults in one of `one_in` places of `spacing` units: a unit changed, lost, doubled or put in.
template <class F>
stream<F> damaged(const stream<F>& good, std::uint64_t one_in, std::size_t spacing, std::uint64_t seed) {
    stream<F> s;
    s.data.reserve(good.data.size() + good.data.size() / 16);
    s.made_of.messages = good.made_of.messages;
    dice d(seed);
    for (std::size_t at = 0; at < good.data.size(); at += spacing) {
        const std::size_t end = std::min(at + spacing, good.data.size());
        const std::size_t hit = d.one_in(one_in) ? at + d.below(end - at) : end;
        for (std::size_t i = at; i != end; ++i) {
            const auto kind = i == hit ? d.below(4) : 4;
            if (kind == 1) continue;
            s.data.push_back(good.data[i]);
            if (kind == 0) traits<F>::damage(s.data.back(), d);
            if (kind >= 2 && kind != 4) s.data.push_back(good.data[i]);
            if (kind == 3) traits<F>::damage(s.data.back(), d);
        }
    }
    return s;
}

}  // namespace trama::bench
