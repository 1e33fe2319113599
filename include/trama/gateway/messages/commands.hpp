#pragma once

#include "trama/core/wire_ascii.hpp"
#include "trama/core/wire_format.hpp"
#include "trama/gateway/enums.hpp"

/// What a client sends about transits under way, client to gateway.
namespace trama::gateway {

/// SEND_COMMAND: a command for the hook. [gateway, "Order_type: send_command"]
struct send_command {
    std::uint32_t msg_id = 0;  ///< 0..99999.
    std::uint32_t cart_id = 0;  ///< 0..99999.
    text<10> transit_id{};
    text<10> command{};

    static constexpr order_type key = order_type::send_command;
    static constexpr std::string_view name = "send_command", section = "Order_type: send_command";
    static constexpr fields layout{
        field<&send_command::msg_id, wire::dec<5>>{"msg_id", {}, "counts up with every message and wraps to 0"},
        field<&send_command::cart_id, wire::dec<5>>{"cart_id", {}, "cart"},
        field<&send_command::transit_id, wire::chars<10>>{"transit_id", {}, "as given by transit_ack"},
        field<&send_command::command, wire::chars<10>>{"command", {}, "command for the hook"},
    };
    friend constexpr bool operator==(const send_command&, const send_command&) = default;
};

/// SEND_INPUTS: what the hook sees of the station. [gateway, "Order_type: send_inputs"]
struct send_inputs {
    std::uint32_t msg_id = 0;  ///< 0..99999.
    std::uint32_t cart_id = 0;  ///< 0..99999.
    text<10> transit_id{};
    text<10> inputs{};

    static constexpr order_type key = order_type::send_inputs;
    static constexpr std::string_view name = "send_inputs", section = "Order_type: send_inputs";
    static constexpr fields layout{
        field<&send_inputs::msg_id, wire::dec<5>>{"msg_id", {}, "counts up with every message and wraps to 0"},
        field<&send_inputs::cart_id, wire::dec<5>>{"cart_id", {}, "cart"},
        field<&send_inputs::transit_id, wire::chars<10>>{"transit_id", {}, "as given by transit_ack"},
        field<&send_inputs::inputs, wire::chars<10>>{"inputs", {}, "inputs of the station for the hook"},
    };
    friend constexpr bool operator==(const send_inputs&, const send_inputs&) = default;
};

/// SEND_CARGO_ID: names the load of a transit [D13]. [gateway, "Order_type: send_cargo_id"]
struct send_cargo_id {
    std::uint32_t msg_id = 0;  ///< 0..99999.
    std::uint32_t cart_id = 0;  ///< 0..99999.
    text<10> transit_id{};
    text<10> cargo_id{};

    static constexpr order_type key = order_type::send_cargo_id;
    static constexpr std::string_view name = "send_cargo_id", section = "Order_type: send_cargo_id";
    static constexpr fields layout{
        field<&send_cargo_id::msg_id, wire::dec<5>>{"msg_id", {}, "counts up with every message and wraps to 0"},
        field<&send_cargo_id::cart_id, wire::dec<5>>{"cart_id", {}, "cart"},
        field<&send_cargo_id::transit_id, wire::chars<10>>{"transit_id", {}, "as given by transit_ack"},
        field<&send_cargo_id::cargo_id, wire::chars<10>>{"cargo_id", {}, "name of the load or transit, free use"},
    };
    friend constexpr bool operator==(const send_cargo_id&, const send_cargo_id&) = default;
};

/// CROSS_GRANTED: lets a cart pass on. [gateway, "Order_type: cross_granted"]
struct cross_granted {
    std::uint32_t msg_id = 0;  ///< 0..99999.
    std::uint32_t cart_id = 0;  ///< 0..99999.
    std::uint32_t node = 0;  ///< 0..99999.

    static constexpr order_type key = order_type::cross_granted;
    static constexpr std::string_view name = "cross_granted", section = "Order_type: cross_granted";
    static constexpr fields layout{
        field<&cross_granted::msg_id, wire::dec<5>>{"msg_id", {}, "counts up with every message and wraps to 0"},
        field<&cross_granted::cart_id, wire::dec<5>>{"cart_id", {}, "cart"},
        field<&cross_granted::node, wire::dec<5>>{"node", {}, "node allowed, the cart's end_node"},
    };
    friend constexpr bool operator==(const cross_granted&, const cross_granted&) = default;
};

/// IDLE_PROCESSING: now is a good moment for the carts' housekeeping. [gateway, "Order_type: idle_processing"]
struct idle_processing {
    std::uint32_t msg_id = 0;  ///< 0..99999.

    static constexpr order_type key = order_type::idle_processing;
    static constexpr std::string_view name = "idle_processing", section = "Order_type: idle_processing";
    static constexpr fields layout{
        field<&idle_processing::msg_id, wire::dec<5>>{"msg_id", {}, "counts up with every message and wraps to 0"},
    };
    friend constexpr bool operator==(const idle_processing&, const idle_processing&) = default;
};

}  // namespace trama::gateway
