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

/// Bytes of a message, all its frames together.
template <class M>
constexpr std::size_t size_of() {
    if (std::is_same_v<M, can::define_function>) return 24;
    if (std::is_same_v<M, can::sensor_readings>) return 12;
    if (std::is_same_v<M, can::set_clock>) return 10;
    return std::is_same_v<M, can::read_sensors> ? 3 : std::is_same_v<M, can::read_actuator> ? 4 : 5;
}
/// Writes the bytes of a message; `at(i)` is where the i-th goes.
template <class M>
void store(auto&& at, const M& m) {
    const auto put_year = [&](std::size_t i, unsigned year) {
        at(i) = static_cast<std::uint8_t>(year / 100);
        at(i + 1) = static_cast<std::uint8_t>(year % 100);
    };
    const auto put_moment = [&](std::size_t date, std::size_t time, const can::moment& t) {
        put_year(date, t.year);
        at(date + 2) = t.month; at(date + 3) = t.day; at(time) = t.hour; at(time + 1) = t.minute; at(time + 2) = t.second;
    };
    at(0) = m.node;
    at(1) = m.message_id;
    if constexpr (std::is_same_v<M, can::define_function>) {
        at(2) = 'F';
        at(3) = static_cast<std::uint8_t>(static_cast<unsigned>(m.function) >> 8);
        at(4) = static_cast<std::uint8_t>(m.function);
        put_moment(5, 13, m.start);
        put_moment(9, 16, m.end);
        at(19) = m.sensor_count;
        for (std::size_t i = 0; i != 4; ++i) at(20 + i) = m.sensors[i];
    } else if constexpr (std::is_same_v<M, can::sensor_readings>) {
        at(2) = 'R';
        at(3) = m.sensor_count;
        for (std::size_t i = 0; i != 4; ++i) { at(4 + 2 * i) = m.readings[i].sensor; at(5 + 2 * i) = m.readings[i].value; }
    } else if constexpr (std::is_same_v<M, can::set_clock>) {
        at(2) = 'C';
        put_year(3, m.year);
        at(5) = m.month; at(6) = m.day; at(7) = m.hour; at(8) = m.minute; at(9) = m.second;
    } else {
        at(2) = static_cast<std::uint8_t>(std::is_same_v<M, can::read_sensors> ? 'R' : std::is_same_v<M, can::set_actuator> ? 'M' : 'A');
        if constexpr (requires { m.actuator; }) at(3) = m.actuator;
        if constexpr (requires { m.state; }) at(4) = m.state;
    }
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
