#pragma once
// What goes over a ring of boards again and again.

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "laws/daisy_subject.hpp"

namespace trama::test {

/// One cycle of a line's traffic.
struct schedule {
    std::string name;
    octets cycle{};
    std::vector<std::size_t> starts{};  ///< Of the packets in `cycle`.

    /// Appends one packet.
    schedule& add(const octets& packet) {
        starts.push_back(cycle.size());
        append(cycle, packet);
        return *this;
    }
    schedule& add(std::uint8_t destination, std::uint8_t source, std::uint8_t command, const octets& data = {}) {
        return add(sealed(destination, source, command, data));
    }
    /// A request of the main controller and the board's reply.
    schedule& poll(std::uint8_t board, std::uint8_t command, const octets& question, const octets& answer) {
        add(board, 0x00, command, question);
        return add(0x00, board, static_cast<std::uint8_t>(command | 0x80), answer);
    }
};

inline octets text_bytes(std::string_view s) { return {s.begin(), s.end()}; }

/// ERROR 0: `rejected` as it came, and the CRC it should have had.
inline octets bad_crc_report(std::uint8_t destination, std::uint8_t source, const octets& rejected, std::uint8_t expected) {
    octets data{0};
    append(data, rejected);
    data.push_back(expected);
    return sealed(destination, source, 0x04, data);
}

/// Polls of encoders and speeds. Joined at its 0xC3, the 14 bytes of one GET ENCODER exchange read as a packet of 196.
inline std::vector<schedule> motor_schedules() {
    schedule at_rest{"encoder poll"}, moving{"encoder poll, big count"}, tempting{"encoder poll that reads as a text"}, three{"three motors"};
    at_rest.poll(0x11, 0x43, {}, {0, 0, 0, 0});
    moving.poll(0x11, 0x43, {}, {0x56, 0x34, 0x12, 0x00});
    tempting.poll(0x11, 0x43, {}, {0x11, 0x00, 0x81, 0x00});
    three.poll(0x11, 0x43, {}, {0x10, 0x27, 0, 0}).poll(0x12, 0x43, {}, {0xF0, 0xD8, 0xFF, 0xFF});
    three.poll(0x13, 0x4B, {}, {1, 0x2C, 0x01});
    return {at_rest, moving, tempting, three};
}

inline std::vector<schedule> sensor_schedules() {
    schedule all{"six distances"}, one{"one distance"};
    all.poll(0x31, 0x44, {0x3F}, {0x3F, 0xC8, 0, 0x2C, 1, 0, 0, 0xFF, 3, 0x0A, 0, 0x94, 0x75});
    one.poll(0x31, 0x45, {0x04}, {0x04, 0x2C, 0x01}).poll(0x32, 0x45, {0x20}, {0x20, 0xFF, 0xFF});
    return {all, one};
}

inline std::vector<schedule> ring_schedules() {
    schedule ring{"whole ring"}, alarms{"ring with alarms"};
    ring.poll(0x11, 0x43, {}, {0x56, 0x34, 0x12, 0}).poll(0x21, 0x43, {}, {90, 90, 0, 180, 45}).poll(0x31, 0x44, {0x03}, {0x03, 0xC8, 0, 0x2C, 1});
    ring.poll(0x41, 0x42, {}, {0x6B, 0x03}).poll(0x51, 0x40, {}, {0x10, 0x00});
    alarms.poll(0x11, 0x41, {1, 0x2C, 0x01}, {}).add(0x00, 0x11, 0x49, {0xFF, 0x03}).add(0x11, 0x00, 0xC9);
    alarms.poll(0x21, 0x4A, {}, {0x15}).add(0x00, 0x21, 0x4C, {3, 1, 1}).add(0x21, 0x00, 0xCC).add(0x00, 0x62, 0x45, {0x6B, 0x03}).add(0xFF, 0x00, 0x03);
    return {ring, alarms};
}

inline std::vector<schedule> text_schedules() {
    schedule start{"init of three boards"}, plain{"texts only"}, binary{"texts that are no text"}, mixed{"binary text and polls"};
    start.add(0xFF, 0x00, 0x01).add(0x00, 0x11, 0x81, text_bytes("Motor DC v1.2\r\n")).add(0x00, 0x21, 0x81, text_bytes("Servos")).add(0x00, 0x31, 0x81);
    plain.add(0x00, 0x11, 0x81, text_bytes("Placa de motores")).add(0x00, 0x41, 0x82, text_bytes("Bateria, 12 V\n"));
    binary.add(0x00, 0x11, 0x81, {0xB5, 0x00, 0x01, 0xFE, 0x80, 0x9D}).add(0x00, 0x21, 0x82, {0xC7, 0xF3, 0x02, 0x91});
    mixed.poll(0x11, 0x43, {}, {0x56, 0x34, 0x12, 0}).add(0x00, 0x21, 0x81, {0xC1, 0xF1, 0x02, 0x91, 0xA0});
    return {start, plain, binary, mixed};
}

inline std::vector<schedule> strange_schedules() {
    const octets damaged{0x08, 0x00, 0x11, 0xC3, 0x56, 0x34, 0x10, 0x00, 0xAA};
    schedule commands{"undocumented commands"}, groups{"undocumented groups"}, reports{"reports of bad CRCs"}, partial{"reports of cut packets"};
    commands.poll(0x11, 0x43, {}, {0x56, 0x34, 0x12, 0}).poll(0x11, 0x5A, {1, 2, 3}, {9, 8, 7, 6});
    groups.add(0x91, 0x00, 0x43).add(0x00, 0x91, 0xC3, {1, 2, 3, 4}).poll(0x12, 0x48, {}, {0x80, 0x01});
    reports.poll(0x11, 0x43, {}, {0x56, 0x34, 0x12, 0}).add(bad_crc_report(0x11, 0x00, damaged, xor_of(std::span(damaged).first(8))));
    partial.poll(0x11, 0x43, {}, {0x56, 0x34, 0x12, 0}).add(bad_crc_report(0x11, 0x00, octets(damaged.begin(), damaged.begin() + 6), 0x77));
    return {commands, groups, reports, partial};
}

/// A cycle of random packets, undocumented ones among them.
inline schedule random_schedule(std::uint64_t seed) {
    rng random(seed);
    schedule s{"random, seed " + std::to_string(seed)};
    for (std::size_t n = random.within(2, 6); n != 0 || s.cycle.size() < 12; n -= n != 0 ? 1 : 0)
        s.add(random.one_in(5) ? subject<daisy::format>::undocumented(random) : random_units<daisy::format>(random, manners::valid));
    return s;
}

/// All but the random ones.
inline std::vector<schedule> all_schedules() {
    std::vector<schedule> all;
    for (const auto& some : {motor_schedules(), sensor_schedules(), ring_schedules(), text_schedules(), strange_schedules()}) all.insert(all.end(), some.begin(), some.end());
    return all;
}

/// For messages of GoogleTest.
inline void PrintTo(const schedule& s, std::ostream* out) { *out << s.name; }

}  // namespace trama::test
