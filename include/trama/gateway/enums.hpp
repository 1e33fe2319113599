#pragma once

#include <array>
#include <cstdint>

#include "trama/core/rule.hpp"
#include "trama/core/names.hpp"

namespace trama::gateway {

/// Type of a record, its first three characters; also names the order that a reply or a transit belongs to.
/// [gateway, "Tipos de mensajes"]
enum class order_type : std::uint16_t {
    none = 0, load = 1, transit = 2, unload = 3, go_parking = 10, go_node = 15, cancel_transits = 20, send_command = 21, send_inputs = 22,
    send_cargo_id = 23, cross_granted = 30, idle_processing = 50, transit_ack = 100, ack = 101, nack = 102, cart_state = 200, circuit_state = 201,
};
consteval auto names(order_type) {
    using enum order_type;
    return std::array{named{none, "none"}, named{load, "load"}, named{transit, "transit"}, named{unload, "unload"}, named{go_parking, "go_parking"},
                      named{go_node, "go_node"}, named{cancel_transits, "cancel_transits"}, named{send_command, "send_command"},
                      named{send_inputs, "send_inputs"}, named{send_cargo_id, "send_cargo_id"}, named{cross_granted, "cross_granted"},
                      named{idle_processing, "idle_processing"}, named{transit_ack, "transit_ack"}, named{ack, "ack"}, named{nack, "nack"},
                      named{cart_state, "cart_state"}, named{circuit_state, "circuit_state"}};
}

/// Some of the order types, all below 64, as a rule with their names.
template <order_type... Types>
inline constexpr std::array some_names{name_of(Types)...};
template <order_type... Types>
inline constexpr rule some_types{0, 0, 0, (std::uint64_t{0} | ... | (std::uint64_t{1} << static_cast<unsigned>(Types))), some_names<Types...>, {}};

/// The orders of a client: what a reply may answer. [D19]
inline constexpr rule client_types = some_types<order_type::load, order_type::transit, order_type::unload, order_type::go_parking, order_type::go_node,
                                                order_type::cancel_transits, order_type::send_command, order_type::send_inputs,
                                                order_type::send_cargo_id, order_type::cross_granted, order_type::idle_processing>;
/// What a slot of a cart may hold.
inline constexpr rule transit_types = some_types<order_type::none, order_type::load, order_type::transit, order_type::unload, order_type::go_parking, order_type::go_node>;

/// Use of one of a cart's two transit slots. [gateway, "Order_use"]
enum class order_use : std::uint8_t { unused, previous, current, next };
consteval auto names(order_use) {
    using enum order_use;
    return std::array{named{unused, "unused"}, named{previous, "previous"}, named{current, "current"}, named{next, "next"}};
}

/// Progress of a transit. [gateway, "Transit_phase"]
enum class transit_phase : std::uint8_t { none, go_transit, transiting, transit_done };
consteval auto names(transit_phase) {
    using enum transit_phase;
    return std::array{named{none, "none"}, named{go_transit, "go_transit"}, named{transiting, "transiting"}, named{transit_done, "transit_done"}};
}

/// What a cart is doing. [gateway, "Cart_phase"]
enum class cart_phase : std::uint8_t { none, go_load, loading, go_transit, transiting, transit_done, go_unload, unloading, go_parking, go_node };
consteval auto names(cart_phase) {
    using enum cart_phase;
    return std::array{named{none, "none"}, named{go_load, "go_load"}, named{loading, "loading"}, named{go_transit, "go_transit"},
                      named{transiting, "transiting"}, named{transit_done, "transit_done"}, named{go_unload, "go_unload"},
                      named{unloading, "unloading"}, named{go_parking, "go_parking"}, named{go_node, "go_node"}};
}

/// Working mode of the circuit. [gateway, "Circuit_mode"]
enum class circuit_mode : std::uint8_t { no_power_freezing, no_power_frozen, init, manual, semi_automatic, automatic, shutdown_ready, shutting_down };
consteval auto names(circuit_mode) {
    using enum circuit_mode;
    return std::array{named{no_power_freezing, "no_power_freezing"}, named{no_power_frozen, "no_power_frozen"}, named{init, "init"},
                      named{manual, "manual"}, named{semi_automatic, "semi_automatic"}, named{automatic, "automatic"},
                      named{shutdown_ready, "shutdown_ready"}, named{shutting_down, "shutting_down"}};
}

}  // namespace trama::gateway
