// Encoding frames: single ones that set actuators, and all messages at random, of one to three frames each.
#include "can.hpp"
#include "can_by_hand.hpp"
#include "encode.hpp"

namespace trama::bench {

namespace {

using F = can::format;
using setpoint = can::set_actuator;

std::size_t by_library(std::span<const setpoint> in, std::span<can::frame> out) {
    std::size_t at = 0;
    for (const setpoint& m : in)
        if (const auto n = can::encode({can::master_1}, m, out.subspan(at))) at += *n;
    return at;
}
/// As one writes it first: a vector for the data, a fresh frame, a copy.
std::size_t by_vectors(std::span<const setpoint> in, std::span<can::frame> out) {
    std::size_t at = 0;
    for (const setpoint& m : in) {
        const std::vector<std::uint8_t> data{m.node, m.message_id, 'M', m.actuator, m.state};
        can::frame f{};
        f.id = can::master_1;
        f.length = static_cast<std::uint8_t>(data.size());
        std::copy(data.begin(), data.end(), f.data.begin());
        out[at++] = f;
    }
    return at;
}
/// A frame in place, without data.
void begin(can::frame& f, std::uint32_t id, std::size_t length) {
    f = can::frame{};
    f.id = id;
    f.length = static_cast<std::uint8_t>(length);
}
std::size_t by_pointer(std::span<const setpoint> in, std::span<can::frame> out) {
    can::frame* f = out.data();
    for (const setpoint& m : in) {
        begin(*f, can::master_1, 5);
        f->data[0] = m.node;
        f->data[1] = m.message_id;
        f->data[2] = 'M';
        f->data[3] = m.actuator;
        f->data[4] = m.state;
        ++f;
    }
    return in.size();
}

shared_inputs<setpoint> setpoints(std::size_t count) {
    auto all = std::make_shared<std::vector<setpoint>>(count);
    dice d(22);
    arena memory;
    for (auto& m : *all) m = random_message<setpoint>(d, memory);
    return all;
}

/// Cuts the bytes of a message into frames of eight; only the last of any message is shorter.
std::size_t any_by_vectors(std::span<const any_message<F>> in, std::span<can::frame> out) {
    std::size_t at = 0;
    for (const auto& one : in) {
        const std::vector<std::uint8_t> data = std::visit([](const auto& m) {
            std::vector<std::uint8_t> bytes(by_hand::size_of<std::remove_cvref_t<decltype(m)>>());
            by_hand::store([&](std::size_t i) -> std::uint8_t& { return bytes[i]; }, m);
            return bytes;
        }, one.message);
        for (std::size_t from = 0; from < data.size(); from += 8) {
            can::frame f{};
            f.id = one.addresses.id;
            f.length = static_cast<std::uint8_t>(std::min<std::size_t>(8, data.size() - from));
            std::copy_n(data.begin() + static_cast<std::ptrdiff_t>(from), f.length, f.data.begin());
            out[at++] = f;
        }
    }
    return at;
}
/// Every byte straight to its frame.
std::size_t any_by_pointer(std::span<const any_message<F>> in, std::span<can::frame> out) {
    can::frame* f = out.data();
    for (const auto& one : in)
        std::visit([&](const auto& m) {
            constexpr std::size_t size = by_hand::size_of<std::remove_cvref_t<decltype(m)>>(), frames = (size + 7) / 8;
            for (std::size_t i = 0; i != frames; ++i) begin(f[i], one.addresses.id, std::min<std::size_t>(8, size - 8 * i));
            by_hand::store([&](std::size_t i) -> std::uint8_t& { return f[i / 8].data[i % 8]; }, m);
            f += frames;
        }, one.message);
    return static_cast<std::size_t>(f - out.data());
}

void race_setpoints(race& r, std::size_t bytes) {
    const auto inputs = setpoints(bytes / sizeof(can::frame));
    encoding<can::frame> e(r, inputs->size(), inputs->size());
    e.add("trama", role::library, inputs, by_library);
    e.add("vectors", role::baseline, inputs, by_vectors);
    e.add("pointers", role::baseline, inputs, by_pointer);
}
void race_any(race& r, std::size_t bytes) {
    const auto inputs = any_messages<F>(bytes / sizeof(can::frame) / 2);
    encoding<can::frame> e(r, inputs->size(), inputs->size() * F::max_units);
    e.add("trama", role::library, inputs, encode_any<F>);
    e.add("vectors", role::baseline, inputs, any_by_vectors);
    e.add("pointers", role::baseline, inputs, any_by_pointer);
    e.prove_by_reading(can_read_back, fields_of(*inputs));
}

}  // namespace

void add_can_encode(std::vector<entry>& all, const scale& sizes) {
    add_encoding(all, sizes, "can", "setpoints", race_setpoints);
    add_encoding(all, sizes, "can", "random mix", race_any);
}

}  // namespace trama::bench
