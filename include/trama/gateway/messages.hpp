#pragma once

#include "trama/gateway/messages/commands.hpp"
#include "trama/gateway/messages/orders.hpp"
#include "trama/gateway/messages/replies.hpp"
#include "trama/gateway/messages/states.hpp"

namespace trama::gateway {

/// Every record of the document. [gateway, "Tipos de mensajes"]
using messages = message_list<load, transit, unload, go_parking, go_node, cancel_transits, send_command, send_inputs, send_cargo_id, cross_granted,
                              idle_processing, transit_ack, ack, nack, cart_state, circuit_state>;

}  // namespace trama::gateway
