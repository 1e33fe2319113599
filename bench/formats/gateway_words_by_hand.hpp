#pragma once
// The gateway's records by hand: whether the document allows them, and what the bench sums up of them.
#include "gateway_by_hand.hpp"

namespace trama::bench::by_hand {

/// What the document allows, as the same comparisons by hand.
inline bool valid_order_type(order_type t) {
    const auto v = static_cast<unsigned>(t);
    return v <= 3 || v == 10 || v == 15;
}
inline bool valid(const transit_order& o) {
    return static_cast<unsigned>(o.use) <= 3 && valid_order_type(o.type) && o.level <= 15 && static_cast<unsigned>(o.phase) <= 3;
}
inline bool valid(const cart_state& m) {
    return static_cast<unsigned>(m.cart_phase) <= 9 && m.rel_position <= 100 && m.cross_confirmation_needed <= 1 && valid(m.orders[0]) && valid(m.orders[1]);
}
inline bool valid(const circuit_state& m) { return static_cast<unsigned>(m.target_mode) <= 7 && static_cast<unsigned>(m.mode) <= 7; }
template <class Reply>
    requires requires(Reply m) { m.src_msg_id; }
bool valid(const Reply& m) {
    switch (static_cast<unsigned>(m.src_type)) {
        case 1: case 2: case 3: case 10: case 15: case 20: case 21: case 22: case 23: case 30: case 50: return true;
        default: return false;
    }
}
bool valid(const station_order auto& m) { return m.level <= 15; }
bool valid(const small_order auto&) { return true; }

/// Calls `f(word)` for the words that the bench sums over all fields; see `each_word`.
template <bool Ordered, std::size_t N>
void words_of(const text<N>& t, auto&& f) {
    if constexpr (Ordered) {
        for (const char c : t.columns) f(static_cast<std::uint8_t>(c));
    } else {
        std::uint64_t first;
        std::uint16_t last;
        std::memcpy(&first, t.columns.data(), 8);
        std::memcpy(&last, t.columns.data() + N - 2, 2);
        f(first + last);
    }
}
template <bool Ordered>
void words_of(const transit_order& o, auto&& f) {
    f(static_cast<std::uint64_t>(o.use)); f(static_cast<std::uint64_t>(o.type)); f(o.node); f(o.station_id); f(o.station_type); f(o.level);
    words_of<Ordered>(o.options, f);
    words_of<Ordered>(o.transit_id, f);
    words_of<Ordered>(o.cargo_id, f);
    f(static_cast<std::uint64_t>(o.phase));
    words_of<Ordered>(o.inputs, f);
    words_of<Ordered>(o.outputs, f);
    words_of<Ordered>(o.last_command, f);
}
template <bool Ordered>
void words_of(const cart_state& m, auto&& f) {
    f(m.msg_id); f(m.cart_id); f(static_cast<std::uint64_t>(m.cart_status)); f(static_cast<std::uint64_t>(m.cart_phase)); f(m.ini_node); f(m.rel_position);
    f(m.end_node); f(m.next_node); f(static_cast<std::uint64_t>(std::int64_t{m.speed_mms})); f(m.cross_confirmation_needed);
    for (const auto& o : m.orders) words_of<Ordered>(o, f);
}
template <bool Ordered>
void words_of(const circuit_state& m, auto&& f) {
    f(m.msg_id); f(m.circuit_voltage); f(m.circuit_current); f(m.working_carts); f(static_cast<std::uint64_t>(m.check));
    f(static_cast<std::uint64_t>(m.target_mode)); f(static_cast<std::uint64_t>(m.mode));
}
template <bool Ordered, class Reply>
    requires requires(Reply m) { m.src_msg_id; }
void words_of(const Reply& m, auto&& f) {
    f(m.msg_id); f(m.cart_id); f(static_cast<std::uint64_t>(m.src_type)); f(m.src_msg_id);
    if constexpr (requires { m.transit_id; }) words_of<Ordered>(m.transit_id, f);
    if constexpr (requires { m.error_message; }) words_of<Ordered>(m.error_message, f);
}
template <bool Ordered, station_order M>
void words_of(const M& m, auto&& f) {
    f(m.msg_id); f(m.cart_id); f(m.station_id); f(m.station_type); f(m.level);
    words_of<Ordered>(m.options, f);
    words_of<Ordered>(m.initial_inputs, f);
    words_of<Ordered>(m.cargo_id, f);
}
template <bool Ordered, small_order M>
void words_of(const M& m, auto&& f) {
    f(m.msg_id);
    if constexpr (requires { m.cart_id; }) f(m.cart_id);
    if constexpr (requires { m.parking_node; }) f(m.parking_node);
    if constexpr (requires { m.node; }) f(m.node);
    if constexpr (requires { m.transit_id; }) words_of<Ordered>(m.transit_id, f);
    if constexpr (requires { m.command; }) words_of<Ordered>(m.command, f);
    if constexpr (requires { m.inputs; }) words_of<Ordered>(m.inputs, f);
    if constexpr (requires { m.cargo_id; }) words_of<Ordered>(m.cargo_id, f);
}

}  // namespace trama::bench::by_hand
