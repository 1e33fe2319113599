// A greenhouse in eight processes: a central master with the time, two masters, four nodes, and a hub that is the bus.
// A day goes by in as many seconds as you like. Run it with --help.

#include "common/family.hpp"
#include "plans.hpp"

namespace {

using namespace greenhouse;

/// For programs that hardly get the processor: how long they may go on when the day is over and the work is not done.
constexpr std::uint64_t grace = 120000000;

/// Tells everyone the time, once a second, until it is stopped.
int central(port bus, const can::timing& t) {
    station s(bus, can::central_master, t, false, "central");
    can::calendar clock(t.second);
    clock.set(dawn, micros());
    std::uint64_t next = 0;
    unsigned confirmed = 0;
    while (stopped == 0) {
        if (micros() >= next && s.master.waiting() == 0) {
            (void)s.master.set_every_clock(clock.at(micros()));
            next = micros() + 1000000;
        }
        s.work([&](const can::master_event& e) {
            if (e.news == can::master_news::answered && confirmed++ == 0) s.say(clock.at(micros()), "clocks are set");
        });
    }
    s.say(clock.at(micros()), "clock set %u times, %llu retries", confirmed, static_cast<unsigned long long>(s.master.quality().retries));
    return confirmed != 0 ? 0 : 1;
}

/// A master's day: sets its nodes' clocks, gives them their functions, reads them every second, lamps on at dusk.
int govern(port bus, std::uint32_t id, const char* name, const can::timing& t, std::uint64_t end, const std::vector<plan>& plans) {
    station s(bus, id, t, id == can::master_1, name);
    std::map<int, int> read, wrong, last_hour;
    std::map<int, moment> last_read;
    for (const plan& p : plans) s.master.poll(p.node);
    const auto time = [&] { return s.master.clock().at(micros()); };
    const auto set_clock = [&](std::uint8_t node) {
        s.add([&, node]() -> trama::result<std::uint8_t> {
            if (!s.master.clock().known()) return trama::errc::need_more;
            const moment m = time();
            return s.master.request(can::set_clock{node, 0, m.year, m.month, m.day, m.hour, m.minute, m.second});
        });
    };
    for (const plan& p : plans) {
        set_clock(p.node);
        s.add([&s, p] { return s.master.request(p.function); });
    }
    const std::size_t preparations = s.tasks.size();
    bool ready = false, dusk = false;
    const auto done = [&] {
        bool all = ready && s.open_tasks() == 0;
        for (const plan& p : plans) all = all && read[p.node] != 0;
        return all;
    };
    while (stopped == 0 && (micros() < end || (!done() && micros() < end + grace))) {
        s.work([&](const can::master_event& e) {
            if (e.news == can::master_news::failed) s.say(time(), "node %u: no answer to %c", unsigned{e.node}, e.letter);
            const auto m = trama::decode<can::sensor_readings>(e.packet);
            if (e.news != can::master_news::answered || !m || !ready) return;
            if (read[m->node]++ == 0) last_read[m->node] = time();
            for (const plan& p : plans) {
                if (p.node != m->node) continue;
                const int expected = expected_count(p.function, last_read[m->node], time());
                if (expected >= 0 && expected != m->sensor_count) ++wrong[m->node];
            }
            last_read[m->node] = time();
            if (last_hour.contains(m->node) && last_hour[m->node] == time().hour) return;
            last_hour[m->node] = time().hour;
            std::string text;
            for (unsigned i = 0; i != m->sensor_count; ++i) text += "  sensor " + std::to_string(m->readings[i].sensor) + ": " + std::to_string(m->readings[i].value);
            s.say(time(), "node %u%s", unsigned{m->node}, text.empty() ? "  no sensor active" : text.c_str());
        });
        if (!ready && s.open_tasks() == 0) {
            ready = true;
            s.say(time(), "all nodes have the time and their functions");
        }
        if (ready && !dusk && time().hour >= 18) {
            dusk = true;
            for (const plan& p : plans) s.add([&s, p] { return s.master.request(can::set_actuator{p.node, 0, 0, 1}); });
            s.say(time(), "lamps on");
        }
    }
    const auto& q = s.master.quality();
    bool good = done();
    for (const plan& p : plans) {
        s.say(time(), "node %u: read %d times, %d times with the wrong sensors", unsigned{p.node}, read[p.node], wrong[p.node]);
        good = good && wrong[p.node] == 0;
    }
    s.say(time(), "%zu of %zu preparations, %llu retries, %llu time-outs, %llu failures, round trip %llu..%llu us", std::min(preparations, s.tasks.size() - s.open_tasks()), preparations,
          static_cast<unsigned long long>(q.retries), static_cast<unsigned long long>(q.timeouts), static_cast<unsigned long long>(q.failures), static_cast<unsigned long long>(q.round_trip.least), static_cast<unsigned long long>(q.round_trip.most));
    return good ? 0 : 1;
}

constexpr std::size_t masters = 3;
constexpr std::array names{"the central master", "master 1", "master 2", "node 1", "node 2", "node 3", "node 4"};

int member(std::size_t i, port bus, const can::timing& t, std::uint64_t end) {
    switch (i) {
        case 0: return central(bus, t);
        case 1: return govern(bus, can::master_1, names[i], t, end, {{1, continuous(1)}, {2, by_day(2)}});
        case 2: return govern(bus, can::master_2, names[i], t, end, {{3, only_soil(3)}, {4, asleep(4)}});
        case 3: return live(bus, 1, can::master_1, t);
        case 4: return live(bus, 2, can::master_1, t);
        case 5: return live(bus, 3, can::master_2, t);
        default: return live(bus, 4, can::master_2, t);
    }
}

}  // namespace

int main(int argc, char** argv) {
    options o("greenhouse: three masters and four nodes on a CAN bus, each a process of its own, and a day that goes by quickly\n");
    o.add("seconds", "N", "how long the day takes; the goal is judged at its end", "24");
    o.add("can", "IFACE", "use this SocketCAN interface, such as vcan0; without it or where it is missing: UNIX datagrams");
    o.add("record", "FILE", "write everything on the bus to FILE as a candump log");
    odds::add_to(o, "frames");
    o.parse(argc, argv);
    catch_signals();

    const int listener = o.has("can") ? open_can(o.text("can")) : -1;
    const bool real = listener >= 0;
    const odds faults = odds::of(o);
    if (real && faults.any()) refuse("--flip, --drop, --duplicate and --delay are for the bus of UNIX datagrams: nothing damages the frames on " + o.text("can"));
    if (o.has("can") && !real) std::printf("no CAN interface %s here: using UNIX datagrams\n", o.text("can").c_str());
    const unsigned long seconds = o.number("seconds");
    hub bus(faults, o.number("seed"), o.text("record"));
    if (real) bus.listen_to(listener);
    const can::timing t = patience(seconds);
    const std::uint64_t end = micros() + seconds * 1000000;
    std::array<int, names.size()> ports{};
    for (int& p : ports)
        if ((p = real ? open_can(o.text("can")) : bus.add()) < 0) die(o.text("can"));
    family all;
    for (std::size_t i = 0; i != names.size(); ++i) all.start(names[i], [&] { return member(i, port(ports[i]), t, end); });

    // The bus runs until the masters are done: 1 and 2 by themselves, the others when they are told.
    int outcome = 0;
    bool over = false;
    const auto ended = [&](std::size_t i, int status) {
        const bool done = !all.alive(1) && !all.alive(2), has_an_end = i == 1 || i == 2 || (i == 0 && done);
        const bool early = status >= 2 || (!has_an_end && !over && stopped == 0);
        if (early) all.complain(i, status);
        if (i < masters || early) outcome = std::max(outcome, early && status != 2 ? 1 : status);
        over = over || early;
    };
    for (bool told = false; all.alive(0) || all.alive(1) || all.alive(2); all.look(ended)) {
        bus.work(10);
        over = over || stopped != 0;
        if (over && !told) all.stop_all();
        told = over;
        if (!all.alive(1) && !all.alive(2)) all.stop(0);
    }
    over = true;
    all.end(ended);
    std::printf("%llu frames, %llu faults\n", static_cast<unsigned long long>(bus.frames()), static_cast<unsigned long long>(bus.faults()));
    if (stopped != 0) return finish(0);
    std::printf(outcome == 0 ? "goal reached\n" : "goal missed\n");
    return finish(outcome);
}
