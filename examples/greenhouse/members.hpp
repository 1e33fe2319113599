#pragma once
// Who is on the bus: nodes with their plants, masters with their nodes, the central master with the time.

#include <cmath>
#include <functional>

#include "bus.hpp"
#include "trama/can/master.hpp"
#include "trama/can/sensor_node.hpp"

namespace greenhouse {

using can::define_function;
using can::moment;

inline constexpr moment dawn{2011, 4, 1, 6, 0, 0};

/// Everyone's patience: times in microseconds, and a day as short as the user wants it.
inline can::timing patience(unsigned long day_seconds) {
    return {std::max<std::uint64_t>(1, day_seconds * 1000000 / 86400), 1000000, 60000, 25, 20000};
}

/// A bed of plants: light, temperature, humidity of the air and of the soil; a lamp and a tap.
struct plants {
    std::function<moment()> time;
    std::array<std::uint8_t, 2> actuators{};

    std::uint8_t read(std::uint8_t sensor) const {
        const moment t = time();
        const double sun = std::sin((t.hour + t.minute / 60.0 - 6) * 3.14159265 / 12);
        const double light = std::max(0.0, sun) * 200 + (actuators[0] != 0 ? 40 : 0);
        const double values[] = {light, 14 + 9 * sun, 70 - 20 * sun, actuators[1] != 0 ? 90.0 : 55.0};
        return static_cast<std::uint8_t>(values[sensor % 4]);
    }
    bool set(std::uint8_t actuator, std::uint8_t state) {
        if (actuator >= actuators.size()) return false;
        actuators[actuator] = state;
        return true;
    }
    bool get(std::uint8_t actuator, std::uint8_t& state) const {
        if (actuator >= actuators.size()) return false;
        state = actuators[actuator];
        return true;
    }
};

inline int live(port bus, std::uint8_t self, std::uint32_t master, const can::timing& t) {
    can::sensor_node<4> node(self, master, {0, 1, 2, 3}, t);
    plants bed;
    bed.time = [&] { return node.clock().at(micros()); };
    while (stopped == 0) {
        const auto in = bus.wait(2);
        for (std::span<const can::frame> rest(in);;) {
            const auto e = node.next(rest, micros(), bed);
            if (e.news == can::sensor_node_news::need_more) break;
        }
        while (const can::frame* f = node.front()) {
            if (!bus.send(*f)) break;
            node.sent();
        }
    }
    return 0;
}

/// Something that has to be answered once; asked anew until it is.
struct task {
    std::function<trama::result<std::uint8_t>()> ask;
    int message_id = -1;
    char letter = 0;
    bool done = false;
};

/// A master under way: its tasks, its readings, what it prints.
class station {
public:
    station(port bus, std::uint32_t id, const can::timing& t, bool confirms, const char* name) : bus_(bus), name_(name), master(id, t, confirms) {}

    /// One turn. `heard` gets what was answered or heard.
    template <class F>
    void work(F&& heard) {
        const auto in = bus_.wait(2);
        for (task& one : tasks) start(one);
        for (std::span<const can::frame> rest(in);;) {
            const auto e = master.next(rest, micros());
            if (e.news == can::master_news::need_more) break;
            if (e.news == can::master_news::answered || e.news == can::master_news::failed) settle(e);
            heard(e);
        }
        while (const can::frame* f = master.front()) {
            if (!bus_.send(*f)) break;
            master.sent(micros());
        }
    }
    template <class... A>
    void say(const moment& t, const char* format, A... values) const {
        std::printf("%02u:%02u  %-9s ", t.hour, t.minute, name_);
        if constexpr (sizeof...(A) == 0) std::fputs(format, stdout);
        else std::printf(format, values...);
        std::printf("\n");
        flush_output();
    }
    std::size_t open_tasks() const {
        std::size_t n = 0;
        for (const task& one : tasks) n += one.done ? 0U : 1U;
        return n;
    }
    void add(std::function<trama::result<std::uint8_t>()> ask) { tasks.push_back({std::move(ask)}); }

private:
    void start(task& one) {
        if (one.done || one.message_id >= 0) return;
        if (const auto id = one.ask()) one.message_id = *id;
    }
    void settle(const can::master_event& e) {
        for (task& one : tasks) {
            if (e.letter == 'R' || one.done || one.message_id != e.message_id) continue;
            one.done = e.news == can::master_news::answered;
            one.message_id = -1;
        }
    }
    port bus_;
    const char* name_;

public:
    can::master<4, 24> master;
    std::vector<task> tasks;
};

}  // namespace greenhouse
