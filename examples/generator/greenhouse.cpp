#include "capture.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "trama/trama.hpp"

namespace traffic {

namespace {

namespace can = trama::can;

class log {
public:
    std::string run();

private:
    // `frame` in the notation of candump.
    void logged(std::string_view frame) {
        std::array<char, 64> stamp{};
        std::snprintf(stamp.data(), stamp.size(), "(%lld.%06lld) can0 ", now_ / 1'000'000, now_ % 1'000'000);
        line_ << std::string_view(stamp.data()) << frame << "\n";
        now_ += 230;  // roughly a frame's time on a bus of 500 kbit/s
    }
    void frame(std::uint32_t id, std::span<const std::uint8_t> data) {
        std::array<char, 3> pair{};
        std::snprintf(pair.data(), pair.size(), "%02X", static_cast<unsigned>(id & 0xFF));
        std::string notation = std::to_string(id >> 8) + pair.data() + '#';  // three hex digits, the first 0..7
        for (const std::uint8_t octet : data) {
            std::snprintf(pair.data(), pair.size(), "%02X", unsigned{octet});
            notation += pair.data();
        }
        logged(notation);
    }

    // The first `count` frames of a message.
    template <class M>
    void send(std::uint32_t id, const M& m, std::size_t count = can::max_frames) {
        std::array<can::frame, can::max_frames> frames{};
        const auto made = can::format::encode_unchecked({id}, m, frames);
        if (!made) std::abort();
        for (std::size_t i = 0; i != *made && i != count; ++i) frame(id, std::span(frames[i].data).first(frames[i].length));
    }
    // Repeated by the node when it has understood.
    template <class M>
    void echoed(std::uint32_t id, const M& m) {
        send(id, m);
        now_ += random_.between(900, 2500);
        send(id, m);
        now_ += random_.between(900, 2500);
    }
    std::uint8_t message_id() { return static_cast<std::uint8_t>(message_id_ = message_id_ % 200 + 1); }
    can::sensor_readings readings(std::uint8_t node, std::uint8_t id);
    void poll(std::uint32_t master, std::uint8_t node);
    void configure();
    void actuators(int second);
    void foreign(int second);
    void interrupted();
    void stalled();

    numbers random_{810};
    capture line_;
    long long now_ = 1'299'999'600'000'000;  // microseconds
    int message_id_ = 0;
};

can::sensor_readings log::readings(std::uint8_t node, std::uint8_t id) {
    can::sensor_readings reply{node, id, static_cast<std::uint8_t>(node == 10 ? 4 : 2), {}};
    for (std::uint8_t i = 0; i != reply.sensor_count; ++i)
        reply.readings[i] = {i, static_cast<std::uint8_t>(random_.between(90 + 20 * i, 110 + 20 * i))};
    return reply;
}

void log::poll(std::uint32_t master, std::uint8_t node) {
    const std::uint8_t id = message_id();
    send(master, can::read_sensors{node, id});
    now_ += random_.between(900, 2500);
    send(master, readings(node, id));
    now_ += random_.between(900, 2500);
}

void log::configure() {
    echoed(can::central_master, can::set_clock{can::global_node, message_id(), 2011, 3, 13, 9, 0, 0});
    echoed(can::master_1, can::define_function{1, message_id(), can::function::continuous_all, {}, {}, 0, {}});
    echoed(can::master_1, can::define_function{2, message_id(), can::function::continuous_specific, {}, {}, 2, {0, 1}});
    const can::moment start{2011, 3, 13, 9, 15, 10}, end{2011, 3, 15, 23, 30, 5};
    echoed(can::master_2, can::define_function{10, message_id(), can::function::interval_specific, start, end, 4, {0, 1, 2, 3}});
    echoed(can::master_2, can::define_function{11, message_id(), can::function::sleep, {}, {}, 0, {}});
}

void log::actuators(int second) {
    const auto valve = static_cast<std::uint8_t>(second / 12 % 4);
    const auto open = static_cast<std::uint8_t>(second / 6 % 2);
    echoed(can::master_1, can::set_actuator{1, message_id(), valve, open});
    const std::uint8_t id = message_id();
    send(can::master_1, can::read_actuator{1, id, valve});
    now_ += 1400;
    send(can::master_1, can::actuator_state{1, id, valve, open});
}

void log::foreign(int second) {
    frame(0x123, std::array<std::uint8_t, 4>{0xDE, 0xAD, 0xBE, static_cast<std::uint8_t>(second)});
    if (second % 10 == 0) logged("18FEF100#FFFFFF0000FFFFFF");
    if (second % 15 == 0) logged("081#R3");
}

// The reply breaks off after its first frame; the master does not wait and asks again.
void log::interrupted() {
    const std::uint8_t id = message_id();
    send(can::master_1, can::read_sensors{2, id});
    send(can::master_1, readings(2, id), 1);
    now_ += 4000;
    send(can::master_1, can::read_sensors{2, id});
    send(can::master_1, readings(2, id));
}

// The node falls silent in the middle of its reply, longer than a master waits.
void log::stalled() {
    const std::uint8_t id = message_id();
    send(can::master_2, can::read_sensors{10, id});
    send(can::master_2, readings(10, id), 1);
    now_ += 1'600'000;
}

std::string log::run() {
    configure();
    for (int second = 1; second <= 75; ++second) {
        now_ += 1'000'000 - now_ % 1'000'000;
        poll(can::master_1, 1);
        if (second % 2 == 0) poll(can::master_1, 2);
        poll(can::master_2, 10);
        if (second % 6 == 0) actuators(second);
        if (second % 5 == 0) foreign(second);
        if (second == 20) interrupted();
        if (second == 33) line_ << "can0: bus-off, restarted\n";
        if (second == 41) stalled();
        if (second == 52) frame(can::master_1, std::array<std::uint8_t, 4>{2, 77, 'Q', 1});   // a letter of a later document
        if (second == 58) send(can::master_1, can::read_sensors{1, 203});                     // message ids end at 200
        if (second == 63) frame(can::central_master, std::array<std::uint8_t, 2>{99, 12});    // too short for any message
        if (second == 70) echoed(can::central_master, can::set_clock{can::global_node, message_id(), 2011, 3, 13, 9, 1, 10});
    }
    return line_.bytes();
}

}  // namespace

std::string greenhouse() { return log{}.run(); }

}  // namespace traffic
