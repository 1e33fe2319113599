#pragma once

#include "trama/core/wire_ascii.hpp"
#include "trama/core/wire_format.hpp"
#include "trama/gateway/enums.hpp"

/// Orders that take a cart somewhere, client to gateway.
namespace trama::gateway {

/// LOAD: go to a station and take a load. [gateway, "Order_types: load, transit, unload"]
struct load {
    std::uint32_t msg_id = 0;  ///< 0..99999.
    std::uint32_t cart_id = 0;  ///< 0..99999.
    std::uint32_t station_id = 0;  ///< 0..99999.
    std::uint32_t station_type = 0;  ///< 0..99999.
    std::uint8_t level = 0;  ///< 0..15 [D20].
    text<10> options{};
    text<10> initial_inputs{};
    text<10> cargo_id{};

    static constexpr order_type key = order_type::load;
    static constexpr std::string_view name = "load", section = "Order_types: load, transit, unload";
    static constexpr fields layout{
        field<&load::msg_id, wire::dec<5>>{"msg_id", {}, "counts up with every message and wraps to 0"},
        field<&load::cart_id, wire::dec<5>>{"cart_id", {}, "cart"},
        field<&load::station_id, wire::dec<5>>{"station_id", {}, "station"},
        field<&load::station_type, wire::dec<5>>{"station_type", {}, "identifies the station together with station_id, where used"},
        field<&load::level, wire::dec<2>>{"level", between(0, 15), "level inside the station"},
        field<&load::options, wire::chars<10>>{"options", {}, "modify the order, up to the application"},
        field<&load::initial_inputs, wire::chars<10>>{"initial_inputs", {}, "inputs of the station for the hook at first"},
        field<&load::cargo_id, wire::chars<10>>{"cargo_id", {}, "name of the load or transit, free use"},
    };
    friend constexpr bool operator==(const load&, const load&) = default;
};

/// TRANSIT: pass through a station for a process. [gateway, "Order_types: load, transit, unload"]
struct transit {
    std::uint32_t msg_id = 0;  ///< 0..99999.
    std::uint32_t cart_id = 0;  ///< 0..99999.
    std::uint32_t station_id = 0;  ///< 0..99999.
    std::uint32_t station_type = 0;  ///< 0..99999.
    std::uint8_t level = 0;  ///< 0..15 [D20].
    text<10> options{};
    text<10> initial_inputs{};
    text<10> cargo_id{};

    static constexpr order_type key = order_type::transit;
    static constexpr std::string_view name = "transit", section = "Order_types: load, transit, unload";
    static constexpr fields layout{
        field<&transit::msg_id, wire::dec<5>>{"msg_id", {}, "counts up with every message and wraps to 0"},
        field<&transit::cart_id, wire::dec<5>>{"cart_id", {}, "cart"},
        field<&transit::station_id, wire::dec<5>>{"station_id", {}, "station"},
        field<&transit::station_type, wire::dec<5>>{"station_type", {}, "identifies the station together with station_id, where used"},
        field<&transit::level, wire::dec<2>>{"level", between(0, 15), "level inside the station"},
        field<&transit::options, wire::chars<10>>{"options", {}, "modify the order, up to the application"},
        field<&transit::initial_inputs, wire::chars<10>>{"initial_inputs", {}, "inputs of the station for the hook at first"},
        field<&transit::cargo_id, wire::chars<10>>{"cargo_id", {}, "name of the load or transit, free use"},
    };
    friend constexpr bool operator==(const transit&, const transit&) = default;
};

/// UNLOAD: go to a station and put the load down. [gateway, "Order_types: load, transit, unload"]
struct unload {
    std::uint32_t msg_id = 0;  ///< 0..99999.
    std::uint32_t cart_id = 0;  ///< 0..99999.
    std::uint32_t station_id = 0;  ///< 0..99999.
    std::uint32_t station_type = 0;  ///< 0..99999.
    std::uint8_t level = 0;  ///< 0..15 [D20].
    text<10> options{};
    text<10> initial_inputs{};
    text<10> cargo_id{};

    static constexpr order_type key = order_type::unload;
    static constexpr std::string_view name = "unload", section = "Order_types: load, transit, unload";
    static constexpr fields layout{
        field<&unload::msg_id, wire::dec<5>>{"msg_id", {}, "counts up with every message and wraps to 0"},
        field<&unload::cart_id, wire::dec<5>>{"cart_id", {}, "cart"},
        field<&unload::station_id, wire::dec<5>>{"station_id", {}, "station"},
        field<&unload::station_type, wire::dec<5>>{"station_type", {}, "identifies the station together with station_id, where used"},
        field<&unload::level, wire::dec<2>>{"level", between(0, 15), "level inside the station"},
        field<&unload::options, wire::chars<10>>{"options", {}, "modify the order, up to the application"},
        field<&unload::initial_inputs, wire::chars<10>>{"initial_inputs", {}, "inputs of the station for the hook at first"},
        field<&unload::cargo_id, wire::chars<10>>{"cargo_id", {}, "name of the load or transit, free use"},
    };
    friend constexpr bool operator==(const unload&, const unload&) = default;
};

/// GO_PARKING: go to a parking area. [gateway, "Order_type: go_parking"]
struct go_parking {
    std::uint32_t msg_id = 0;  ///< 0..99999.
    std::uint32_t cart_id = 0;  ///< 0..99999.
    std::uint32_t parking_node = 0;  ///< 0..99999.

    static constexpr order_type key = order_type::go_parking;
    static constexpr std::string_view name = "go_parking", section = "Order_type: go_parking";
    static constexpr fields layout{
        field<&go_parking::msg_id, wire::dec<5>>{"msg_id", {}, "counts up with every message and wraps to 0"},
        field<&go_parking::cart_id, wire::dec<5>>{"cart_id", {}, "cart"},
        field<&go_parking::parking_node, wire::dec<5>>{"parking_node", {}, "exit node of the parking, 0 for the nearest"},
    };
    friend constexpr bool operator==(const go_parking&, const go_parking&) = default;
};

/// GO_NODE: go to a node. [gateway, "Order_type: go_node"]
struct go_node {
    std::uint32_t msg_id = 0;  ///< 0..99999.
    std::uint32_t cart_id = 0;  ///< 0..99999.
    std::uint32_t node = 0;  ///< 0..99999.

    static constexpr order_type key = order_type::go_node;
    static constexpr std::string_view name = "go_node", section = "Order_type: go_node";
    static constexpr fields layout{
        field<&go_node::msg_id, wire::dec<5>>{"msg_id", {}, "counts up with every message and wraps to 0"},
        field<&go_node::cart_id, wire::dec<5>>{"cart_id", {}, "cart"},
        field<&go_node::node, wire::dec<5>>{"node", {}, "destination"},
    };
    friend constexpr bool operator==(const go_node&, const go_node&) = default;
};

/// CANCEL_TRANSITS: give up the transits of a cart, running or waiting. [gateway, "Order_type: cancel_transits"]
struct cancel_transits {
    std::uint32_t msg_id = 0;  ///< 0..99999.
    std::uint32_t cart_id = 0;  ///< 0..99999.

    static constexpr order_type key = order_type::cancel_transits;
    static constexpr std::string_view name = "cancel_transits", section = "Order_type: cancel_transits";
    static constexpr fields layout{
        field<&cancel_transits::msg_id, wire::dec<5>>{"msg_id", {}, "counts up with every message and wraps to 0"},
        field<&cancel_transits::cart_id, wire::dec<5>>{"cart_id", {}, "cart"},
    };
    friend constexpr bool operator==(const cancel_transits&, const cancel_transits&) = default;
};

}  // namespace trama::gateway
