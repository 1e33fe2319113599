#pragma once
// A ring in memory: a controller, boards, and lines between them that can damage what they carry.

#include <deque>
#include <functional>
#include <memory>
#include <random>
#include <vector>

#include "trama/daisy/controller.hpp"
#include "trama/daisy/node.hpp"

namespace ring {

namespace daisy = trama::daisy;
using octets = std::vector<std::uint8_t>;

/// A board that remembers what it was told.
struct device {
    std::int32_t count = 0;
    int executed = 0;
    std::array<std::uint8_t, 5> positions{};

    daisy::answer operator()(const daisy::dc_motor::set_encoder& m, daisy::dc_motor::set_encoder_reply&) {
        count = m.count;
        return done();
    }
    daisy::answer operator()(const daisy::dc_motor::get_encoder&, daisy::dc_motor::get_encoder_reply& r) {
        r.count = count;
        return done();
    }
    daisy::answer operator()(const daisy::servo_motor::set_all_positions& m, daisy::servo_motor::set_all_positions_reply&) {
        positions = m.positions;
        return done();
    }
    daisy::answer operator()(const daisy::battery_controller::get_battery_value&, daisy::battery_controller::get_battery_value_reply& r) {
        r.value = 700;
        return done();
    }
    daisy::answer done() {
        ++executed;
        return daisy::answer::done;
    }
};

/// Carries bytes with a delay of one step; `damage` may change what it is given.
struct line {
    octets under_way, arrived;
    std::function<void(octets&)> damage;

    void send(std::span<const std::uint8_t> bytes) { under_way.insert(under_way.end(), bytes.begin(), bytes.end()); }
    void step() {
        if (damage && !under_way.empty()) damage(under_way);
        arrived.insert(arrived.end(), under_way.begin(), under_way.end());
        under_way.clear();
    }
};

/// controller → board 0 → board 1 → … → controller.
class ring {
public:
    using board = daisy::node<2, 32>;
    using controller = daisy::controller<4, 8>;

    explicit ring(const std::vector<daisy::address>& addresses, const daisy::timing& t = {}) : master(t), lines(addresses.size() + 1) {
        for (const daisy::address a : addresses) {
            boards.push_back(std::make_unique<board>(a, "board", t));
            devices.emplace_back();
        }
    }

    /// One unit of time: every line delivers, every member works. `heard` gets the controller's events.
    void step(const std::function<void(const daisy::controller_event&)>& heard) {
        for (line& l : lines) l.step();
        ++now;
        octets out(board::max_output);
        for (std::size_t i = 0; i != boards.size(); ++i) {
            const octets arrived = std::exchange(lines[i].arrived, {});
            for (std::span<const std::uint8_t> in(arrived);;) {
                const auto e = boards[i]->next(in, now, out, devices[i]);
                if (node_heard) node_heard(i, e);
                if (e.news == daisy::node_news::need_more) break;
                lines[i + 1].send(std::span(out).first(e.written));
            }
        }
        const octets arrived = std::exchange(lines.back().arrived, {});
        for (std::span<const std::uint8_t> in(arrived);;) {
            const auto e = master.next(in, now, out);
            if (e.news == daisy::controller_news::need_more) break;
            lines[0].send(std::span(out).first(e.written));
            heard(e);
        }
    }
    template <class M>
    bool ask(daisy::address to, const M& m) {
        octets out(daisy::max_packet);
        const auto size = master.request(to, m, now, out);
        if (size) lines[0].send(std::span(out).first(*size));
        return static_cast<bool>(size);
    }
    void call(std::size_t expected = 0) {
        octets out(daisy::max_packet);
        const auto size = master.initialise(now, out, expected);
        if (size) lines[0].send(std::span(out).first(*size));
    }
    /// Bytes anywhere on the ring.
    std::size_t under_way() const {
        std::size_t n = 0;
        for (const line& l : lines) n += l.under_way.size() + l.arrived.size();
        return n;
    }

    controller master;
    std::vector<std::unique_ptr<board>> boards;
    std::vector<device> devices;
    std::vector<line> lines;  ///< lines[i] ends at board i, the last one at the controller.
    std::function<void(std::size_t, const daisy::node_event&)> node_heard;
    std::uint64_t now = 0;
};

/// Damages on average one of `rarity` bytes, a packet's length apart: flips a bit, drops, doubles or inserts. Closer
/// together, two faults can cancel out in an XOR, and no state machine can tell.
inline std::function<void(octets&)> noise(std::mt19937& random, unsigned rarity) {
    return [&random, rarity, apart = 0U](octets& b) mutable {
        octets out;
        for (std::uint8_t c : b) {
            const auto fate = static_cast<unsigned>(random() % (4 * rarity));
            const bool damaged = fate < 4 && apart >= 24;
            apart = damaged ? 0 : apart + 1;
            if (damaged && fate == 0) c = static_cast<std::uint8_t>(c ^ 1U << random() % 8);
            if (damaged && fate == 1) continue;
            if (damaged && fate == 2) out.push_back(c);
            if (damaged && fate == 3) out.push_back(static_cast<std::uint8_t>(random()));
            out.push_back(c);
        }
        b = out;
    };
}

}  // namespace ring
