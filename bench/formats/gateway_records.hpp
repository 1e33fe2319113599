#pragma once
// Records as clients in the field write them.
#include "gateway.hpp"

namespace trama::bench {

/// Moves numbers to the left of their columns, each with even chance: clients in the field mix both.
template <has_layout M>
void mix_sides(std::uint8_t* p, dice& d);
template <class W>
void mix_side(std::uint8_t* p, dice& d) {
    if constexpr (requires { typename W::element; }) {
        for (std::size_t i = 0; i != W::count; ++i) mix_side<typename W::element>(p + i * W::element::size, d);
    } else if constexpr (requires { W::value::layout; }) {
        mix_sides<typename W::value>(p, d);
    } else if constexpr (requires { W::decimal; }) {
        if (d.one_in(2)) gateway::detail::justify_value_left<W>(p);
    }
}
template <has_layout M>
void mix_sides(std::uint8_t* p, dice& d) {
    each_index<M>([&]<std::size_t I>() { mix_side<typename decltype(field_of<M, I>)::wire_type>(p + M::layout.offsets[I], d); });
}

/// Appends `m`, its numbers on mixed sides.
template <class M>
void append_record(stream<gateway::format>& s, const M& m, dice& d) {
    const std::size_t at = s.data.size();
    append(s, {}, m);
    mix_sides<M>(s.data.data() + at + 1 + gateway::type_size, d);
}
/// The same with random values.
template <class M>
void append_random_record(stream<gateway::format>& s, dice& d) {
    arena memory;
    append_record(s, random_message<M>(d, memory), d);
}

}  // namespace trama::bench
