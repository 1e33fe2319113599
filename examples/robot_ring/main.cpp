// A robot in six processes: the main controller and five boards on pseudo-terminals, wired in a ring. Each member reads
// from the one before it and writes to the one behind it; nobody else sees the bytes. Run it with --help.

#include <algorithm>

#include "common/family.hpp"
#include "mission.hpp"

namespace {

using namespace robot;

constexpr std::size_t members = 6;  // the controller, then the boards in the order of their groups
constexpr unsigned long first_alarm = 1000;  // the battery's value in its first alarm; each one behind it has one less, down to 0
const daisy::timing patience{120, 25, 25, 0};

struct goal { unsigned long seconds, cycles, alarms, pause; };

/// A board: answers until it is stopped. The battery raises its alarms one after the other.
template <class Board>
int live(ends& line, unsigned long alarms) {
    Board device;
    daisy::node<> node(Board::where, Board::description, patience);
    octets out(daisy::node<>::max_output);
    std::uint16_t next = 0;
    std::uint64_t alarm_at = now() + 500;
    while (stopped == 0) {
        const octets in = line.wait(5);
        for (std::span<const std::uint8_t> rest(in);;) {
            const auto e = node.next(rest, now(), out, device);
            if (e.news == daisy::node_news::need_more) break;
            if (e.news == daisy::node_news::lost) --next;  // the attempts are used up: raise the same one anew
            line.send(std::span(out).first(e.written));
        }
        if constexpr (std::is_same_v<Board, battery_board>) {
            if (next >= alarms || now() < alarm_at || node.in_flight() != 0) continue;
            const auto size = node.send(daisy::board(0, 0), daisy::battery_controller::battery_empty_alarm{static_cast<std::uint16_t>(first_alarm - next)}, now(), out);
            if (!size) continue;  // the alarm before it is settling
            line.send(std::span(out).first(*size));
            ++next;
            alarm_at = now() + 200;
        }
    }
    return 0;
}

int control(ends& line, const goal& g) {
    mission m(line, patience, g.seconds != 0 ? now() + 1000 * g.seconds : 0);
    bool good = m.find_boards(members - 1);
    unsigned long done = 0;
    while (good && !m.over() && (g.cycles == 0 || done != g.cycles)) {
        const auto count = static_cast<std::int32_t>(1193046 + 4711 * done);
        good = m.set_surely(motor_board::where, daisy::dc_motor::set_encoder{count}, daisy::dc_motor::get_encoder{}, daisy::dc_motor::get_encoder_reply{count});
        const auto angle = static_cast<std::uint8_t>(done % 181);
        const std::array<std::uint8_t, 5> arm{angle, 90, 45, 0, 180};
        good = good && m.set_surely(servo_board::where, daisy::servo_motor::set_all_positions{arm}, daisy::servo_motor::get_all_positions{}, daisy::servo_motor::get_all_positions_reply{arm});
        const auto near = good ? m.ask_surely(distance_board::where, daisy::distance_sensor::get_value{0x07}) : std::nullopt;
        const auto battery = near ? m.ask_surely(battery_board::where, daisy::battery_controller::get_battery_value{}) : std::nullopt;
        const auto bin = battery ? m.ask_surely(bin_board::where, daisy::trash_bin::get_trash_bin_value{}) : std::nullopt;
        good = bin.has_value();
        if (!good) break;
        ++done;
        m.say("round %lu: encoder %d, arm %u degrees, %zu distances, battery %u, bin %u", done, count, unsigned{angle}, near->readings.size(), unsigned{battery->value}, unsigned{bin->value});
        m.idle(g.pause);
    }
    while (m.alarms().size() < g.alarms && !m.over()) m.idle(20);
    const auto& q = m.controller().quality();
    m.say("%zu of %zu boards, %lu rounds, %zu of %lu alarms, %d twice, %d values set anew; %llu retries, %llu time-outs, %llu resynchronisations, %llu bytes skipped, round trip %llu..%llu ms",
          m.controller().boards().size(), members - 1, done, m.alarms().size(), g.alarms, m.alarms_twice(), m.set_again(), static_cast<unsigned long long>(q.retries), static_cast<unsigned long long>(q.timeouts),
          static_cast<unsigned long long>(q.resynchronisations), static_cast<unsigned long long>(q.bytes_skipped), static_cast<unsigned long long>(q.round_trip.least), static_cast<unsigned long long>(q.round_trip.most));
    if (g.cycles == 0) return 0;  // no goal but the time
    const bool reached = done == g.cycles && m.alarms().size() >= g.alarms && m.alarms_twice() == 0;
    std::printf(reached ? "goal reached\n" : "goal missed\n");
    return reached ? 0 : 1;
}

int member(std::size_t i, ends& line, const goal& g) {
    switch (i) {
        case 0: return control(line, g);
        case 1: return live<motor_board>(line, 0);
        case 2: return live<servo_board>(line, 0);
        case 3: return live<distance_board>(line, 0);
        case 4: return live<battery_board>(line, g.alarms);
        default: return live<bin_board>(line, 0);
    }
}

}  // namespace

int main(int argc, char** argv) {
    options o("robot_ring: a robot's main controller and five boards, six processes in a ring of pseudo-terminals\n");
    o.add("seconds", "N", "stop after N seconds, 0: on Ctrl-C", "0");
    o.add("cycles", "N", "the goal: N rounds of setting and reading back; 0: no goal", "0");
    o.add("alarms", "N", "alarms that the battery raises, at most 1001", "5");
    o.add("pause", "MS", "milliseconds between rounds", "300");
    o.add("record", "DIR", "write what goes over each line to DIR/line_N.daisy");
    odds::add_to(o, "bytes");
    o.parse(argc, argv);
    catch_signals();

    const goal g{o.number("seconds"), o.number("cycles"), o.number("alarms", 0, first_alarm + 1), o.number("pause")};
    const odds faults = odds::of(o);
    const unsigned long seed = o.number("seed");
    std::array<line, members> lines;  // lines[i] goes from member i to the next one
    for (line& l : lines) l.open();
    family robot;
    for (std::size_t i = 0; i != members; ++i)
        robot.start(i == 0 ? "the controller" : "board " + std::to_string(i), [&] {
            const std::string record = o.has("record") ? o.text("record") + "/line_" + std::to_string(i) + ".daisy" : "";
            ends line(lines[(i + members - 1) % members], lines[i], faults, seed + i, record);
            return member(i, line, g);
        });
    // The controller's end is the end of all. A board has none of its own, and without it the others wait for ever.
    std::optional<int> outcome;
    const auto ended = [&](std::size_t i, int status) {
        const bool early = i == 0 ? status >= 2 : !outcome && stopped == 0;
        if (early) robot.complain(i, status);
        if (!outcome && (early || i == 0)) outcome = early && status != 2 ? 1 : status;
    };
    while (stopped == 0 && !outcome) {
        robot.look(ended);
        usleep(5000);
    }
    robot.end(ended);
    return finish(outcome.value_or(1));
}
