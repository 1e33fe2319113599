// The limit and the hand-written code that can is compared with.
#include "can.hpp"

#include <map>
#include <variant>

namespace trama::bench::can_code {

tally walk(frames_in in) {
    tally t;
    for (const can::frame& f : in) t.sum += f.id + f.length + load_le<std::uint64_t>(f.data.data());
    return {in.size(), t.sum, 0};
}

namespace {

can::moment moment_of(const std::uint8_t* date, const std::uint8_t* time) {
    return {static_cast<std::uint16_t>(date[0] * 100 + date[1]), date[2], date[3], time[0], time[1], time[2]};
}
can::define_function define_function_of(const std::uint8_t* p) {
    return {p[0], p[1], static_cast<can::function>(p[3] << 8 | p[4]), moment_of(p + 5, p + 13), moment_of(p + 9, p + 16), p[19], {p[20], p[21], p[22], p[23]}};
}
can::sensor_readings sensor_readings_of(const std::uint8_t* p) {
    return {p[0], p[1], p[3], {{{p[4], p[5]}, {p[6], p[7]}, {p[8], p[9]}, {p[10], p[11]}}}};
}
can::set_clock set_clock_of(const std::uint8_t* p) {
    return {p[0], p[1], static_cast<std::uint16_t>(p[3] * 100 + p[4]), p[5], p[6], p[7], p[8], p[9]};
}

std::uint64_t word(const can::moment& m) { return std::uint64_t{m.year} + m.month + m.day + m.hour + m.minute + m.second; }
struct summing {
    std::uint64_t operator()(const can::define_function& m) const {
        std::uint64_t sum = std::uint64_t{m.node} + m.message_id + static_cast<std::uint64_t>(m.function) + word(m.start) + word(m.end) + m.sensor_count;
        for (const auto s : m.sensors) sum += s;
        return sum;
    }
    std::uint64_t operator()(const can::read_sensors& m) const { return std::uint64_t{m.node} + m.message_id; }
    std::uint64_t operator()(const can::sensor_readings& m) const {
        std::uint64_t sum = std::uint64_t{m.node} + m.message_id + m.sensor_count;
        for (const auto& r : m.readings) sum += std::uint64_t{r.sensor} + r.value;
        return sum;
    }
    std::uint64_t operator()(const can::read_actuator& m) const { return std::uint64_t{m.node} + m.message_id + m.actuator; }
    std::uint64_t operator()(const can::actuator_state& m) const { return std::uint64_t{m.node} + m.message_id + m.actuator + m.state; }
    std::uint64_t operator()(const can::set_actuator& m) const { return std::uint64_t{m.node} + m.message_id + m.actuator + m.state; }
    std::uint64_t operator()(const can::set_clock& m) const {
        return std::uint64_t{m.node} + m.message_id + m.year + m.month + m.day + m.hour + m.minute + m.second;
    }
};

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
template <class M>
std::uint64_t key_of(const M&) { return static_cast<std::uint64_t>(M::key); }

}  // namespace

tally typed_maps(frames_in in) {
    using any = std::variant<can::define_function, can::read_sensors, can::sensor_readings, can::read_actuator, can::actuator_state, can::set_actuator, can::set_clock>;
    tally t;
    std::map<std::uint32_t, std::vector<std::uint8_t>> parts;
    for (const can::frame& f : in) {
        auto& part = parts[f.id];
        part.insert(part.end(), f.data.begin(), f.data.begin() + f.length);
        any message;
        const bool known = finish(part.data(), part.size(), [&](const auto& m) { message = m; });
        if (!known) continue;
        part.clear();
        ++t.messages;
        t.sum += f.id + std::visit(summing{}, message) + std::visit([](const auto& m) { return key_of(m); }, message);
    }
    return t;
}

tally typed_slots(frames_in in) {
    struct slot { std::uint8_t bytes[24]; std::size_t size = 0; } slots[3];
    tally t;
    for (const can::frame& f : in) {
        if (f.extended || f.remote || f.error || f.fd || f.id < 0x80 || f.id > 0x82) continue;
        slot& s = slots[f.id - 0x80];
        if (s.size + f.length > sizeof s.bytes || f.length > 8) { s.size = 0; continue; }
        std::memcpy(s.bytes + s.size, f.data.data(), f.length);
        s.size += f.length;
        const bool known = finish(s.bytes, s.size, [&](const auto& m) { t.sum += f.id + summing{}(m) + key_of(m); });
        if (!known) continue;
        s.size = 0;
        ++t.messages;
    }
    return t;
}

}  // namespace trama::bench::can_code
