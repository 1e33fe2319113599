#pragma once
// The central master, a master with two nodes, and a bus on which a script loses, doubles and changes frames.
#include <optional>

#include "sessions/can_master.hpp"
#include "trama/can/sensor_node.hpp"

namespace trama::fuzz {

/// Sensors that say who they are and two actuators.
struct bed {
    std::uint8_t number = 0;
    std::array<std::uint8_t, 2> actuators{};

    std::uint8_t read(std::uint8_t sensor) const { return static_cast<std::uint8_t>(16 * number + sensor); }
    bool set(std::uint8_t actuator, std::uint8_t state) {
        if (actuator < actuators.size()) actuators[actuator] = state;
        return actuator < actuators.size();
    }
    bool get(std::uint8_t actuator, std::uint8_t& state) const {
        if (actuator < actuators.size()) state = actuators[actuator];
        return actuator < actuators.size();
    }
};

class can_session {
    using F = can::format;
    static constexpr std::size_t nodes = 2, members = nodes + 2;
    static constexpr can::timing patience{1000, 300, 60, 3, 30};

public:
    /// What is sent is printed where `print` says so, as a log; what becomes of it on the bus is not in it.
    can_session(std::span<const std::uint8_t> script, bool print) : d_(hash_of(script), script), print_(print) {
        for (std::uint8_t n = 1; n <= nodes && d_.one_in(2); ++n) master_.poll(n);
        for (std::uint8_t n = 0; n != nodes; ++n) beds_[n].number = n;
    }
    void run() {
        play(d_, [&] { step(); });
        settle();
    }

private:
    void step() {
        const std::size_t what = d_.below(16);
        if (what < 3) request();
        else if (what == 3) set_clocks();
        else if (what == 4) pass_time(now_, d_.one_in(8) ? 400 : d_.below(80), d_);
        else if (what == 5) hear_foreign();
        else if (what == 6) held_[d_.below(members)] = true;
        else (void)bus(true);
        everyone_hears({}, members);
        newest_ = std::max(newest_, now_);
    }

    void request() {
        F::messages::at(d_.below(F::messages::count), [&]<class M>() {
            if constexpr (can::request_message<M>) {
                arena memory;
                M m = random_message<M>(d_, memory);
                if (!d_.one_in(8)) m.node = static_cast<std::uint8_t>(1 + d_.below(nodes));
                if constexpr (requires { m.actuator; }) if (!d_.one_in(4)) m.actuator = static_cast<std::uint8_t>(d_.below(2));
                if (d_.one_in(8)) change_one_value(m, d_, memory);
                master_.ask(m);
            }
        });
    }
    void set_clocks() {
        arena memory;
        const auto m = random_message<can::set_clock>(d_, memory);
        central_.set_clocks({m.year, m.month, m.day, m.hour, m.minute, m.second});
    }
    const can::frame* front(std::size_t member) {
        return member < nodes ? nodes_[member].front() : member == nodes ? master_.machine().front() : central_.machine().front();
    }
    void left(std::size_t member) {
        if (member < nodes) nodes_[member].sent();
        else if (member == nodes) master_.machine().sent(now_);
        else central_.machine().sent(now_);
    }
    /// One frame goes over the bus: of those that want to send, one that the script chooses. A driver may hold one back; it must stay the same.
    /// False when nobody has anything to send.
    bool bus(bool rough) {
        const std::size_t turn = d_.below(members);
        for (std::size_t k = 0; k != members; ++k) {
            const std::size_t from = (turn + k) % members;
            const can::frame* next = front(from);
            if (next == nullptr) {
                require(!mailbox_[from].has_value(), "a frame that was looked at is there until it is sent");
                continue;
            }
            require(!mailbox_[from] || *mailbox_[from] == *next, "a frame that was looked at stays the next one");
            if (held_[from]) {
                mailbox_[from] = *next;
                held_[from] = false;
                continue;
            }
            can::frame f = *next;
            mailbox_[from].reset();
            left(from);
            now_ += rough ? d_.below(4) : 1;
            f.time = now_;
            watch(from, f);
            carry(f, from, rough ? d_.below(24) : 23);
            return true;
        }
        return false;
    }
    /// At once, since a broken property ends the program.
    void print(const can::frame& f) const {
        if (!print_) return;
        std::printf("%s\n", traits<F>::log_line(f).c_str());
        std::fflush(stdout);
    }
    /// Frames as their sender gave them are messages, whole and valid.
    void watch(std::size_t from, const can::frame& f) {
        print(f);
        const exact<can::frame> one(std::span<const can::frame>(&f, 1));
        std::span<const can::frame> in = one.all();
        const auto e = outlets_[from].next(in);
        require(e.code == errc::ok || e.code == errc::need_more, "what a member sends are whole messages");
        if (e.code != errc::ok) return;
        require(!visit<F>(e.packet, [](const auto& m) { require(is_valid(m), "what a member sends is valid"); }), "what a member sends loads");
        const std::uint8_t node = e.packet.body()[0];
        const bool clock = e.packet.body()[2] == 'C', central = e.packet.envelope().id == can::central_master;
        require(central || (e.packet.envelope().id == can::master_1 && from <= nodes), "members send under their own identifiers");
        if (from < nodes) require(node == from + 1 && (!central || clock), "a node answers for itself, under the central master's identifier its clock only");
        if (from == nodes && central) require(clock && node == can::global_node, "a master echoes everyone's clock");
    }
    void carry(can::frame f, std::size_t from, std::size_t fate) {
        if (fate == 0) return;
        if (fate == 1) f.data[d_.below(8)] ^= static_cast<std::uint8_t>(1U << d_.below(8));
        if (fate == 2) f.length = static_cast<std::uint8_t>(d_.below(16));
        const can::frame twice[] = {f, f};
        everyone_hears(std::span<const can::frame>(twice).first(fate == 3 ? 2 : 1), from, fate == 4 ? d_.below(members) : members);
    }
    /// A frame of anybody, of this protocol or not.
    void hear_foreign() {
        octets ten(10);
        for (auto& b : ten) b = static_cast<std::uint8_t>(d_.below(256));
        const can::frame f = traits<F>::frame_of(ten, now_);
        print(f);
        everyone_hears(std::span<const can::frame>(&f, 1), members);
    }
    void everyone_hears(std::span<const can::frame> frames, std::size_t but_for, std::size_t deaf = members) {
        for (std::size_t i = 0; i != members; ++i) {
            const exact<can::frame> copy(i == but_for || i == deaf ? std::span<const can::frame>{} : frames);
            std::span<const can::frame> in = copy.all();
            if (i < nodes) until_done([&] { return nodes_[i].next(in, now_, beds_[i]).news != can::sensor_node_news::need_more; }, 16);
            else if (i == nodes) until_done([&] { return master_.hear(in, now_); }, 32);
            else until_done([&] { return central_.hear(in, now_); }, 32);
            require(in.empty(), "need_more means that all frames are consumed");
        }
    }
    /// A good bus for as long as it takes; every request ends, and a new one is answered, whatever came before.
    void settle() {
        held_ = {};
        const auto turn = [&] {
            if (bus(false)) ++now_;
            else now_ = std::max(now_ + 10, newest_);  // or it would take long until their patience ends
            everyone_hears({}, members);
        };
        const auto quiet = [&](auto&& done) {
            for (int steps = 0; !done(); ++steps) {
                require(steps != 2000, "every request ends");
                turn();
            }
        };
        const auto idle = [&] { return master_.machine().waiting() == 0 && central_.machine().waiting() == 0; };
        quiet(idle);
        for (int turns = 30; turns != 0; --turns) turn();
        quiet(idle);  // a poll whose clock was set back may have begun before, and fails late
        const std::uint64_t failures = master_.machine().quality().failures;
        can::read_actuator m{};
        m.node = 1;
        master_.ask(m);
        quiet([&] { return master_.done(); });
        // A fault may still be told of what came before: of a partial message from before the clock was set back.
        require(master_.machine().quality().failures == failures, "on a good bus a request is answered, whatever came before");

        const std::uint64_t central_failures = central_.machine().quality().failures;
        central_.set_clocks({2011, 4, 1, 12, 20, 30});
        can::define_function all{};
        all.node = 1;
        all.function = can::function::continuous_all;
        master_.ask(all);
        master_.ask(can::read_sensors{1, 0});
        quiet([&] { return master_.done() && central_.done(); });
        require(master_.machine().quality().failures == failures && central_.machine().quality().failures == central_failures, "on a good bus clock and function are confirmed");
        for (const auto& n : nodes_) require(n.clock().known() && n.clock().at(now_) == master_.machine().clock().at(now_), "all have one time");
        const auto& read = master_.read_last();
        require(read.node == 1 && read.sensor_count == 4, "a node does what its function says");
        for (std::uint8_t i = 0; i != 4; ++i) require(read.readings[i] == can::reading{i, beds_[0].read(i)}, "a reading is what the node measures");
        master_.check();
        central_.check();
    }

    dice d_;
    bool print_;
    asking_master master_{can::master_1, patience, true};
    asking_master central_{can::central_master, patience, false};
    std::array<can::sensor_node<4>, nodes> nodes_{can::sensor_node<4>{1, can::master_1, {0, 1, 2, 3}, patience}, can::sensor_node<4>{2, can::master_1, {0, 1, 5, 7}, patience}};
    std::array<bed, nodes> beds_{};
    std::array<bool, members> held_{};  ///< Whose driver keeps its next frame back for a turn.
    std::array<std::optional<can::frame>, members> mailbox_{};
    std::array<can::reassembler, members> outlets_{};
    std::uint64_t now_ = 1, newest_ = 1;  ///< The latter: the latest time that there was.
};

}  // namespace trama::fuzz
