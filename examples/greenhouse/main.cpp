// A greenhouse in eight processes: a central master with the time, two masters, four nodes, and a hub that is the bus.
// A day goes by in as many seconds as you like. Run it with --help.

#include <sys/wait.h>

#include "members.hpp"

namespace {

using namespace greenhouse;

struct plan {
    std::uint8_t node;
    define_function function;
};

define_function continuous(std::uint8_t node) {
    define_function f{};
    f.node = node;
    f.function = can::function::continuous_all;
    return f;
}
/// Sensors 0 and 1, from eight in the morning to eight in the evening of the first day.
define_function by_day(std::uint8_t node) {
    define_function f{};
    f.node = node;
    f.function = can::function::interval_specific;
    f.start = {dawn.year, dawn.month, dawn.day, 8, 0, 0};
    f.end = {dawn.year, dawn.month, dawn.day, 20, 0, 0};
    f.sensor_count = 2;
    f.sensors = {0, 1, 0, 0};
    return f;
}
define_function only_soil(std::uint8_t node) {
    define_function f{};
    f.node = node;
    f.function = can::function::continuous_specific;
    f.sensor_count = 1;
    f.sensors = {3, 0, 0, 0};
    return f;
}
define_function asleep(std::uint8_t node) {
    define_function f{};
    f.node = node;
    f.function = can::function::sleep;
    return f;
}

/// How many sensors a node has to report between two moments; -1 if that changes in between, give or take ten minutes.
int expected_count(const define_function& f, const moment& first, const moment& last) {
    constexpr std::array<std::uint8_t, 4> all{0, 1, 2, 3};
    const auto count = [&](std::int64_t at) { return int{can::sensors_at(f, all, can::moment_at(at), true).count}; };
    const std::int64_t from = can::seconds_of(first) - 600, to = can::seconds_of(last) + 600;
    return count(from) == count(to) && count(from) == count((from + to) / 2) ? count(from) : -1;
}

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

constexpr std::size_t masters = 3, members = 7;

int member(std::size_t i, port bus, const can::timing& t, std::uint64_t end) {
    switch (i) {
        case 0: return central(bus, t);
        case 1: return govern(bus, can::master_1, "master 1", t, end, {{1, continuous(1)}, {2, by_day(2)}});
        case 2: return govern(bus, can::master_2, "master 2", t, end, {{3, only_soil(3)}, {4, asleep(4)}});
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

    hub bus(odds::of(o), o.number("seed"), o.text("record"));
    const int listener = o.has("can") ? open_can(o.text("can")) : -1;
    const bool real = listener >= 0;
    if (o.has("can") && !real) std::printf("no CAN interface %s here: using UNIX datagrams\n", o.text("can").c_str());
    if (real) bus.listen_to(listener);
    const can::timing t = patience(o.number("seconds"));
    const std::uint64_t end = micros() + o.number("seconds") * 1000000;
    std::array<int, members> ports{};
    for (int& p : ports) p = real ? open_can(o.text("can")) : bus.add();
    std::array<pid_t, members> children{};
    for (std::size_t i = 0; i != members; ++i) {
        std::fflush(stdout);
        children[i] = fork();
        if (children[i] < 0) die("fork");
        if (children[i] != 0) continue;
        const int status = member(i, port(ports[i]), t, end);
        std::fflush(stdout);
        _exit(status);
    }
    // The bus runs until the masters are done.
    std::size_t left = masters;
    bool good = true, told = false;
    while (left != 0) {
        bus.work(10);
        if (stopped != 0 && !told) for (const pid_t child : children) kill(child, SIGTERM);
        told = stopped != 0;
        if (left == 1 && children[0] != 0) kill(children[0], SIGTERM);  // both masters are done
        for (std::size_t i = 0; i != masters; ++i) {
            int status = 0;
            if (children[i] == 0 || waitpid(children[i], &status, WNOHANG) != children[i]) continue;
            good = good && WIFEXITED(status) && WEXITSTATUS(status) == 0;
            children[i] = 0;
            --left;
        }
    }
    for (std::size_t i = masters; i != members; ++i) kill(children[i], SIGTERM);
    for (std::size_t i = masters; i != members; ++i) while (waitpid(children[i], nullptr, 0) < 0 && errno == EINTR) {}
    std::printf("%llu frames, %llu faults\n", static_cast<unsigned long long>(bus.frames()), static_cast<unsigned long long>(bus.faults()));
    if (stopped != 0) return 0;
    std::printf(good ? "goal reached\n" : "goal missed\n");
    return good ? 0 : 1;
}
