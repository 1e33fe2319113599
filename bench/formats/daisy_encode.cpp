// What a controller sends in one turn: eight commands whose values change. And any of all messages, at random.
#include "daisy.hpp"
#include "daisy_by_hand.hpp"
#include "encode.hpp"

namespace trama::bench {

namespace {

using F = daisy::format;

/// The values of one turn.
struct turn {
    std::array<std::int16_t, 3> speeds;
    std::array<std::uint8_t, 5> positions;
    std::int32_t count;
    std::uint16_t level;
};

shared_inputs<turn> turns(std::size_t bytes) {
    auto all = std::make_shared<std::vector<turn>>(bytes / 70);
    dice d(7);
    for (turn& t : *all) {
        for (auto& s : t.speeds) s = static_cast<std::int16_t>(d.next());
        for (auto& p : t.positions) p = static_cast<std::uint8_t>(d.below(181));
        t.count = static_cast<std::int32_t>(d.next());
        t.level = static_cast<std::uint16_t>(d.below(1024));
    }
    return all;
}

constexpr std::size_t most_of_turn = 90;

std::size_t by_library(std::span<const turn> in, std::span<std::uint8_t> out) {
    using namespace daisy;
    std::size_t at = 0;
    const auto put = [&](address to, const auto& m) __attribute__((always_inline)) {
        if (const auto size = daisy::encode({to, {0}}, m, out.subspan(at))) at += *size;
    };
    for (const turn& t : in) {
        for (unsigned id = 0; id != 3; ++id) {
            const auto sense = t.speeds[id] < 0 ? direction::counter_clockwise : direction::clockwise;
            put(board(1, id), dc_motor::set_dc_speed{sense, t.speeds[id]});
        }
        put(board(1, 0), dc_motor::set_encoder{t.count});
        put(board(2, 0), servo_motor::set_all_positions{t.positions});
        put(board(3, 0), distance_sensor::get_value{0x0F});
        put(board(4, 0), battery_controller::set_battery_empty_value{t.level});
        put(board(1, 1), dc_motor::get_encoder{});
    }
    return at;
}

/// As one writes it first: a vector for each packet, appended to a larger one.
std::size_t by_vectors(std::span<const turn> in, std::span<std::uint8_t> out) {
    std::size_t at = 0;
    const auto put = [&](std::uint8_t to, std::uint8_t command, const std::vector<std::uint8_t>& data) {
        std::vector<std::uint8_t> packet;
        packet.push_back(static_cast<std::uint8_t>(data.size() + 4));
        packet.push_back(to);
        packet.push_back(0);
        packet.push_back(command);
        for (const std::uint8_t b : data) packet.push_back(b);
        std::uint8_t crc = 0;
        for (const std::uint8_t b : packet) crc = static_cast<std::uint8_t>(crc ^ b);
        packet.push_back(crc);
        std::copy(packet.begin(), packet.end(), out.begin() + static_cast<std::ptrdiff_t>(at));
        at += packet.size();
    };
    const auto byte = [](auto v, int i) { return static_cast<std::uint8_t>(static_cast<std::uint32_t>(v) >> 8 * i); };
    for (const turn& t : in) {
        for (unsigned id = 0; id != 3; ++id)
            put(static_cast<std::uint8_t>(0x10 + id), 0x41, {t.speeds[id] < 0 ? std::uint8_t{1} : std::uint8_t{0}, byte(t.speeds[id], 0), byte(t.speeds[id], 1)});
        put(0x10, 0x42, {byte(t.count, 0), byte(t.count, 1), byte(t.count, 2), byte(t.count, 3)});
        put(0x20, 0x41, {t.positions.begin(), t.positions.end()});
        put(0x30, 0x44, {0x0F});
        put(0x40, 0x44, {byte(t.level, 0), byte(t.level, 1)});
        put(0x11, 0x43, {});
    }
    return at;
}

/// The header and the CRC around `n` bytes of data that stand in place; where the next packet begins.
std::uint8_t* finish(std::uint8_t* p, std::uint8_t to, std::uint8_t from, std::uint8_t command, std::uint8_t n) {
    p[0] = static_cast<std::uint8_t>(n + 4);
    p[1] = to;
    p[2] = from;
    p[3] = command;
    std::uint8_t crc = 0;
    for (int i = 0; i != n + 4; ++i) crc = static_cast<std::uint8_t>(crc ^ p[i]);
    p[n + 4] = crc;
    return p + n + 5;
}

/// A pointer, memcpy for the values and a loop for the CRC.
std::size_t by_pointer(std::span<const turn> in, std::span<std::uint8_t> out) {
    std::uint8_t* p = out.data();
    const auto put = [&](std::uint8_t to, std::uint8_t command, const void* data, std::uint8_t n) {
        std::memcpy(p + 4, data, n);
        p = finish(p, to, 0, command, n);
    };
    for (const turn& t : in) {
        for (unsigned id = 0; id != 3; ++id) {
            std::uint8_t data[3] = {t.speeds[id] < 0 ? std::uint8_t{1} : std::uint8_t{0}};
            std::memcpy(data + 1, &t.speeds[id], 2);
            put(static_cast<std::uint8_t>(0x10 + id), 0x41, data, 3);
        }
        put(0x10, 0x42, &t.count, 4);
        put(0x20, 0x41, t.positions.data(), 5);
        const std::uint8_t sensors = 0x0F;
        put(0x30, 0x44, &sensors, 1);
        put(0x40, 0x44, &t.level, 2);
        put(0x11, 0x43, &t, 0);
    }
    return static_cast<std::size_t>(p - out.data());
}

/// Any message as hand-written code has it.
struct any_body {
    std::uint8_t destination, source, command;
    by_hand::body body;
};
std::size_t any_by_pointer(std::span<const any_body> in, std::span<std::uint8_t> out) {
    std::uint8_t* p = out.data();
    for (const any_body& one : in) {
        const std::size_t n = std::visit([&](const auto& m) { return by_hand::store(p + 4, m); }, one.body);
        p = finish(p, one.destination, one.source, one.command, static_cast<std::uint8_t>(n));
    }
    return static_cast<std::size_t>(p - out.data());
}
shared_inputs<any_body> bodies_of(const std::vector<any_message<F>>& all) {
    auto bodies = std::make_shared<std::vector<any_body>>();
    std::array<std::uint8_t, F::max_units> out;
    for (const auto& one : all) {
        const std::size_t size = encode_any<F>({&one, 1}, out);
        const unsigned key = by_hand::family_of(out[1], out[2], out[3]) << 8 | out[3];
        by_hand::decode(key, out.data() + 4, size - 5, [&](const auto& body) { bodies->push_back({out[1], out[2], out[3], body}); });
    }
    return bodies;
}

void race_commands(race& r, std::size_t bytes) {
    const auto inputs = turns(bytes);
    encoding<std::uint8_t> e(r, inputs->size() * 8, inputs->size() * most_of_turn);
    e.add("trama", role::library, inputs, by_library);
    e.add("vectors", role::baseline, inputs, by_vectors);
    e.add("pointers", role::baseline, inputs, by_pointer);
}
void race_any(race& r, std::size_t bytes) {
    const auto inputs = any_messages<F>(bytes / 8);
    encoding<std::uint8_t> e(r, inputs->size(), inputs->size() * 16);
    e.add("trama", role::library, inputs, encode_any<F>);
    e.add("pointers", role::baseline, bodies_of(*inputs), any_by_pointer);
    e.prove_by_reading(daisy_read_back, fields_of(*inputs));
}

}  // namespace

void add_daisy_encode(std::vector<entry>& all, const scale& sizes) {
    add_encoding(all, sizes, "daisy", "commands", race_commands);
    add_encoding(all, sizes, "daisy", "random mix", race_any);
}

}  // namespace trama::bench
