#pragma once

#include <string_view>

#include "trama/gateway/cart_table.hpp"
#include "trama/gateway/messages.hpp"

/// What each order does to its cart, and why it cannot. The words are what a nack says.
namespace trama::gateway::reason {

inline constexpr std::string_view unknown_cart = "unknown cart";
inline constexpr std::string_view no_place = "cart has no free order slot";
inline constexpr std::string_view not_ready = "cart takes no orders";
inline constexpr std::string_view no_transits = "the circuit takes no new transits";
inline constexpr std::string_view no_station = "that transit has no station";
inline constexpr std::string_view unknown_transit = "no such transit under way or waiting";
inline constexpr std::string_view not_waiting = "cart needs no grant for that node";
inline constexpr std::string_view bad_number = "a field is no number";
inline constexpr std::string_view out_of_range = "a value is out of range";

}  // namespace trama::gateway::reason

namespace trama::gateway::detail {

/// What a nack says: the first 80 of `words`, `?` for each that no record can carry, since a refusal must be told.
constexpr text<80> error_message(std::string_view words) noexcept {
    text<80> m{};
    for (std::size_t i = 0; i != words.size() && i != m.columns.size(); ++i) m.columns[i] = words[i] >= 0x20 && words[i] <= 0x7E ? words[i] : '?';
    return m;
}

inline constexpr std::uint32_t most_transits = 1'000'000'000;

/// Transits are named T and a number of nine digits.
constexpr text<10> transit_name(std::uint32_t number) noexcept {
    text<10> name("T000000000");
    for (std::size_t i = 9; i != 0; --i, number /= 10) name.columns[i] = static_cast<char>('0' + number % 10);
    return name;
}

/// The slot content that an order asks for.
template <class M>
constexpr transit_order transit_of(const M& m, const text<10>& transit_id) noexcept {
    transit_order o{};
    o.type = M::key;
    o.transit_id = transit_id;
    if constexpr (M::key == order_type::go_parking) {
        o.node = m.parking_node;
    } else if constexpr (M::key == order_type::go_node) {
        o.node = m.node;
    } else {
        o.station_id = m.station_id;
        o.station_type = m.station_type;
        o.level = m.level;
        o.options = m.options;
        o.inputs = m.initial_inputs;
        o.cargo_id = m.cargo_id;
    }
    return o;
}

/// Sets a value of a transit at a station: commands, inputs and cargo are for load, transit and unload. [T11]
template <text<10> transit_order::*Member>
constexpr std::string_view tell_hook(order_slots& slots, const text<10>& transit_id, const text<10>& value) noexcept {
    const transit_order* o = slots.find(transit_id);
    if (o != nullptr && (o->type == order_type::go_parking || o->type == order_type::go_node)) return reason::no_station;
    return slots.assign<Member>(transit_id, value) ? std::string_view{} : reason::unknown_transit;
}

/// Carries out an order for a cart in that mode of the circuit. Empty when that was possible, else the reason why not; then nothing changed.
template <class M>
constexpr std::string_view carry_out(const M& m, cart& c, circuit_mode mode, const text<10>& transit_id) noexcept {
    std::string_view refusal{};
    if constexpr (makes_transit(M::key)) {
        if (!takes_transits(mode)) return reason::no_transits;
        if (!c.slots.has_place()) return reason::no_place;
        if (!any_of(c.report(mode).cart_status, cart_status::ready)) return reason::not_ready;
        (void)c.slots.accept(transit_of(m, transit_id));
    } else if constexpr (M::key == order_type::cancel_transits) {
        (void)c.slots.cancel();
    } else if constexpr (M::key == order_type::send_command) {
        refusal = tell_hook<&transit_order::last_command>(c.slots, m.transit_id, m.command);
    } else if constexpr (M::key == order_type::send_inputs) {
        refusal = tell_hook<&transit_order::inputs>(c.slots, m.transit_id, m.inputs);
    } else if constexpr (M::key == order_type::send_cargo_id) {
        refusal = tell_hook<&transit_order::cargo_id>(c.slots, m.transit_id, m.cargo_id);
    } else {
        static_assert(M::key == order_type::cross_granted);
        if (c.state.cross_confirmation_needed != 1 || c.state.end_node != m.node) return reason::not_waiting;
        c.state.cross_confirmation_needed = 0;
    }
    if (refusal.empty()) c.changed = true;
    return refusal;
}

}  // namespace trama::gateway::detail
