#pragma once
// Messages of can by hand: out of the bytes of their frames, into words, and judged.
#include <cstring>

#include "trama/can/messages.hpp"

namespace trama::bench::by_hand {

inline can::moment moment_of(const std::uint8_t* date, const std::uint8_t* time) {
    return {static_cast<std::uint16_t>(date[0] * 100 + date[1]), date[2], date[3], time[0], time[1], time[2]};
}
inline can::define_function define_function_of(const std::uint8_t* p) {
    return {p[0], p[1], static_cast<can::function>(p[3] << 8 | p[4]), moment_of(p + 5, p + 13), moment_of(p + 9, p + 16), p[19], {p[20], p[21], p[22], p[23]}};
}
inline can::sensor_readings sensor_readings_of(const std::uint8_t* p) {
    return {p[0], p[1], p[3], {{{p[4], p[5]}, {p[6], p[7]}, {p[8], p[9]}, {p[10], p[11]}}}};
}
inline can::set_clock set_clock_of(const std::uint8_t* p) {
    return {p[0], p[1], static_cast<std::uint16_t>(p[3] * 100 + p[4]), p[5], p[6], p[7], p[8], p[9]};
}

/// Calls `f(message)` for the `n` bytes of a complete message; false as long as more frames must come.
template <class F>
bool finish(const std::uint8_t* p, std::size_t n, F&& f) {
    const std::uint8_t node = p[0], id = p[1];
    switch (p[2]) {
        case 'F': return n == 24 && (f(define_function_of(p)), true);
        case 'R':
            if (n == 3) return f(can::read_sensors{node, id}), true;
            return n == 12 && (f(sensor_readings_of(p)), true);
        case 'A':
            if (n == 4) return f(can::read_actuator{node, id, p[3]}), true;
            return f(can::actuator_state{node, id, p[3], p[4]}), true;
        case 'M': return f(can::set_actuator{node, id, p[3], p[4]}), true;
        case 'C': return n == 10 && (f(set_clock_of(p)), true);
        default: return true;
    }
}

/// Writes the bytes of a message's frames and tells how many there are.
inline std::size_t store(std::uint8_t* p, const can::define_function& m) {
    const auto f = static_cast<unsigned>(m.function);
    const auto high = [](unsigned v) { return static_cast<std::uint8_t>(v / 100); };
    const auto low = [](unsigned v) { return static_cast<std::uint8_t>(v % 100); };
    const std::uint8_t bytes[24] = {m.node, m.message_id, 'F', static_cast<std::uint8_t>(f >> 8), static_cast<std::uint8_t>(f),
                                    high(m.start.year), low(m.start.year), m.start.month, m.start.day, high(m.end.year), low(m.end.year), m.end.month, m.end.day,
                                    m.start.hour, m.start.minute, m.start.second, m.end.hour, m.end.minute, m.end.second,
                                    m.sensor_count, m.sensors[0], m.sensors[1], m.sensors[2], m.sensors[3]};
    std::memcpy(p, bytes, sizeof bytes);
    return sizeof bytes;
}
inline std::size_t store(std::uint8_t* p, const can::sensor_readings& m) {
    p[0] = m.node; p[1] = m.message_id; p[2] = 'R'; p[3] = m.sensor_count;
    for (std::size_t i = 0; i != 4; ++i) { p[4 + 2 * i] = m.readings[i].sensor; p[5 + 2 * i] = m.readings[i].value; }
    return 12;
}
inline std::size_t store(std::uint8_t* p, const can::set_clock& m) {
    p[0] = m.node; p[1] = m.message_id; p[2] = 'C';
    p[3] = static_cast<std::uint8_t>(m.year / 100); p[4] = static_cast<std::uint8_t>(m.year % 100);
    p[5] = m.month; p[6] = m.day; p[7] = m.hour; p[8] = m.minute; p[9] = m.second;
    return 10;
}
template <class M>
std::size_t store(std::uint8_t* p, const M& m) {
    p[0] = m.node; p[1] = m.message_id;
    p[2] = static_cast<std::uint8_t>(std::is_same_v<M, can::read_sensors> ? 'R' : std::is_same_v<M, can::set_actuator> ? 'M' : 'A');
    std::size_t n = 3;
    if constexpr (requires { m.actuator; }) p[n++] = m.actuator;
    if constexpr (requires { m.state; }) p[n++] = m.state;
    return n;
}

/// Calls `f(word)` for the words that the bench sums over all fields; see `each_word`.
void words_of(const can::moment& m, auto&& f) {
    f(m.year); f(m.month); f(m.day); f(m.hour); f(m.minute); f(m.second);
}
void words_of(const can::define_function& m, auto&& f) {
    f(m.node); f(m.message_id); f(static_cast<std::uint64_t>(m.function));
    words_of(m.start, f);
    words_of(m.end, f);
    f(m.sensor_count);
    for (const auto s : m.sensors) f(s);
}
void words_of(const can::read_sensors& m, auto&& f) { f(m.node); f(m.message_id); }
void words_of(const can::sensor_readings& m, auto&& f) {
    f(m.node); f(m.message_id); f(m.sensor_count);
    for (const auto& r : m.readings) { f(r.sensor); f(r.value); }
}
void words_of(const can::read_actuator& m, auto&& f) { f(m.node); f(m.message_id); f(m.actuator); }
void words_of(const can::actuator_state& m, auto&& f) { f(m.node); f(m.message_id); f(m.actuator); f(m.state); }
void words_of(const can::set_actuator& m, auto&& f) { f(m.node); f(m.message_id); f(m.actuator); f(m.state); }
void words_of(const can::set_clock& m, auto&& f) {
    f(m.node); f(m.message_id); f(m.year); f(m.month); f(m.day); f(m.hour); f(m.minute); f(m.second);
}

/// What the document allows, as comparisons by hand.
inline bool valid_time(const can::moment& m) {
    return m.year <= 9999 && m.month >= 1 && m.month <= 12 && m.day >= 1 && m.day <= 31 && m.hour <= 23 && m.minute <= 59 && m.second <= 59;
}
inline bool valid(const can::define_function& m) {
    const auto f = static_cast<unsigned>(m.function);
    const bool interval = f == ('I' << 8 | 'A') || f == ('I' << 8 | 'S'), listed = f == ('C' << 8 | 'S') || f == ('I' << 8 | 'S');
    if (!interval && !listed && f != ('C' << 8 | 'A') && f != ('S' << 8 | 'A')) return false;
    if (interval ? !valid_time(m.start) || !valid_time(m.end) : m.start != can::moment{} || m.end != can::moment{}) return false;
    if (listed ? m.sensor_count < 1 || m.sensor_count > 4 : m.sensor_count != 0) return false;
    for (std::size_t i = m.sensor_count; i != 4; ++i)
        if (m.sensors[i] != 0) return false;
    return m.message_id <= 200;
}
inline bool valid(const can::sensor_readings& m) {
    if (m.sensor_count > 4) return false;
    for (std::size_t i = m.sensor_count; i != 4; ++i)
        if (m.readings[i].sensor != 0 || m.readings[i].value != 0) return false;
    return m.message_id <= 200;
}
inline bool valid(const can::set_clock& m) { return m.message_id <= 200 && valid_time({m.year, m.month, m.day, m.hour, m.minute, m.second}); }
template <class Any>
bool valid(const Any& m) { return m.message_id <= 200; }

}  // namespace trama::bench::by_hand
