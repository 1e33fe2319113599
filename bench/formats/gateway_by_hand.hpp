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
template <class Reader>
void read(Reader& r, load& m) {
    m.msg_id = static_cast<std::uint32_t>(r.number(5));
    m.cart_id = static_cast<std::uint32_t>(r.number(5));
    m.station_id = static_cast<std::uint32_t>(r.number(5));
    m.station_type = static_cast<std::uint32_t>(r.number(5));
    m.level = static_cast<std::uint8_t>(r.number(2));
    r.text(m.options);
    r.text(m.initial_inputs);
    r.text(m.cargo_id);
}

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
inline bool valid(const load& m) { return m.level <= 15; }

/// Words as the bench sums them, by hand; see `word_of`.
template <std::size_t N>
std::uint64_t word(const text<N>& t) {
    std::uint64_t first;
    std::uint16_t last;
    std::memcpy(&first, t.columns.data(), 8);
    std::memcpy(&last, t.columns.data() + N - 2, 2);
    return first + last;
}
inline std::uint64_t word(const transit_order& o) {
    return static_cast<std::uint64_t>(o.use) + static_cast<std::uint64_t>(o.type) + o.node + o.station_id + o.station_type + o.level + word(o.options) +
           word(o.transit_id) + word(o.cargo_id) + static_cast<std::uint64_t>(o.phase) + word(o.inputs) + word(o.outputs) + word(o.last_command);
}
inline std::uint64_t word(const cart_state& m) {
    return std::uint64_t{m.msg_id} + m.cart_id + static_cast<std::uint64_t>(m.cart_status) + static_cast<std::uint64_t>(m.cart_phase) + m.ini_node +
           m.rel_position + m.end_node + m.next_node + static_cast<std::uint64_t>(std::int64_t{m.speed_mms}) + m.cross_confirmation_needed +
           word(m.orders[0]) + word(m.orders[1]);
}
inline std::uint64_t word(const circuit_state& m) {
    return std::uint64_t{m.msg_id} + m.circuit_voltage + m.circuit_current + m.working_carts + static_cast<std::uint64_t>(m.check) +
           static_cast<std::uint64_t>(m.target_mode) + static_cast<std::uint64_t>(m.mode);
}
template <class Reply>
    requires requires(Reply m) { m.src_msg_id; }
std::uint64_t word(const Reply& m) {
    std::uint64_t sum = std::uint64_t{m.msg_id} + m.cart_id + static_cast<std::uint64_t>(m.src_type) + m.src_msg_id;
    if constexpr (requires { m.transit_id; }) sum += word(m.transit_id);
    if constexpr (requires { m.error_message; }) sum += word(m.error_message);
    return sum;
}
inline std::uint64_t word(const load& m) {
    return std::uint64_t{m.msg_id} + m.cart_id + m.station_id + m.station_type + m.level + word(m.options) + word(m.initial_inputs) + word(m.cargo_id);
}

/// Calls `f.operator()<M>()` for the record type, which fixes the payload's length: `load`, the replies and the states.
template <class F>
bool each_type(std::uint64_t type, F&& f) {
    switch (type) {
        case 1: return f.template operator()<load>();
        case 100: return f.template operator()<transit_ack>();
        case 101: return f.template operator()<ack>();
        case 102: return f.template operator()<nack>();
        case 200: return f.template operator()<cart_state>();
        case 201: return f.template operator()<circuit_state>();
        default: return false;
    }
}

}  // namespace trama::bench::by_hand
