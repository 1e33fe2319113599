#pragma once
// The gateway's records by hand. `Reader` takes one field after the other: `number(columns)`, `tenths(columns)`, `text(m)`.
#include "trama/gateway/messages.hpp"

namespace trama::bench::by_hand {

using namespace trama::gateway;

template <class Reader>
void read(Reader& r, transit_order& o) {
    o.use = static_cast<order_use>(r.number(1));
    o.type = static_cast<order_type>(r.number(3));
    o.node = static_cast<std::uint32_t>(r.number(5));
    o.station_id = static_cast<std::uint32_t>(r.number(5));
    o.station_type = static_cast<std::uint32_t>(r.number(5));
    o.level = static_cast<std::uint8_t>(r.number(2));
    r.text(o.options);
    r.text(o.transit_id);
    r.text(o.cargo_id);
    o.phase = static_cast<transit_phase>(r.number(1));
    r.text(o.inputs);
    r.text(o.outputs);
    r.text(o.last_command);
}
template <class Reader>
void read(Reader& r, cart_state& m) {
    m.msg_id = static_cast<std::uint32_t>(r.number(5));
    m.cart_id = static_cast<std::uint32_t>(r.number(5));
    m.cart_status = static_cast<cart_status>(r.number(4));
    m.cart_phase = static_cast<cart_phase>(r.number(1));
    m.ini_node = static_cast<std::uint32_t>(r.number(5));
    m.rel_position = static_cast<std::uint16_t>(r.number(3));
    m.end_node = static_cast<std::uint32_t>(r.number(5));
    m.next_node = static_cast<std::uint32_t>(r.number(5));
    m.speed_mms = static_cast<std::int32_t>(r.number(5));
    m.cross_confirmation_needed = static_cast<std::uint8_t>(r.number(1));
    for (auto& o : m.orders) read(r, o);
}
template <class Reader>
void read(Reader& r, circuit_state& m) {
    m.msg_id = static_cast<std::uint32_t>(r.number(5));
    m.circuit_voltage = static_cast<std::uint16_t>(r.tenths(5));
    m.circuit_current = static_cast<std::uint16_t>(r.tenths(5));
    m.working_carts = static_cast<std::uint32_t>(r.number(5));
    m.check = static_cast<circuit_check>(r.number(7));
    m.target_mode = static_cast<circuit_mode>(r.number(1));
    m.mode = static_cast<circuit_mode>(r.number(1));
}
template <class Reader, class Reply>
    requires requires(Reply m) { m.src_msg_id; }
void read(Reader& r, Reply& m) {
    m.msg_id = static_cast<std::uint32_t>(r.number(5));
    m.cart_id = static_cast<std::uint32_t>(r.number(5));
    m.src_type = static_cast<order_type>(r.number(3));
    m.src_msg_id = static_cast<std::uint32_t>(r.number(5));
    if constexpr (requires { m.transit_id; }) r.text(m.transit_id);
    if constexpr (requires { m.error_message; }) r.text(m.error_message);
}
template <class M>
concept station_order = std::is_same_v<M, load> || std::is_same_v<M, transit> || std::is_same_v<M, unload>;
template <class Reader, station_order M>
void read(Reader& r, M& m) {
    m.msg_id = static_cast<std::uint32_t>(r.number(5));
    m.cart_id = static_cast<std::uint32_t>(r.number(5));
    m.station_id = static_cast<std::uint32_t>(r.number(5));
    m.station_type = static_cast<std::uint32_t>(r.number(5));
    m.level = static_cast<std::uint8_t>(r.number(2));
    r.text(m.options);
    r.text(m.initial_inputs);
    r.text(m.cargo_id);
}

/// Orders of a few fields.
template <class M>
concept small_order = std::is_same_v<M, go_parking> || std::is_same_v<M, go_node> || std::is_same_v<M, cancel_transits> || std::is_same_v<M, send_command> ||
                      std::is_same_v<M, send_inputs> || std::is_same_v<M, send_cargo_id> || std::is_same_v<M, cross_granted> || std::is_same_v<M, idle_processing>;
template <class Reader, small_order M>
void read(Reader& r, M& m) {
    m.msg_id = static_cast<std::uint32_t>(r.number(5));
    if constexpr (requires { m.cart_id; }) m.cart_id = static_cast<std::uint32_t>(r.number(5));
    if constexpr (requires { m.parking_node; }) m.parking_node = static_cast<std::uint32_t>(r.number(5));
    if constexpr (requires { m.node; }) m.node = static_cast<std::uint32_t>(r.number(5));
    if constexpr (requires { m.transit_id; }) r.text(m.transit_id);
    if constexpr (requires { m.command; }) r.text(m.command);
    if constexpr (requires { m.inputs; }) r.text(m.inputs);
    if constexpr (requires { m.cargo_id; }) r.text(m.cargo_id);
}

/// Calls `f.operator()<M>()` for the record type, which fixes the payload's length.
template <class F>
bool each_type(std::uint64_t type, F&& f) {
    switch (type) {
        case 1: return f.template operator()<load>();
        case 2: return f.template operator()<transit>();
        case 3: return f.template operator()<unload>();
        case 10: return f.template operator()<go_parking>();
        case 15: return f.template operator()<go_node>();
        case 20: return f.template operator()<cancel_transits>();
        case 21: return f.template operator()<send_command>();
        case 22: return f.template operator()<send_inputs>();
        case 23: return f.template operator()<send_cargo_id>();
        case 30: return f.template operator()<cross_granted>();
        case 50: return f.template operator()<idle_processing>();
        case 100: return f.template operator()<transit_ack>();
        case 101: return f.template operator()<ack>();
        case 102: return f.template operator()<nack>();
        case 200: return f.template operator()<cart_state>();
        case 201: return f.template operator()<circuit_state>();
        default: return false;
    }
}

}  // namespace trama::bench::by_hand
