#pragma once

#include "trama/can/master_event.hpp"

namespace trama::can {

/// What happened at a node.
enum class sensor_node_news : std::uint8_t {
    need_more,  ///< Nothing; call again with more frames.
    executed,   ///< A request was carried out and answered.
    silent,     ///< A request was left unanswered: values out of range (`code` says so if one is no number), no such actuator, or no room in the queue.
    clock,      ///< The clock was set by a call to everyone.
    ignored,    ///< A message for others, or another node's reply.
    fault,      ///< Frames that make no message: `code`, `skipped`.
};

/// What `sensor_node::next` reports. Views live until the node's next call.
struct sensor_node_event {
    sensor_node_news news = sensor_node_news::need_more;
    can::packet packet{};         ///< Where a message came.
    errc code = errc::ok;         ///< Of fault; of silent, `bad_number` for a year that cannot be.
    std::uint64_t skipped = 0;    ///< Of fault: frames without use.
};

/// What a node measures and moves. `sensor_node` asks for these three.
template <class D>
concept node_device = requires(D d, std::uint8_t id, std::uint8_t& state) {
    { d.read(id) } -> std::convertible_to<std::uint8_t>;       // a sensor's value
    { d.set(id, id) } -> std::convertible_to<bool>;            // an actuator's new state; false: there is none
    { d.get(id, state) } -> std::convertible_to<bool>;         // an actuator's state; false: there is none
};

/// A node of a greenhouse: keeps the function that its master gave it, answers. [can §1..§5]
template <std::size_t Sensors = 4>
class sensor_node {
public:
    /// `self` is the node's number, `master` its master's identifier, `sensors` what it has. Of `t` it uses
    /// `second` and `partial`.
    constexpr sensor_node(std::uint8_t self, std::uint32_t master, const std::array<std::uint8_t, Sensors>& sensors, const timing& t = {}) noexcept
        : self_(self), master_(master), sensors_(sensors), reassembler_({central_master, master_1, master_2}, t.partial), calendar_(t.second) {
        if (master != central_master && master != master_1 && master != master_2) reassembler_ = basic_reassembler<3>({central_master, master, master_2}, t.partial);
        function_.function = function::sleep;
    }

    /// The frame to be sent next, null when there is none. It stays the next one until `sent`.
    constexpr const frame* front() noexcept { return queue_.front(); }
    /// That frame has left.
    constexpr void sent() noexcept {
        if (queue_.front() == nullptr) return;
        queue_.sent();
        line_.sent(1);
    }
    /// Takes frames from the front of `in` and deals with at most one message; `device` measures and moves.
    template <node_device Device>
    constexpr sensor_node_event next(std::span<const frame>& in, std::uint64_t now, Device& device) noexcept {
        if (in.empty()) reassembler_.tick(now);
        const event got = reassembler_.next(in);
        sensor_node_event e{};
        if (got.code == errc::ok) {
            line_.received(got.length, now);
            e.packet = got.packet;
            e.news = sensor_node_news::ignored;
            const error bad = visit<format>(got.packet, [&](const auto& m) { take(m, got.packet.envelope(), now, device, e); });
            if (bad && concerns(got.packet.body()[0], got.packet.body()[2] == 'C', got.packet.envelope())) {
                e.news = sensor_node_news::silent;
                e.code = bad.code;
            }
        } else if (got.code != errc::need_more) {
            e.news = sensor_node_news::fault;
            e.code = got.code;
            e.skipped = got.length;
            line_.lost_step(got.length);
        }
        return e;
    }

    /// The function that holds; `sleep` until one is defined.
    constexpr const define_function& function_in_force() const noexcept { return function_; }
    /// The sensors that are active now.
    constexpr active_sensors active(std::uint64_t now) const noexcept { return sensors_at(function_, sensors_, calendar_.at(now), calendar_.known()); }
    constexpr const can::calendar& clock() const noexcept { return calendar_; }
    constexpr const link_quality& quality() const noexcept { return line_; }

private:
    /// Whether a request is for this node: from its own master, or a clock that the central one sets.
    constexpr bool concerns(std::uint8_t node, bool clock, const envelope& from) const noexcept {
        const bool addressed = node == self_ || (clock && node == global_node);
        return addressed && (from.id == master_ || (clock && from.id == central_master));
    }
    template <class M>
    constexpr void take(const M& m, const envelope& from, std::uint64_t now, auto& device, sensor_node_event& e) noexcept {
        if constexpr (request_message<M>) {
            constexpr bool clock = std::is_same_v<M, set_clock>;
            const bool everyone = clock && m.node == global_node;
            if (!concerns(m.node, clock, from)) return;
            e.news = sensor_node_news::silent;
            if (!is_valid(m)) return;
            if (everyone) e.news = sensor_node_news::clock;
            if (execute(m, from, now, device) && !everyone) e.news = sensor_node_news::executed;
        }
    }
    constexpr bool answer(const auto& m, const envelope& to) noexcept { return !queue_.push_message(to, m); }

    constexpr bool execute(const define_function& m, const envelope& from, std::uint64_t, auto&) noexcept {
        function_ = m;
        return answer(m, from);
    }
    constexpr bool execute(const read_sensors& m, const envelope& from, std::uint64_t now, auto& device) noexcept {
        const active_sensors on = active(now);
        sensor_readings reply{m.node, m.message_id, on.count, {}};
        for (std::size_t i = 0; i != on.count; ++i) reply.readings[i] = {on.ids[i], device.read(on.ids[i])};
        return answer(reply, from);
    }
    constexpr bool execute(const read_actuator& m, const envelope& from, std::uint64_t, auto& device) noexcept {
        actuator_state reply{m.node, m.message_id, m.actuator, 0};
        return device.get(m.actuator, reply.state) && answer(reply, from);
    }
    constexpr bool execute(const set_actuator& m, const envelope& from, std::uint64_t, auto& device) noexcept {
        return device.set(m.actuator, m.state) && answer(m, from);
    }
    /// A call to everyone is not echoed by nodes: 99 says that it is the masters who answer. [can §5]
    constexpr bool execute(const set_clock& m, const envelope& from, std::uint64_t now, auto&) noexcept {
        calendar_.set({m.year, m.month, m.day, m.hour, m.minute, m.second}, now);
        return m.node == global_node || answer(m, from);
    }

    std::uint8_t self_;
    std::uint32_t master_;
    std::array<std::uint8_t, Sensors> sensors_;
    basic_reassembler<3> reassembler_;
    can::calendar calendar_;
    define_function function_{};
    transmit_queue<2> queue_{};
    link_quality line_{};
};

}  // namespace trama::can
