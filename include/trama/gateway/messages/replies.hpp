#pragma once

#include "trama/core/wire_ascii.hpp"
#include "trama/core/wire_format.hpp"
#include "trama/gateway/enums.hpp"

/// Replies, gateway to client.
namespace trama::gateway {

/// TRANSIT_ACK: accepts load, transit, unload, go_parking, go_node. [gateway, "Order_type: transit_ack"]
struct transit_ack {
    std::uint32_t msg_id = 0;  ///< 0..99999.
    std::uint32_t cart_id = 0;  ///< 0..99999.
    gateway::order_type src_type{};
    std::uint32_t src_msg_id = 0;  ///< 0..99999.
    text<10> transit_id{};

    static constexpr order_type key = order_type::transit_ack;
    static constexpr std::string_view name = "transit_ack", section = "Order_type: transit_ack";
    static constexpr fields layout{
        field<&transit_ack::msg_id, wire::dec<5>>{"msg_id", {}, "counts up with every message and wraps to 0"},
        field<&transit_ack::cart_id, wire::dec<5>>{"cart_id", {}, "cart"},
        field<&transit_ack::src_type, wire::dec<3>>{"src_type", client_types, "type of the order that is answered"},
        field<&transit_ack::src_msg_id, wire::dec<5>>{"src_msg_id", {}, "msg_id of the order that is answered"},
        field<&transit_ack::transit_id, wire::chars<10>>{"transit_id", {}, "name that the gateway gives the transit"},
    };
    friend constexpr bool operator==(const transit_ack&, const transit_ack&) = default;
};

/// ACK: accepts any other order. Of idle_processing, cart_id is 0 [D18]. [gateway, "Order_type: ack"]
struct ack {
    std::uint32_t msg_id = 0;  ///< 0..99999.
    std::uint32_t cart_id = 0;  ///< 0..99999.
    gateway::order_type src_type{};
    std::uint32_t src_msg_id = 0;  ///< 0..99999.

    static constexpr order_type key = order_type::ack;
    static constexpr std::string_view name = "ack", section = "Order_type: ack";
    static constexpr fields layout{
        field<&ack::msg_id, wire::dec<5>>{"msg_id", {}, "counts up with every message and wraps to 0"},
        field<&ack::cart_id, wire::dec<5>>{"cart_id", {}, "cart"},
        field<&ack::src_type, wire::dec<3>>{"src_type", client_types, "type of the order that is answered"},
        field<&ack::src_msg_id, wire::dec<5>>{"src_msg_id", {}, "msg_id of the order that is answered"},
    };
    friend constexpr bool operator==(const ack&, const ack&) = default;
};

/// NACK: refuses an order. The text has 80 characters [D14]. [gateway, "Order_type: nack"]
struct nack {
    std::uint32_t msg_id = 0;  ///< 0..99999.
    std::uint32_t cart_id = 0;  ///< 0..99999.
    gateway::order_type src_type{};
    std::uint32_t src_msg_id = 0;  ///< 0..99999.
    text<80> error_message{};

    static constexpr order_type key = order_type::nack;
    static constexpr std::string_view name = "nack", section = "Order_type: nack";
    static constexpr fields layout{
        field<&nack::msg_id, wire::dec<5>>{"msg_id", {}, "counts up with every message and wraps to 0"},
        field<&nack::cart_id, wire::dec<5>>{"cart_id", {}, "cart"},
        field<&nack::src_type, wire::dec<3>>{"src_type", client_types, "type of the order that is answered"},
        field<&nack::src_msg_id, wire::dec<5>>{"src_msg_id", {}, "msg_id of the order that is answered"},
        field<&nack::error_message, wire::chars<80>>{"error_message", {}, "why"},
    };
    friend constexpr bool operator==(const nack&, const nack&) = default;
};

}  // namespace trama::gateway
