#pragma once

#include "trama/core/wire_ascii.hpp"
#include "trama/core/wire_format.hpp"
#include "trama/gateway/enums.hpp"
#include "trama/gateway/flags.hpp"

/// States, gateway to client, unasked.
namespace trama::gateway {

/// One of the two transits that a cart can hold, 82 characters. [gateway, "Transit_order"]
struct transit_order {
    gateway::order_use use{};
    gateway::order_type type{};
    std::uint32_t node = 0;  ///< 0..99999.
    std::uint32_t station_id = 0;  ///< 0..99999.
    std::uint32_t station_type = 0;  ///< 0..99999.
    std::uint8_t level = 0;  ///< 0..15 [D20].
    text<10> options{};
    text<10> transit_id{};
    text<10> cargo_id{};
    gateway::transit_phase phase{};
    text<10> inputs{};
    text<10> outputs{};
    text<10> last_command{};

    static constexpr fields layout{
        field<&transit_order::use, wire::dec<1>>{"use", {}, "state of the slot"},
        field<&transit_order::type, wire::dec<3>>{"type", transit_types, "order that made it"},
        field<&transit_order::node, wire::dec<5>>{"node", {}, "destination of go_parking and go_node, 0 the nearest parking"},
        field<&transit_order::station_id, wire::dec<5>>{"station_id", {}, "station"},
        field<&transit_order::station_type, wire::dec<5>>{"station_type", {}, "identifies the station together with station_id"},
        field<&transit_order::level, wire::dec<2>>{"level", between(0, 15), "level inside the station"},
        field<&transit_order::options, wire::chars<10>>{"options", {}, "options of the order"},
        field<&transit_order::transit_id, wire::chars<10>>{"transit_id", {}, "as given by transit_ack"},
        field<&transit_order::cargo_id, wire::chars<10>>{"cargo_id", {}, "name of the load or transit"},
        field<&transit_order::phase, wire::dec<1>>{"phase", {}, "progress"},
        field<&transit_order::inputs, wire::chars<10>>{"inputs", {}, "what the hook is to consider"},
        field<&transit_order::outputs, wire::chars<10>>{"outputs", {}, "what the hook offers"},
        field<&transit_order::last_command, wire::chars<10>>{"last_command", {}, "the last send_command"},
    };
    friend constexpr bool operator==(const transit_order&, const transit_order&) = default;
};

/// CART_STATE: sent on every change of a cart. [gateway, "Order_type: cart_state"]
struct cart_state {
    std::uint32_t msg_id = 0;  ///< 0..99999.
    std::uint32_t cart_id = 0;  ///< 0..99999.
    gateway::cart_status cart_status{};
    gateway::cart_phase cart_phase{};
    std::uint32_t ini_node = 0;  ///< 0..99999.
    std::uint16_t rel_position = 0;  ///< 0..100 %.
    std::uint32_t end_node = 0;  ///< 0..99999.
    std::uint32_t next_node = 0;  ///< 0..99999.
    std::int32_t speed_mms = 0;  ///< -9999..99999 mm/s [D16].
    std::uint8_t cross_confirmation_needed = 0;  ///< 0..1.
    std::array<transit_order, 2> orders{};

    static constexpr order_type key = order_type::cart_state;
    static constexpr std::string_view name = "cart_state", section = "Order_type: cart_state";
    static constexpr fields layout{
        field<&cart_state::msg_id, wire::dec<5>>{"msg_id", {}, "counts up with every message and wraps to 0"},
        field<&cart_state::cart_id, wire::dec<5>>{"cart_id", {}, "cart"},
        field<&cart_state::cart_status, wire::dec<4>>{"cart_status", {}, "conditions"},
        field<&cart_state::cart_phase, wire::dec<1>>{"cart_phase", {}, "what the cart is doing"},
        field<&cart_state::ini_node, wire::dec<5>>{"ini_node", {}, "first node of the segment under way"},
        field<&cart_state::rel_position, wire::dec<3>>{"rel_position", between(0, 100), "share of the segment behind the cart, %"},
        field<&cart_state::end_node, wire::dec<5>>{"end_node", {}, "last node of the segment under way"},
        field<&cart_state::next_node, wire::dec<5>>{"next_node", {}, "last node of the next segment"},
        field<&cart_state::speed_mms, wire::signed_dec<5>>{"speed_mms", {}, "speed, mm/s"},
        field<&cart_state::cross_confirmation_needed, wire::dec<1>>{"cross_confirmation_needed", between(0, 1), "1 while a cross_granted for end_node is needed; without it the cart stops there"},
        field<&cart_state::orders, wire::repeated<wire::record<transit_order>, 2>>{"orders", {}, "the cart's two slots"},
    };
    friend constexpr bool operator==(const cart_state&, const cart_state&) = default;
};

/// CIRCUIT_STATE: sent on every change of the circuit. [gateway, "Order_type: circuit_state"]
struct circuit_state {
    std::uint32_t msg_id = 0;  ///< 0..99999.
    std::uint16_t circuit_voltage = 0;  ///< Tenths of a volt, 0..9999.
    std::uint16_t circuit_current = 0;  ///< Tenths of an ampere, 0..9999.
    std::uint32_t working_carts = 0;  ///< 0..99999.
    gateway::circuit_check check{};
    gateway::circuit_mode target_mode{};
    gateway::circuit_mode mode{};

    static constexpr order_type key = order_type::circuit_state;
    static constexpr std::string_view name = "circuit_state", section = "Order_type: circuit_state";
    static constexpr fields layout{
        field<&circuit_state::msg_id, wire::dec<5>>{"msg_id", {}, "counts up with every message and wraps to 0"},
        field<&circuit_state::circuit_voltage, wire::tenths<5>>{"circuit_voltage", {}, "voltage, V"},
        field<&circuit_state::circuit_current, wire::tenths<5>>{"circuit_current", {}, "current, A"},
        field<&circuit_state::working_carts, wire::dec<5>>{"working_carts", {}, "carts ready to work"},
        field<&circuit_state::check, wire::dec<7>>{"check", {}, "failed checks"},
        field<&circuit_state::target_mode, wire::dec<1>>{"target_mode", {}, "mode asked for"},
        field<&circuit_state::mode, wire::dec<1>>{"mode", {}, "mode in effect"},
    };
    friend constexpr bool operator==(const circuit_state&, const circuit_state&) = default;
};

}  // namespace trama::gateway
