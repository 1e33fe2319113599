// What a controller sends in one turn: eight commands whose values change. And any of all messages, at random.
#include <variant>

#include "daisy.hpp"
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

std::shared_ptr<const std::vector<turn>> turns(std::size_t bytes) {
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

/// A pointer, memcpy for the values and a loop for the CRC.
std::size_t by_pointer(std::span<const turn> in, std::span<std::uint8_t> out) {
    std::uint8_t* p = out.data();
    const auto put = [&](std::uint8_t to, std::uint8_t command, const void* data, std::uint8_t n) {
        p[0] = static_cast<std::uint8_t>(n + 4);
        p[1] = to;
        p[2] = 0;
        p[3] = command;
        std::memcpy(p + 4, data, n);
        std::uint8_t crc = 0;
        for (int i = 0; i != n + 4; ++i) crc = static_cast<std::uint8_t>(crc ^ p[i]);
        p[n + 4] = crc;
        p += n + 5;
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

template <class List>
struct variant_of;
template <class... M>
struct variant_of<message_list<M...>> {
    using type = std::variant<M...>;
};
struct any_message {
    daisy::envelope addresses;
    variant_of<daisy::messages>::type message;
};

std::size_t any_by_library(std::span<const any_message> in, std::span<std::uint8_t> out) {
    std::size_t at = 0;
    for (const any_message& one : in)
        std::visit([&](const auto& m) { if (const auto size = daisy::encode(one.addresses, m, out.subspan(at))) at += *size; }, one.message);
    return at;
}

std::shared_ptr<const std::vector<any_message>> any_messages(std::size_t bytes) {
    auto all = std::make_shared<std::vector<any_message>>();
    dice d(8);
    arena memory;
    while (all->size() < bytes / 8)
        daisy::messages::at(d.below(daisy::messages::count), [&]<class M>() {
            if constexpr (M::layout.fixed) all->push_back({traits<F>::addresses<M>(d), random_message<M>(d, memory)});
        });
    return all;
}

}  // namespace

void add_daisy_encode(std::vector<entry>& all, const scale& sizes) {
    for (const std::size_t bytes : {sizes.large, sizes.small}) {
        race r{"daisy", "commands", size_name(bytes), "encode", {}};
        all.push_back({r.id(), [r, bytes]() mutable {
            encoding<turn, std::uint8_t> e(r, turns(bytes), 8, most_of_turn);
            e.add("trama", role::library, by_library);
            e.add("vectors", role::baseline, by_vectors);
            e.add("pointers", role::baseline, by_pointer);
            return r;
        }});
    }
    race any{"daisy", "random mix", size_name(sizes.large), "encode", {}};
    all.push_back({any.id(), [any, bytes = sizes.large]() mutable {
        encoding<any_message, std::uint8_t> e(any, any_messages(bytes), 1, daisy::max_packet / 8);
        e.add("trama", role::library, any_by_library);
        return any;
    }});
}

}  // namespace trama::bench
